#ifndef vtkFaceToBoneSawWidget_h
#define vtkFaceToBoneSawWidget_h

#include "vtkFaceToBoneSawRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

/// How is a saw turned, and how deep does it go?
///
/// | state    | event                     | action                                                |
/// |----------|---------------------------|-------------------------------------------------------|
/// | Start    | mouse move                | highlights what is under the cursor                   |
/// | Start    | left press on a ball      | takes hold of it -> Dragging                          |
/// | Start    | left press beside         | none: the camera turns                                |
/// | Start    | leave                     | nothing is highlighted                                |
/// | Dragging | mouse move                | Hand: turns about the line's middle; Depth: sets it   |
/// | Dragging | left release              | lets go -> Start                                      |
/// | Dragging | key Escape, right press   | as before the press -> Start                          |
///
/// Invokes StartInteractionEvent, InteractionEvent (the saw has changed), EndInteractionEvent.
class vtkFaceToBoneSawWidget : public vtkFaceToBoneToolWidget
{
public:
  static vtkFaceToBoneSawWidget* New();
  vtkTypeMacro(vtkFaceToBoneSawWidget,
               vtkFaceToBoneToolWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Dragging = Start + 1,
  };
  static constexpr double LeastDepth = 1, MostDepth = 200; ///< [mm]

  void SetRepresentation(vtkFaceToBoneSawRepresentation* representation);
  void CreateDefaultRepresentation() override;
  vtkFaceToBoneSawRepresentation* GetSawRepresentation();

  vtkFaceToBoneSawWidget(const vtkFaceToBoneSawWidget&) = delete;
  void operator=(const vtkFaceToBoneSawWidget&) = delete;

protected:
  vtkFaceToBoneSawWidget();
  ~vtkFaceToBoneSawWidget() override;
  void Cancel() override;

private:
  bool Hover(vtkFaceToBoneSawRepresentation::Handle handle);
  bool Press();
  bool Move();
  bool Release();
  bool TakeBack();

  vtkFaceToBoneSawRepresentation::Handle Held = vtkFaceToBoneSawRepresentation::None;
  vtkFaceToBoneSawRepresentation::Point DirectionBefore{};
  double LeadBefore = 0, DepthBefore = 0;
};

#endif
