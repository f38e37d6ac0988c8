#include "vtkFaceToBonePointsWidget.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkFaceToBonePointsWidget);

vtkFaceToBonePointsWidget::vtkFaceToBonePointsWidget()
{
  this->On(Start, vtkCommand::MouseMoveEvent, [this] { return this->Hover(); });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->OnKey(Start, "BackSpace", [this] { return this->Unplace(false); });
  this->OnKey(Start, "Escape", [this] { return this->Unplace(true); });
  this->On(Dragging, vtkCommand::MouseMoveEvent, [this] { return this->Move(); });
  this->On(Dragging, vtkCommand::LeftButtonReleaseEvent, [this] { return this->Release(); });
  this->On(Dragging, vtkCommand::RightButtonPressEvent, [this] { return this->TakeBack(); });
  this->OnKey(Dragging, "Escape", [this] { return this->TakeBack(); });
}

vtkFaceToBonePointsWidget::~vtkFaceToBonePointsWidget() = default;

void vtkFaceToBonePointsWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
    this->WidgetRep = vtkFaceToBonePointsRepresentation::New();
}

vtkFaceToBonePointsRepresentation* vtkFaceToBonePointsWidget::GetPointsRepresentation()
{
  return static_cast<vtkFaceToBonePointsRepresentation*>(this->GetRepresentation());
}

bool vtkFaceToBonePointsWidget::IsPlacing()
{
  return static_cast<int>(this->GetPointsRepresentation()->GetPoints().size()) < this->Wanted;
}

std::array<double, 3> vtkFaceToBonePointsWidget::GetDragged()
{
  const auto& points = this->GetPointsRepresentation()->GetPoints();
  if (this->Held < 0 || this->Held >= static_cast<int>(points.size()))
    return {};
  const auto& now = points[static_cast<std::size_t>(this->Held)];
  return {now[0] - this->From[0], now[1] - this->From[1], now[2] - this->From[2]};
}

bool vtkFaceToBonePointsWidget::Hover()
{
  vtkFaceToBonePointsRepresentation* shown = this->GetPointsRepresentation();
  const vtkMTimeType before = shown->GetMTime();
  shown->Highlight(shown->PointAt(this->GetX(), this->GetY()));
  if (shown->GetMTime() != before)
    this->Render();
  return false; // others may want a move too
}

bool vtkFaceToBonePointsWidget::Press()
{
  vtkFaceToBonePointsRepresentation* shown = this->GetPointsRepresentation();
  this->Held = shown->PointAt(this->GetX(), this->GetY());
  if (this->Held != vtkFaceToBonePointsRepresentation::None)
  {
    this->From = shown->GetPoints()[static_cast<std::size_t>(this->Held)];
    this->WidgetState = Dragging;
    shown->Highlight(this->Held);
    this->InvokeEvent(vtkCommand::StartInteractionEvent);
    return true;
  }
  if (!this->IsPlacing())
    return false;
  const auto place = shown->SurfaceAt(this->GetX(), this->GetY());
  if (!place)
    return false;
  auto points = shown->GetPoints();
  points.push_back(*place);
  shown->SetPoints(points);
  this->InvokeEvent(vtkCommand::PlacePointEvent);
  return true;
}

bool vtkFaceToBonePointsWidget::Move()
{
  vtkFaceToBonePointsRepresentation* shown = this->GetPointsRepresentation();
  if (this->Held >= static_cast<int>(shown->GetPoints().size())) // the host has taken it away
  {
    this->WidgetState = Start;
    return true;
  }
  if (!this->OnSurface)
    shown->SetPoint(this->Held, shown->WorldAtDepthOf(this->From, this->GetX(), this->GetY()));
  else if (const auto place = shown->SurfaceAt(this->GetX(), this->GetY()))
    shown->SetPoint(this->Held, *place);
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

bool vtkFaceToBonePointsWidget::Release()
{
  this->WidgetState = Start;
  this->GetPointsRepresentation()->ShowText("", 0, 0);
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

bool vtkFaceToBonePointsWidget::TakeBack()
{
  vtkFaceToBonePointsRepresentation* shown = this->GetPointsRepresentation();
  if (this->Held < static_cast<int>(shown->GetPoints().size()))
  {
    shown->SetPoint(this->Held, this->From);
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
  return this->Release();
}

bool vtkFaceToBonePointsWidget::Unplace(bool all)
{
  vtkFaceToBonePointsRepresentation* shown = this->GetPointsRepresentation();
  auto points = shown->GetPoints();
  if (!this->IsPlacing() || points.empty())
    return false;
  points.resize(all ? 0 : points.size() - 1);
  shown->SetPoints(points);
  return true;
}

void vtkFaceToBonePointsWidget::Cancel()
{
  if (this->WidgetState == Dragging)
    this->TakeBack();
  this->GetPointsRepresentation()->Highlight(vtkFaceToBonePointsRepresentation::None);
}

void vtkFaceToBonePointsWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wanted: " << this->Wanted << "\n";
}
