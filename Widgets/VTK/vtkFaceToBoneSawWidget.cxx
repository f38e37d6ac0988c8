#include "vtkFaceToBoneSawWidget.h"

#include <Core/sculpting/line_of_sight.hpp>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkFaceToBoneSawWidget);

using Representation = vtkFaceToBoneSawRepresentation;

vtkFaceToBoneSawWidget::vtkFaceToBoneSawWidget()
{
  this->On(Start, vtkCommand::MouseMoveEvent,
           [this] {
             return this->Hover(this->GetSawRepresentation()->HandleAt(this->GetX(), this->GetY()));
           });
  this->On(Start, vtkCommand::LeaveEvent, [this] { return this->Hover(Representation::None); });
  this->On(Start, vtkCommand::LeftButtonPressEvent, [this] { return this->Press(); });
  this->On(Dragging, vtkCommand::MouseMoveEvent, [this] { return this->Move(); });
  this->On(Dragging, vtkCommand::LeftButtonReleaseEvent, [this] { return this->Release(); });
  this->On(Dragging, vtkCommand::RightButtonPressEvent, [this] { return this->TakeBack(); });
  this->OnKey(Dragging, "Escape", [this] { return this->TakeBack(); });
}

vtkFaceToBoneSawWidget::~vtkFaceToBoneSawWidget() = default;

void vtkFaceToBoneSawWidget::SetRepresentation(Representation* representation)
{
  this->SetWidgetRepresentation(representation);
}

void vtkFaceToBoneSawWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
    this->WidgetRep = Representation::New();
}

Representation* vtkFaceToBoneSawWidget::GetSawRepresentation()
{
  return static_cast<Representation*>(this->GetRepresentation());
}

bool vtkFaceToBoneSawWidget::Hover(Representation::Handle handle)
{
  if (this->GetSawRepresentation()->HighlightOnly(handle))
    this->Render();
  return false; // another cut may be there, too
}

bool vtkFaceToBoneSawWidget::Press()
{
  Representation* look = this->GetSawRepresentation();
  this->Held = look->HandleAt(this->GetX(), this->GetY());
  if (this->Held == Representation::None)
    return false;
  this->DirectionBefore = look->GetDirection();
  this->LeadBefore = look->GetLead();
  this->DepthBefore = look->GetDepth();
  this->WidgetState = Dragging;
  look->HighlightOnly(this->Held);
  look->ShowDepth(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  return true;
}

/// The hand follows the cursor as if it lay on a ball about the line's middle.
bool vtkFaceToBoneSawWidget::Move()
{
  Representation* look = this->GetSawRepresentation();
  const f2b::Vec3 middle(look->GetMiddle().data());
  if (this->Held == Representation::Hand)
  {
    const auto now =
        look->WorldAtDepthOf(look->HandlePosition(this->Held), this->GetX(), this->GetY());
    const f2b::Vec3 inwards = middle - f2b::Vec3(now.data());
    if (inwards.norm() > 1e-6)
      look->SetDirection({inwards.x(), inwards.y(), inwards.z()});
  }
  else if (const auto at = f2b::along_axis(look->LineAt(this->GetX(), this->GetY()), middle,
                                           f2b::Vec3(look->GetDirection().data())))
    look->SetReach(look->GetLead(), std::clamp(*at, LeastDepth, MostDepth));
  look->ShowDepth(this->GetX(), this->GetY());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

bool vtkFaceToBoneSawWidget::Release()
{
  this->WidgetState = Start;
  this->GetSawRepresentation()->HideDepth();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

bool vtkFaceToBoneSawWidget::TakeBack()
{
  Representation* look = this->GetSawRepresentation();
  look->SetDirection(this->DirectionBefore);
  look->SetReach(this->LeadBefore, this->DepthBefore);
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return this->Release();
}

void vtkFaceToBoneSawWidget::Cancel()
{
  if (this->WidgetState == Dragging)
    this->TakeBack();
  this->GetSawRepresentation()->HighlightOnly(Representation::None);
}

void vtkFaceToBoneSawWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Held: " << this->Held << "\n";
}
