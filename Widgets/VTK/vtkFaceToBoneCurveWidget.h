#ifndef vtkFaceToBoneCurveWidget_h
#define vtkFaceToBoneCurveWidget_h

#include "vtkFaceToBoneCurveRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

/// How is a cut drawn on the bone?
///
/// | state    | event                                | action                                      |
/// |----------|--------------------------------------|---------------------------------------------|
/// | Start    | mouse move                           | highlights the point under the cursor       |
/// | Start    | left press on the bone               | adds a point -> Dragging it                 |
/// | Start    | left press on the first of three     | closes the line -> Dragging that point      |
/// |          | points or more                       |                                             |
/// | Start    | left press on another point          | takes hold of it -> Dragging                |
/// | Start    | shift + left press on the bone       | draws by hand -> Freehand                   |
/// | Start    | left press beside the bone           | none: the camera turns                      |
/// | Start    | key BackSpace, Delete                | removes the last point                      |
/// | Start    | key Return, double click             | the line is finished: EndInteractionEvent   |
/// | Dragging | mouse move                           | the point follows on the bone               |
/// | Dragging | left release                         | lets go -> Start                            |
/// | Dragging | key Escape, right press              | the point as before the press -> Start      |
/// | Freehand | mouse move                           | a point every 4 mm                          |
/// | Freehand | left release                         | ends the stroke -> Start                    |
/// | Freehand | key Escape, right press              | takes the stroke's points back -> Start     |
///
/// Invokes InteractionEvent whenever the line has changed.
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
  };
  static constexpr double FreehandSpacingMm = 4;

  void SetRepresentation(vtkFaceToBoneCurveRepresentation* representation);
  void CreateDefaultRepresentation() override;
  vtkFaceToBoneCurveRepresentation* GetCurveRepresentation();

  vtkFaceToBoneCurveWidget(const vtkFaceToBoneCurveWidget&) = delete;
  void operator=(const vtkFaceToBoneCurveWidget&) = delete;

protected:
  vtkFaceToBoneCurveWidget();
  ~vtkFaceToBoneCurveWidget() override;
  void Cancel() override;

private:
  bool Hover();
  bool Press();
  bool DragPoint();
  bool DrawOn();
  bool Release();
  bool TakeBack();
  bool RemoveLast();
  bool Finish();
  bool Changed();

  int Held = vtkFaceToBoneCurveRepresentation::None;
  int CountBefore = 0; ///< of points, before the press
  bool ClosedBefore = false;
  std::unique_ptr<f2b::SurfacePlace> PlaceBefore;
};

#endif
