#include "vtkFaceToBoneSculptWidget.h"

#include "vtkFaceToBoneSculptRepresentation.h"

#include <Core/sculpting/sculpting_session.hpp>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkFaceToBoneSculptWidget);

namespace
{

f2b::Vec3 ToVector(const std::array<double, 3>& p)
{
  return {p[0], p[1], p[2]};
}

} // namespace

vtkFaceToBoneSculptWidget::vtkFaceToBoneSculptWidget()
    : Brush(std::make_unique<f2b::Brush>()), Held(std::make_unique<f2b::Brush>())
{
  constexpr double step = 1.15;
  this->On(Start, vtkCommand::MouseMoveEvent, [this] { return this->Hover(); });
  this->On(Start, vtkCommand::LeaveEvent, [this] { return this->Leave(); });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->On(Start, vtkCommand::MouseWheelForwardEvent, [this] { return this->Wheel(step); });
  this->On(Start, vtkCommand::MouseWheelBackwardEvent, [this] { return this->Wheel(1 / step); });
  this->OnKey(Start, "bracketleft", [this] { return this->ScaleRadius(1 / step); });
  this->OnKey(Start, "bracketright", [this] { return this->ScaleRadius(step); });
  this->OnKey(Start, "braceleft", [this] { return this->ScaleStrength(1 / step); });
  this->OnKey(Start, "braceright", [this] { return this->ScaleStrength(step); });
  this->On(Sculpting, vtkCommand::MouseMoveEvent, [this] { return this->Move(); });
  this->On(Sculpting, vtkCommand::LeftButtonReleaseEvent, [this] { return this->Release(); });
  this->On(Sculpting, vtkCommand::RightButtonPressEvent, [this] { return this->TakeBack(); });
  this->OnKey(Sculpting, "Escape", [this] { return this->TakeBack(); });
}

vtkFaceToBoneSculptWidget::~vtkFaceToBoneSculptWidget() = default;

void vtkFaceToBoneSculptWidget::SetRepresentation(vtkFaceToBoneSculptRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
}

void vtkFaceToBoneSculptWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
    this->WidgetRep = vtkFaceToBoneSculptRepresentation::New();
}

vtkFaceToBoneSculptRepresentation* vtkFaceToBoneSculptWidget::GetSculptRepresentation()
{
  return static_cast<vtkFaceToBoneSculptRepresentation*>(this->GetRepresentation());
}

void vtkFaceToBoneSculptWidget::SetBrush(const f2b::Brush& brush)
{
  *this->Brush = brush;
  this->Brush->radius_mm =
      std::clamp(brush.radius_mm, f2b::Brush::least_radius_mm, f2b::Brush::most_radius_mm);
  this->Brush->strength = std::clamp(brush.strength, 0.02, 1.0);
  this->Modified();
}

bool vtkFaceToBoneSculptWidget::Hover()
{
  vtkFaceToBoneSculptRepresentation* shown = this->GetSculptRepresentation();
  const bool before = shown->IsBrushShown();
  shown->ShowBrush(*this->Brush, this->GetX(), this->GetY());
  // others may want a move too: it is only looked at
  if (before || shown->IsBrushShown())
    this->Render();
  return false;
}

bool vtkFaceToBoneSculptWidget::Leave()
{
  this->GetSculptRepresentation()->HideBrush();
  this->Render();
  return false;
}

