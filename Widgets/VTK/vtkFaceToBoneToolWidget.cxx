#include "vtkFaceToBoneToolWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

/// VTK's translator knows no events of ours: each event is its own number.
template <unsigned long Event>
void vtkFaceToBoneToolWidget::Listen()
{
  this->CallbackMapper->SetCallbackMethod(
      Event, Event, this,
      [](vtkAbstractWidget* widget)
      { static_cast<vtkFaceToBoneToolWidget*>(widget)->Dispatch(Event); });
}

vtkFaceToBoneToolWidget::vtkFaceToBoneToolWidget()
{
  this->ManagesCursor = 0;
  this->KeyPressActivationOff(); // the host says when a tool is on, not VTK's key i
  this->Listen<vtkCommand::MouseMoveEvent>();
  this->Listen<vtkCommand::LeftButtonPressEvent>();
  this->Listen<vtkCommand::LeftButtonReleaseEvent>();
  this->Listen<vtkCommand::LeftButtonDoubleClickEvent>();
  this->Listen<vtkCommand::RightButtonPressEvent>();
  this->Listen<vtkCommand::RightButtonReleaseEvent>();
  this->Listen<vtkCommand::MouseWheelForwardEvent>();
  this->Listen<vtkCommand::MouseWheelBackwardEvent>();
  this->Listen<vtkCommand::KeyPressEvent>();
  this->Listen<vtkCommand::LeaveEvent>();
}

vtkFaceToBoneToolWidget::~vtkFaceToBoneToolWidget() = default;

void vtkFaceToBoneToolWidget::On(int state, unsigned long event, Action action)
{
  this->Actions[{state, event}] = std::move(action);
}

void vtkFaceToBoneToolWidget::OnKey(int state, const std::string& symbol, Action action)
{
  this->KeyActions[{state, symbol}] = std::move(action);
}

/// Null where the table has no entry.
const vtkFaceToBoneToolWidget::Action* vtkFaceToBoneToolWidget::Find(unsigned long event) const
{
  if (event == vtkCommand::KeyPressEvent)
  {
    const char* symbol = this->Interactor->GetKeySym();
    const auto found = this->KeyActions.find({this->WidgetState, symbol ? symbol : ""});
    return found == this->KeyActions.end() ? nullptr : &found->second;
  }
  const auto found = this->Actions.find({this->WidgetState, event});
  return found == this->Actions.end() ? nullptr : &found->second;
}

/// Whether an event without an action belongs to a press that was ours.
bool vtkFaceToBoneToolWidget::IsOwed(unsigned long event)
{
  switch (event)
  {
  case vtkCommand::LeftButtonDoubleClickEvent:
  case vtkCommand::LeftButtonReleaseEvent:
    return this->LeftIsOurs;
  case vtkCommand::RightButtonReleaseEvent:
    return this->RightIsOurs;
  default:
    return false;
  }
}

void vtkFaceToBoneToolWidget::Dispatch(unsigned long event)
{
  if (!this->WidgetRep || !this->CurrentRenderer)
    return;
  const bool owed = this->IsOwed(event);
  const Action* action = this->Find(event);
  if (!action && event == vtkCommand::LeftButtonDoubleClickEvent && !owed)
    action = this->Find(vtkCommand::LeftButtonPressEvent);
  const bool ours = action && (*action)();
  if (event == vtkCommand::LeftButtonPressEvent || event == vtkCommand::LeftButtonReleaseEvent ||
      (event == vtkCommand::LeftButtonDoubleClickEvent && ours))
    this->LeftIsOurs = ours && event != vtkCommand::LeftButtonReleaseEvent;
  if (event == vtkCommand::RightButtonPressEvent || event == vtkCommand::RightButtonReleaseEvent)
    this->RightIsOurs = ours && event != vtkCommand::RightButtonReleaseEvent;
  if (!ours && !owed)
    return;
  this->EventCallbackCommand->SetAbortFlag(1);
  if (ours)
    this->Render();
}

void vtkFaceToBoneToolWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
    this->Cancel();
  this->LeftIsOurs = this->RightIsOurs = false;
  this->Superclass::SetEnabled(enabling);
}

int vtkFaceToBoneToolWidget::GetX() const
{
  return this->Interactor->GetEventPosition()[0];
}

int vtkFaceToBoneToolWidget::GetY() const
{
  return this->Interactor->GetEventPosition()[1];
}

bool vtkFaceToBoneToolWidget::IsControlDown() const
{
  return this->Interactor->GetControlKey() != 0;
}

bool vtkFaceToBoneToolWidget::IsShiftDown() const
{
  return this->Interactor->GetShiftKey() != 0;
}

void vtkFaceToBoneToolWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WidgetState: " << this->WidgetState << "\n";
}
