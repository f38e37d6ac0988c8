#ifndef vtkFaceToBoneFragmentWidget_h
#define vtkFaceToBoneFragmentWidget_h

#include "vtkFaceToBoneFragmentRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

/// How is a fragment moved by the mouse, one coordinate at a time?
///
/// | state    | event                      | action                                               |
/// |----------|----------------------------|------------------------------------------------------|
/// | Start    | mouse move                 | highlights the arrow or ring under the cursor        |
/// | Start    | left press on one          | takes hold of it -> Dragging                         |
/// | Start    | left press beside          | none: the camera turns                               |
/// | Dragging | mouse move                 | arrow: shifts along it; ring: turns about its axis;  |
/// |          |                            | with control in steps of 0.5 mm or 0.5 degrees       |
/// | Dragging | left release               | lets go -> Start                                     |
/// | Dragging | key Escape, right press    | as before the press -> Start                         |
///
/// Locked coordinates cannot be taken hold of, others do not leave the representation's limits. Invokes StartInteractionEvent, InteractionEvent (the
/// movement has changed), EndInteractionEvent.
class vtkFaceToBoneFragmentWidget : public vtkFaceToBoneToolWidget
{
public:
  static vtkFaceToBoneFragmentWidget* New();
  vtkTypeMacro(vtkFaceToBoneFragmentWidget,
               vtkFaceToBoneToolWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Dragging = Start + 1,
  };

  void SetRepresentation(vtkFaceToBoneFragmentRepresentation* representation);
  void CreateDefaultRepresentation() override;
  vtkFaceToBoneFragmentRepresentation* GetFragmentRepresentation();

  vtkFaceToBoneFragmentWidget(const vtkFaceToBoneFragmentWidget&) = delete;
  void operator=(const vtkFaceToBoneFragmentWidget&) = delete;

protected:
  vtkFaceToBoneFragmentWidget();
  ~vtkFaceToBoneFragmentWidget() override;
  void Cancel() override;

private:
  bool Hover();
  bool Press();
  bool Move();
  bool Release();
  bool TakeBack();
  bool Reach(double& change);

  int Held = vtkFaceToBoneFragmentRepresentation::None;
  vtkFaceToBoneFragmentRepresentation::Coordinates Before{};
  vtkFaceToBoneFragmentRepresentation::Point Centre{}, Axis{}; ///< when it was taken hold of
  int PressX = 0, PressY = 0;
};

#endif
