#include "vtkFaceToBoneCurveWidget.h"

#include <Core/sculpting/surface_tree.hpp>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkFaceToBoneCurveWidget);

using Representation = vtkFaceToBoneCurveRepresentation;

vtkFaceToBoneCurveWidget::vtkFaceToBoneCurveWidget()
    : PlaceBefore(std::make_unique<f2b::SurfacePlace>())
{
  this->On(Start, vtkCommand::MouseMoveEvent, [this] { return this->Hover(); });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->On(Start, vtkCommand::LeftButtonDoubleClickEvent, [this] { return this->Finish(); });
  this->OnKey(Start, "Return", [this] { return this->Finish(); });
  this->OnKey(Start, "BackSpace", [this] { return this->RemoveLast(); });
  this->OnKey(Start, "Delete", [this] { return this->RemoveLast(); });
  this->On(Dragging, vtkCommand::MouseMoveEvent, [this] { return this->DragPoint(); });
  this->On(Freehand, vtkCommand::MouseMoveEvent, [this] { return this->DrawOn(); });
  for (const int state : {int(Dragging), int(Freehand)})
  {
    this->On(state, vtkCommand::LeftButtonReleaseEvent, [this] { return this->Release(); });
    this->On(state, vtkCommand::RightButtonPressEvent, [this] { return this->TakeBack(); });
    this->OnKey(state, "Escape", [this] { return this->TakeBack(); });
  }
}

vtkFaceToBoneCurveWidget::~vtkFaceToBoneCurveWidget() = default;

void vtkFaceToBoneCurveWidget::SetRepresentation(Representation* representation)
{
  this->SetWidgetRepresentation(representation);
}

void vtkFaceToBoneCurveWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
    this->WidgetRep = Representation::New();
}

Representation* vtkFaceToBoneCurveWidget::GetCurveRepresentation()
{
  return static_cast<Representation*>(this->GetRepresentation());
}

bool vtkFaceToBoneCurveWidget::Changed()
{
  this->GetCurveRepresentation()->ShowLength(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

bool vtkFaceToBoneCurveWidget::Hover()
{
  Representation* look = this->GetCurveRepresentation();
  look->Highlight(look->ControlPointAt(this->GetX(), this->GetY()));
  this->Render();
  return false;
}

bool vtkFaceToBoneCurveWidget::Press()
{
  Representation* look = this->GetCurveRepresentation();
  if (!look->HasSurface())
    return false;
  this->CountBefore = look->GetNumberOfControlPoints();
  this->ClosedBefore = look->GetClosed();
  this->Held = look->ControlPointAt(this->GetX(), this->GetY());
  const auto place = look->PlaceAt(this->GetX(), this->GetY());
  if (this->Held == Representation::None)
  {
    if (!place || !look->AddControlPoint(*place))
      return false;
    this->Held = look->GetNumberOfControlPoints() - 1;
    this->WidgetState = this->IsShiftDown() ? Freehand : Dragging;
    return this->Changed();
  }
  if (this->Held == 0)
    look->Close();
  const auto at = look->GetControlPoint(this->Held);
  // where it was, to go back to: under the cursor it may be another place
  const auto p = look->ToDisplay(at);
  const auto there = look->PlaceAt(p[0], p[1]);
  if (!there)
    return true;
  *this->PlaceBefore = *there;
  this->WidgetState = Dragging;
  look->Highlight(this->Held);
  return this->Changed();
}

bool vtkFaceToBoneCurveWidget::DragPoint()
{
  Representation* look = this->GetCurveRepresentation();
  const auto place = look->PlaceAt(this->GetX(), this->GetY());
  if (!place || this->Held >= look->GetNumberOfControlPoints())
    return true;
  look->MoveControlPoint(this->Held, *place);
  return this->Changed();
}

bool vtkFaceToBoneCurveWidget::DrawOn()
{
  Representation* look = this->GetCurveRepresentation();
  const auto place = look->PlaceAt(this->GetX(), this->GetY());
  if (!place)
    return true;
  const auto last = look->GetControlPoint(look->GetNumberOfControlPoints() - 1);
  if ((place->point - f2b::Vec3(last.data())).norm() < FreehandSpacingMm)
    return true;
  look->AddControlPoint(*place);
  return this->Changed();
}

bool vtkFaceToBoneCurveWidget::Release()
{
  this->WidgetState = Start;
  this->GetCurveRepresentation()->HideLength();
  return true;
}

bool vtkFaceToBoneCurveWidget::TakeBack()
{
  Representation* look = this->GetCurveRepresentation();
  if (look->GetNumberOfControlPoints() > this->CountBefore)
    while (look->GetNumberOfControlPoints() > this->CountBefore)
      look->RemoveLastControlPoint();
  else
    look->MoveControlPoint(this->Held, *this->PlaceBefore);
  if (look->GetClosed() && !this->ClosedBefore)
    look->Open();
  this->Changed();
  return this->Release();
}

bool vtkFaceToBoneCurveWidget::RemoveLast()
{
  Representation* look = this->GetCurveRepresentation();
  if (look->GetNumberOfControlPoints() == 0)
    return false;
  look->RemoveLastControlPoint();
  this->Changed();
  look->HideLength();
  return true;
}

bool vtkFaceToBoneCurveWidget::Finish()
{
  if (this->GetCurveRepresentation()->GetNumberOfControlPoints() < 2)
    return false;
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

void vtkFaceToBoneCurveWidget::Cancel()
{
  if (this->WidgetState != Start)
    this->TakeBack();
  this->GetCurveRepresentation()->Highlight(Representation::None);
}

void vtkFaceToBoneCurveWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Held: " << this->Held << "\n";
}