bool vtkFaceToBoneSculptWidget::Press()
{
  vtkFaceToBoneSculptRepresentation* shown = this->GetSculptRepresentation();
  const auto place = shown->PlaceAt(this->GetX(), this->GetY());
  if (!place)
    return false;
  *this->Held = *this->Brush;
  if (this->IsShiftDown())
    this->Held->kind = f2b::BrushKind::Smooth;
  else if (this->IsControlDown() && this->Held->kind == f2b::BrushKind::Mask)
    this->Held->kind = f2b::BrushKind::Unmask;
  else if (this->IsControlDown())
    this->Held->inverted = !this->Held->inverted;
  const auto ray = shown->GetRay(this->GetX(), this->GetY());
  this->Grabbed = {place->point.x(), place->point.y(), place->point.z()};
  this->Last = {double(this->GetX()), double(this->GetY())};
  this->WidgetState = Sculpting;
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  shown->GetSession()->begin_stroke(*this->Held, *place, ToVector(ray.Direction));
  shown->UpdateShown();
  shown->ShowBrush(*this->Held, this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

/// Dabs every quarter of the radius from the last one, so that a quick stroke has no gaps.
void vtkFaceToBoneSculptWidget::DabUntil(double x, double y)
{
  constexpr double share = 0.25;
  vtkFaceToBoneSculptRepresentation* shown = this->GetSculptRepresentation();
  const double pixels =
      std::max(1.0, share * this->Held->radius_mm / shown->MillimetresPerPixel(this->Grabbed));
  const double dx = x - this->Last[0], dy = y - this->Last[1];
  const double length = std::hypot(dx, dy);
  const int count = std::min(200, static_cast<int>(length / pixels));
  for (int k = 1; k <= count; ++k)
  {
    const std::array<double, 2> at{this->Last[0] + dx * pixels * k / length,
                                   this->Last[1] + dy * pixels * k / length};
    if (const auto place = shown->PlaceAt(at[0], at[1]))
      shown->GetSession()->dab(*place);
    if (k == count)
      this->Last = at;
  }
}

bool vtkFaceToBoneSculptWidget::Move()
{
  vtkFaceToBoneSculptRepresentation* shown = this->GetSculptRepresentation();
  f2b::SculptingSession* session = shown->GetSession();
  if (!session || !session->in_stroke()) // the host has given us another skin
  {
    this->WidgetState = Start;
    return true;
  }
  if (this->Held->drags())
  {
    const auto now = shown->WorldAtDepthOf(this->Grabbed, this->GetX(), this->GetY());
    session->drag(ToVector(now) - ToVector(this->Grabbed));
    shown->UpdateShown();
    shown->ShowHeldBrush(*this->Held, now, this->GetX(), this->GetY());
  }
  else
  {
    this->DabUntil(this->GetX(), this->GetY());
    shown->UpdateShown();
    shown->ShowBrush(*this->Held, this->GetX(), this->GetY());
  }
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

void vtkFaceToBoneSculptWidget::End()
{
  this->WidgetState = Start;
  this->GetSculptRepresentation()->UpdateShown();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
}

bool vtkFaceToBoneSculptWidget::Release()
{
  if (f2b::SculptingSession* session = this->GetSculptRepresentation()->GetSession())
    session->end_stroke();
  this->End();
  return true;
}

bool vtkFaceToBoneSculptWidget::TakeBack()
{
  if (f2b::SculptingSession* session = this->GetSculptRepresentation()->GetSession())
    session->cancel_stroke();
  this->End();
  return true;
}

void vtkFaceToBoneSculptWidget::Cancel()
{
  if (this->WidgetState == Sculpting)
    this->TakeBack();
  this->GetSculptRepresentation()->HideBrush();
}

bool vtkFaceToBoneSculptWidget::Wheel(double factor)
{
  if (this->IsShiftDown())
    return this->ScaleRadius(factor);
  if (this->IsControlDown())
    return this->ScaleStrength(factor);
  return false;
}

bool vtkFaceToBoneSculptWidget::ScaleRadius(double factor)
{
  f2b::Brush brush = *this->Brush;
  brush.radius_mm *= factor;
  this->SetBrush(brush);
  this->GetSculptRepresentation()->ShowBrush(*this->Brush, this->GetX(), this->GetY());
  return true;
}

bool vtkFaceToBoneSculptWidget::ScaleStrength(double factor)
{
  f2b::Brush brush = *this->Brush;
  brush.strength *= factor;
  this->SetBrush(brush);
  this->GetSculptRepresentation()->ShowBrush(*this->Brush, this->GetX(), this->GetY());
  return true;
}

void vtkFaceToBoneSculptWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Brush->radius_mm << " mm\n";
}
