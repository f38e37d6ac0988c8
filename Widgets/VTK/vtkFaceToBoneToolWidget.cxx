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

void vtkFaceToBoneToolWidget::Dispatch(unsigned long event)
{
  if (!this->WidgetRep || !this->CurrentRenderer)
    return;
  const Action* action = nullptr;
  if (event == vtkCommand::KeyPressEvent)
  {
    const char* symbol = this->Interactor->GetKeySym();
    const auto found = this->KeyActions.find({this->WidgetState, symbol ? symbol : ""});
    action = found == this->KeyActions.end() ? nullptr : &found->second;
  }
  else
  {
    const auto found = this->Actions.find({this->WidgetState, event});
    action = found == this->Actions.end() ? nullptr : &found->second;
  }
  if (!action || !(*action)())
    return;
  this->EventCallbackCommand->SetAbortFlag(1);
  this->Render();
}

void vtkFaceToBoneToolWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
    this->Cancel();
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
