#ifndef vtkFaceToBonePointsWidget_h
#define vtkFaceToBonePointsWidget_h

#include "vtkFaceToBonePointsRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

/// How does the mouse place points on what is seen, and move them?
///
/// | state    | event                         | action                                            |
/// |----------|-------------------------------|---------------------------------------------------|
/// | Start    | mouse move                    | highlights the point under the cursor             |
/// | Start    | left press on a point         | takes hold of it -> Dragging                      |
/// | Start    | left press on a surface       | places a point, while fewer than wanted           |
/// | Start    | left press elsewhere          | none: the camera turns                            |
/// | Start    | key BackSpace                 | takes the last point back, while fewer than wanted|
/// | Start    | key Escape                    | takes them all back, while fewer than wanted      |
/// | Dragging | mouse move                    | along the surface, or in the plane of the picture |
/// | Dragging | left release                  | -> Start                                          |
/// | Dragging | key Escape, right press       | back to where it was -> Start                     |
///
/// Invokes PlacePointEvent for a placed point; StartInteractionEvent, InteractionEvent and
/// EndInteractionEvent for each drag.
class vtkFaceToBonePointsWidget : public vtkFaceToBoneToolWidget
{
public:
  static vtkFaceToBonePointsWidget* New();
  vtkTypeMacro(vtkFaceToBonePointsWidget,
               vtkFaceToBoneToolWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Dragging = Start + 1,
  };

  void CreateDefaultRepresentation() override;
  vtkFaceToBonePointsRepresentation* GetPointsRepresentation();

  vtkSetMacro(Wanted, int); ///< how many points may be placed by clicking; 0: none
  vtkGetMacro(Wanted, int);
  vtkSetMacro(OnSurface, bool); ///< whether dragged points stay on surfaces
  vtkGetMacro(Held, int);       ///< the point of the last drag
  /// From where the drag began [mm, RAS].
  std::array<double, 3> GetDragged();

  vtkFaceToBonePointsWidget(const vtkFaceToBonePointsWidget&) = delete;
  void operator=(const vtkFaceToBonePointsWidget&) = delete;

protected:
  vtkFaceToBonePointsWidget();
  ~vtkFaceToBonePointsWidget() override;
  void Cancel() override;

private:
  bool IsPlacing();
  bool Hover();
  bool Press();
  bool Move();
  bool Release();
  bool TakeBack();
  bool Unplace(bool all);

  int Wanted = 0, Held = vtkFaceToBonePointsRepresentation::None;
  bool OnSurface = true;
  std::array<double, 3> From{};
};

#endif
