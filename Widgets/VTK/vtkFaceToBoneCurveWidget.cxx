#include "vtkFaceToBoneCurveWidget.h"

#include <Core/sculpting/surface_tree.hpp>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkFaceToBoneCurveWidget);

using Representation = vtkFaceToBoneCurveRepresentation;

vtkFaceToBoneCurveWidget::vtkFaceToBoneCurveWidget()
{
  this->On(Start, vtkCommand::MouseMoveEvent, [this] { return this->Hover(); });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->On(Start, vtkCommand::LeftButtonDoubleClickEvent, [this] { return this->Finish(); });
  this->OnKey(Start, "Return", [this] { return this->Finish(); });
  this->OnKey(Start, "BackSpace", [this] { return this->RemoveLast(); });
  this->OnKey(Start, "Delete", [this] { return this->RemoveLast(); });
  this->On(Dragging, vtkCommand::MouseMoveEvent, [this] { return this->DragPoint(); });
  this->On(Freehand, vtkCommand::MouseMoveEvent, [this] { return this->DrawOn(); });
  this->On(Shifting, vtkCommand::MouseMoveEvent, [this] { return this->ShiftLine(); });
  for (const int state : {int(Dragging), int(Freehand), int(Shifting)})
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
  if (look->HighlightOnly(look->ControlPointAt(this->GetX(), this->GetY())))
  {
    look->ShowName(this->GetX(), this->GetY());
    this->Render();
  }
  return false;
}

bool vtkFaceToBoneCurveWidget::Press()
{
  Representation* look = this->GetCurveRepresentation();
  this->Before = look->Remember();
  this->Held = look->ControlPointAt(this->GetX(), this->GetY());
  return this->Held == Representation::None ? this->PressBesidePoints() : this->PressOnPoint();
}

bool vtkFaceToBoneCurveWidget::Begin(int state)
{
  this->WidgetState = state;
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  return this->Changed();
}

bool vtkFaceToBoneCurveWidget::PressBesidePoints()
{
  Representation* look = this->GetCurveRepresentation();
  if (look->GetFree() && look->LineAt(this->GetX(), this->GetY()))
  {
    this->LastX = this->GetX();
    this->LastY = this->GetY();
    return this->Begin(Shifting);
  }
  const auto place = this->Drawing ? look->PlaceAt(this->GetX(), this->GetY()) : std::nullopt;
  if (!place)
    return false;
  if (!look->AddControlPoint(*place))
  {
    look->ShowRefusal(this->GetX(), this->GetY());
    this->Render();
    return false;
  }
  this->Held = look->GetNumberOfControlPoints() - 1;
  return this->Begin(this->IsShiftDown() ? Freehand : Dragging);
}

bool vtkFaceToBoneCurveWidget::PressOnPoint()
{
  Representation* look = this->GetCurveRepresentation();
  if (this->Held == 0 && this->Drawing)
    look->Close();
  look->HighlightOnly(this->Held);
  return this->Begin(Dragging);
}

bool vtkFaceToBoneCurveWidget::DragPoint()
{
  Representation* look = this->GetCurveRepresentation();
  if (this->Held >= look->GetNumberOfControlPoints())
    return true;
  if (const auto place = look->PlaceFor(this->Held, this->GetX(), this->GetY()))
    look->MoveControlPoint(this->Held, *place);
  return this->Changed();
}

bool vtkFaceToBoneCurveWidget::ShiftLine()
{
  Representation* look = this->GetCurveRepresentation();
  if (look->GetNumberOfControlPoints() == 0)
    return true;
  const auto at = look->GetControlPoint(0);
  const auto from = look->WorldAtDepthOf(at, this->LastX, this->LastY);
  auto by = look->WorldAtDepthOf(at, this->GetX(), this->GetY());
  for (std::size_t k = 0; k < 3; ++k)
    by[k] -= from[k];
  look->Shift(by);
  this->LastX = this->GetX();
  this->LastY = this->GetY();
  return this->Changed();
}

bool vtkFaceToBoneCurveWidget::DrawOn()
{
  Representation* look = this->GetCurveRepresentation();
  const auto place = look->PlaceAt(this->GetX(), this->GetY());
  if (!place || look->GetNumberOfControlPoints() == 0)
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
  if (!this->Drawing)
    this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

bool vtkFaceToBoneCurveWidget::TakeBack()
{
  this->GetCurveRepresentation()->GoBack(*this->Before);
  this->Changed();
  return this->Release();
}

bool vtkFaceToBoneCurveWidget::RemoveLast()
{
  Representation* look = this->GetCurveRepresentation();
  if (!this->Drawing || look->GetNumberOfControlPoints() == 0)
    return false;
  look->RemoveLastControlPoint();
  this->Changed();
  look->HideLength();
  return true;
}

bool vtkFaceToBoneCurveWidget::Finish()
{
  if (!this->Drawing || this->GetCurveRepresentation()->GetNumberOfControlPoints() < 2)
    return false;
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

void vtkFaceToBoneCurveWidget::Cancel()
{
  if (this->WidgetState != Start)
    this->TakeBack();
  this->GetCurveRepresentation()->HighlightOnly(Representation::None);
}

void vtkFaceToBoneCurveWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Held: " << this->Held << "\n";
}
