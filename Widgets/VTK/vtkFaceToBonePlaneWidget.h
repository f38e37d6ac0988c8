#ifndef vtkFaceToBonePlaneWidget_h
#define vtkFaceToBonePlaneWidget_h

#include "vtkFaceToBonePlaneRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

/// How is a cut shifted, tilted and sized by the mouse?
///
/// | state    | event                     | action                                                |
/// |----------|---------------------------|-------------------------------------------------------|
/// | Start    | mouse move                | highlights what is under the cursor                   |
/// | Start    | left press on a handle    | takes hold of it -> Dragging                          |
/// | Start    | left press beside         | none: the camera turns                                |
/// | Start    | leave                     | nothing is highlighted                                |
/// | Dragging | mouse move                | Face: along the normal; Centre: in the picture's      |
/// |          |                           | plane; Normal: tilts about the middle; an edge: moves |
/// |          |                           | in the plane, the opposite edge stays                 |
/// | Dragging | left release              | lets go -> Start                                      |
/// | Dragging | key Escape, right press   | as before the press -> Start                          |
///
/// Invokes StartInteractionEvent, InteractionEvent (the plane has changed), EndInteractionEvent.
class vtkFaceToBonePlaneWidget : public vtkFaceToBoneToolWidget
{
public:
  static vtkFaceToBonePlaneWidget* New();
  vtkTypeMacro(vtkFaceToBonePlaneWidget,
               vtkFaceToBoneToolWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Dragging = Start + 1,
  };
  static constexpr double LeastSize = 2, MostSize = 300; ///< of an edge [mm]

  void SetRepresentation(vtkFaceToBonePlaneRepresentation* representation);
  void CreateDefaultRepresentation() override;
  vtkFaceToBonePlaneRepresentation* GetPlaneRepresentation();

  vtkFaceToBonePlaneWidget(const vtkFaceToBonePlaneWidget&) = delete;
  void operator=(const vtkFaceToBonePlaneWidget&) = delete;

protected:
  vtkFaceToBonePlaneWidget();
  ~vtkFaceToBonePlaneWidget() override;
  void Cancel() override;

private:
  bool Hover();
  bool Press();
  bool Move();
  bool Release();
  bool TakeBack();
  void MoveFace();
  void MoveCentre();
  void Tilt();
  void MoveEdge();

  vtkFaceToBonePlaneRepresentation::Handle Held = vtkFaceToBonePlaneRepresentation::None;
  std::unique_ptr<f2b::BoundedPlane> Before; ///< when it was taken hold of
  int PressX = 0, PressY = 0;
};

#endif
