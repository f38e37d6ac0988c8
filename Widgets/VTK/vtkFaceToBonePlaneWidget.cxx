#include "vtkFaceToBonePlaneWidget.h"

#include <Core/geometry/osteotomy.hpp>
#include <Core/sculpting/line_of_sight.hpp>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkFaceToBonePlaneWidget);

namespace
{

using Representation = vtkFaceToBonePlaneRepresentation;

f2b::Vec3 ToVector(const std::array<double, 3>& p)
{
  return {p[0], p[1], p[2]};
}

} // namespace

vtkFaceToBonePlaneWidget::vtkFaceToBonePlaneWidget() : Before(std::make_unique<f2b::BoundedPlane>())
{
  this->On(Start, vtkCommand::MouseMoveEvent, [this] { return this->Hover(); });
  this->On(Start, vtkCommand::LeaveEvent,
           [this]
           {
             if (this->GetPlaneRepresentation()->HighlightOnly(Representation::None))
               this->Render();
             return false;
           });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->On(Dragging, vtkCommand::MouseMoveEvent, [this] { return this->Move(); });
  this->On(Dragging, vtkCommand::LeftButtonReleaseEvent, [this] { return this->Release(); });
  this->On(Dragging, vtkCommand::RightButtonPressEvent, [this] { return this->TakeBack(); });
  this->OnKey(Dragging, "Escape", [this] { return this->TakeBack(); });
}

vtkFaceToBonePlaneWidget::~vtkFaceToBonePlaneWidget() = default;

void vtkFaceToBonePlaneWidget::SetRepresentation(Representation* representation)
{
  this->SetWidgetRepresentation(representation);
}

void vtkFaceToBonePlaneWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
    this->WidgetRep = Representation::New();
}

Representation* vtkFaceToBonePlaneWidget::GetPlaneRepresentation()
{
  return static_cast<Representation*>(this->GetRepresentation());
}

bool vtkFaceToBonePlaneWidget::Hover()
{
  Representation* look = this->GetPlaneRepresentation();
  const Representation::Handle handle = look->HandleAt(this->GetX(), this->GetY());
  if (look->HighlightOnly(handle))
    this->Render();
  return false; // another cut may be there, too
}

bool vtkFaceToBonePlaneWidget::Press()
{
  Representation* look = this->GetPlaneRepresentation();
  this->Held = look->HandleAt(this->GetX(), this->GetY());
  if (this->Held == Representation::None)
    return false;
  *this->Before = look->GetPlane();
  this->PressX = this->GetX();
  this->PressY = this->GetY();
  this->WidgetState = Dragging;
  look->HighlightOnly(this->Held);
  look->ShowSize(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  return true;
}

bool vtkFaceToBonePlaneWidget::Move()
{
  switch (this->Held)
  {
  case Representation::Face:
    this->MoveFace();
    break;
  case Representation::Centre:
    this->MoveCentre();
    break;
  case Representation::Normal:
    this->Tilt();
    break;
  default:
    this->MoveEdge();
  }
  this->GetPlaneRepresentation()->ShowSize(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

void vtkFaceToBonePlaneWidget::MoveFace()
{
  Representation* look = this->GetPlaneRepresentation();
  const f2b::Vec3 normal = this->Before->normal();
  const auto held =
      f2b::on_plane(look->LineAt(this->PressX, this->PressY), this->Before->center, normal);
  if (!held)
    return;
  const auto by = f2b::along_axis(look->LineAt(this->GetX(), this->GetY()), *held, normal);
  if (!by)
    return;
  f2b::BoundedPlane plane = *this->Before;
  plane.center += std::clamp(*by, -MostSize, MostSize) * normal;
  look->SetPlane(plane);
}

void vtkFaceToBonePlaneWidget::MoveCentre()
{
  Representation* look = this->GetPlaneRepresentation();
  const Representation::Point centre{this->Before->center.x(), this->Before->center.y(),
                                     this->Before->center.z()};
  f2b::BoundedPlane plane = *this->Before;
  plane.center += ToVector(look->WorldAtDepthOf(centre, this->GetX(), this->GetY())) -
                  ToVector(look->WorldAtDepthOf(centre, this->PressX, this->PressY));
  look->SetPlane(plane);
}

/// The normal follows the cursor as if its tip lay on a ball about the middle.
void vtkFaceToBonePlaneWidget::Tilt()
{
  Representation* look = this->GetPlaneRepresentation();
  const f2b::Vec3 normal = this->Before->normal();
  const double radius = 0.6 * std::min(this->Before->half_u, this->Before->half_v);
  const f2b::Vec3 tip = this->Before->center + radius * normal;
  const auto now = look->WorldAtDepthOf({tip.x(), tip.y(), tip.z()}, this->GetX(), this->GetY());
  const f2b::Vec3 wanted = ToVector(now) - this->Before->center;
  if (wanted.norm() < 1e-6)
    return;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(normal, wanted);
  f2b::BoundedPlane plane = *this->Before;
  plane.u = (turn * plane.u).normalized();
  plane.v = turn * plane.v;
  plane.v = (plane.v - plane.u.dot(plane.v) * plane.u).normalized();
  look->SetPlane(plane);
}

void vtkFaceToBonePlaneWidget::MoveEdge()
{
  Representation* look = this->GetPlaneRepresentation();
  const bool u = this->Held == Representation::EdgeU0 || this->Held == Representation::EdgeU1;
  const bool first = this->Held == Representation::EdgeU0 || this->Held == Representation::EdgeV0;
  f2b::BoundedPlane plane = *this->Before;
  const f2b::Vec3 outward = (first ? -1 : 1) * (u ? plane.u : plane.v);
  double& half = u ? plane.half_u : plane.half_v;
  const f2b::Vec3 opposite = plane.center - half * outward;
  const auto at = f2b::along_axis(look->LineAt(this->GetX(), this->GetY()), opposite, outward);
  if (!at)
    return;
  half = 0.5 * std::clamp(*at, LeastSize, MostSize);
  plane.center = opposite + half * outward;
  look->SetPlane(plane);
}

bool vtkFaceToBonePlaneWidget::Release()
{
  this->WidgetState = Start;
  this->GetPlaneRepresentation()->HideSize();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

bool vtkFaceToBonePlaneWidget::TakeBack()
{
  this->GetPlaneRepresentation()->SetPlane(*this->Before);
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return this->Release();
}

void vtkFaceToBonePlaneWidget::Cancel()
{
  if (this->WidgetState == Dragging)
    this->TakeBack();
  this->GetPlaneRepresentation()->HighlightOnly(Representation::None);
}

void vtkFaceToBonePlaneWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Held: " << this->Held << "\n";
}
