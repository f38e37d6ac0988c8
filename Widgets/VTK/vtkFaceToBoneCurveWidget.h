#ifndef vtkFaceToBoneCurveWidget_h
#define vtkFaceToBoneCurveWidget_h

#include "vtkFaceToBoneCurveRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

/// How is a cut drawn on the bone, and how are its points moved afterwards?
///
/// | state    | event                                | action                                      |
/// |----------|--------------------------------------|---------------------------------------------|
/// | Start    | mouse move                           | highlights the point under the cursor       |
/// | Start    | left press on the bone *             | adds a point -> Dragging it                 |
/// | Start    | left press on the first of three     | closes the line -> Dragging that point      |
/// |          | points or more *                     |                                             |
/// | Start    | left press on another point          | takes hold of it -> Dragging                |
/// | Start    | left press on a free line            | takes hold of the whole line -> Shifting    |
/// | Start    | shift + left press on the bone *     | draws by hand -> Freehand                   |
/// | Start    | left press beside the bone           | none: the camera turns                      |
/// | Start    | key BackSpace, Delete *              | removes the last point                      |
/// | Start    | key Return, double click *           | the line is finished: EndInteractionEvent   |
/// | Dragging | mouse move                           | the point follows on the bone; a free one   |
/// |          |                                      | in the picture's plane                      |
/// | Shifting | mouse move                           | the line follows in the picture's plane     |
/// | Freehand | mouse move                           | a point every 4 mm                          |
/// | others   | left release                         | lets go, ends the stroke -> Start           |
/// | others   | key Escape, right press              | as before the press -> Start                |
///
/// What has a star is done only while it draws (SetDrawing); a line that is there is left as it is
/// but for its points. Invokes StartInteractionEvent at a press, InteractionEvent whenever the line
/// has changed and, where it does not draw, EndInteractionEvent when a point is let go.
class vtkFaceToBoneCurveWidget : public vtkFaceToBoneToolWidget
{
public:
  static vtkFaceToBoneCurveWidget* New();
  vtkTypeMacro(vtkFaceToBoneCurveWidget,
               vtkFaceToBoneToolWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Dragging = Start + 1,
    Freehand,
    Shifting,
  };
  static constexpr double FreehandSpacingMm = 4;

  void SetRepresentation(vtkFaceToBoneCurveRepresentation* representation);
  void CreateDefaultRepresentation() override;
  vtkFaceToBoneCurveRepresentation* GetCurveRepresentation();
  /// Whether presses add points; on at first.
  vtkSetMacro(Drawing, bool);
  vtkGetMacro(Drawing, bool);

  vtkFaceToBoneCurveWidget(const vtkFaceToBoneCurveWidget&) = delete;
  void operator=(const vtkFaceToBoneCurveWidget&) = delete;

protected:
  vtkFaceToBoneCurveWidget();
  ~vtkFaceToBoneCurveWidget() override;
  void Cancel() override;

private:
  bool Hover();
  bool Press();
  bool PressOnPoint();
  bool PressBesidePoints();
  bool Begin(int state);
  bool DragPoint();
  bool DrawOn();
  bool ShiftLine();
  bool Release();
  bool TakeBack();
  bool RemoveLast();
  bool Finish();
  bool Changed();

  int Held = vtkFaceToBoneCurveRepresentation::None;
  bool Drawing = true;
  int LastX = 0, LastY = 0; ///< of the cursor, while it shifts
  std::shared_ptr<const vtkFaceToBoneCurveRepresentation::State> Before; ///< before the press
};

#endif
