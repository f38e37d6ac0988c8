#include "vtkFaceToBoneFragmentWidget.h"

#include <Core/sculpting/line_of_sight.hpp>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkFaceToBoneFragmentWidget);

namespace
{

using Representation = vtkFaceToBoneFragmentRepresentation;

f2b::Vec3 ToVector(const std::array<double, 3>& p)
{
  return {p[0], p[1], p[2]};
}

} // namespace

vtkFaceToBoneFragmentWidget::vtkFaceToBoneFragmentWidget()
{
  this->On(Start, vtkCommand::MouseMoveEvent, [this] { return this->Hover(); });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->On(Dragging, vtkCommand::MouseMoveEvent, [this] { return this->Move(); });
  this->On(Dragging, vtkCommand::LeftButtonReleaseEvent, [this] { return this->Release(); });
  this->On(Dragging, vtkCommand::RightButtonPressEvent, [this] { return this->TakeBack(); });
  this->OnKey(Dragging, "Escape", [this] { return this->TakeBack(); });
}

vtkFaceToBoneFragmentWidget::~vtkFaceToBoneFragmentWidget() = default;

void vtkFaceToBoneFragmentWidget::SetRepresentation(Representation* representation)
{
  this->SetWidgetRepresentation(representation);
}

void vtkFaceToBoneFragmentWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
    this->WidgetRep = Representation::New();
}

Representation* vtkFaceToBoneFragmentWidget::GetFragmentRepresentation()
{
  return static_cast<Representation*>(this->GetRepresentation());
}

bool vtkFaceToBoneFragmentWidget::Hover()
{
  Representation* look = this->GetFragmentRepresentation();
  if (look->HighlightOnly(look->CoordinateAt(this->GetX(), this->GetY())))
    this->Render();
  return false;
}

bool vtkFaceToBoneFragmentWidget::Press()
{
  Representation* look = this->GetFragmentRepresentation();
  this->Held = look->CoordinateAt(this->GetX(), this->GetY());
  if (this->Held == Representation::None)
    return false;
  this->Before = look->GetMovement();
  this->Centre = look->MovedPoint();
  this->Axis = look->Axis(this->Held);
  this->PressX = this->GetX();
  this->PressY = this->GetY();
  this->WidgetState = Dragging;
  look->HighlightOnly(this->Held);
  look->ShowMovement(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  return true;
}

/// How far the cursor has taken the coordinate since the press [mm or degrees].
bool vtkFaceToBoneFragmentWidget::Reach(double& change)
{
  Representation* look = this->GetFragmentRepresentation();
  const f2b::LineOfSight then = look->LineAt(this->PressX, this->PressY);
  const f2b::LineOfSight now = look->LineAt(this->GetX(), this->GetY());
  const f2b::Vec3 centre = ToVector(this->Centre), axis = ToVector(this->Axis);
  if (this->Held < 3)
  {
    const auto from = f2b::along_axis(then, centre, axis), to = f2b::along_axis(now, centre, axis);
    if (!from || !to)
      return false;
    change = *to - *from;
    return true;
  }
  const auto from = f2b::on_plane(then, centre, axis), to = f2b::on_plane(now, centre, axis);
  if (!from || !to)
    return false;
  change = f2b::angle_about(centre, axis, *from, *to) * 180 / 3.14159265358979323846;
  return true;
}

bool vtkFaceToBoneFragmentWidget::Move()
{
  Representation* look = this->GetFragmentRepresentation();
  double change = 0;
  if (!this->Reach(change))
    return true;
  const auto k = static_cast<std::size_t>(this->Held);
  Representation::Coordinates movement = this->Before;
  movement[k] += change;
  if (this->IsControlDown())
    movement[k] = 0.5 * std::round(2 * movement[k]);
  movement[k] = look->Within(this->Held, movement[k]);
  look->SetMovement(movement);
  look->ShowMovement(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

bool vtkFaceToBoneFragmentWidget::Release()
{
  this->WidgetState = Start;
  this->GetFragmentRepresentation()->HideMovement();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

bool vtkFaceToBoneFragmentWidget::TakeBack()
{
  this->GetFragmentRepresentation()->SetMovement(this->Before);
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return this->Release();
}

void vtkFaceToBoneFragmentWidget::Cancel()
{
  if (this->WidgetState == Dragging)
    this->TakeBack();
  this->GetFragmentRepresentation()->HighlightOnly(Representation::None);
}

void vtkFaceToBoneFragmentWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Held: " << this->Held << "\n";
}
