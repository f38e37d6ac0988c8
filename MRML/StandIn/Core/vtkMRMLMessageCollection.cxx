#include "vtkMRMLMessageCollection.h"

#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkMRMLMessageCollection);

vtkMRMLMessageCollection::vtkMRMLMessageCollection()
{
  this->CallbackCommand->SetClientData(this);
  this->CallbackCommand->SetCallback(vtkMRMLMessageCollection::CallbackFunction);
}

vtkMRMLMessageCollection::~vtkMRMLMessageCollection()
{
  this->SetObservedObject(nullptr);
}

void vtkMRMLMessageCollection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << this->GetAllMessagesAsString();
}

int vtkMRMLMessageCollection::GetNumberOfMessages() const
{
  return static_cast<int>(this->Messages.size());
}

int vtkMRMLMessageCollection::GetNumberOfMessagesOfType(unsigned long messageType) const
{
  return static_cast<int>(std::count_if(this->Messages.begin(), this->Messages.end(),
                                        [messageType](const Message& message)
                                        { return message.Type == messageType; }));
}

unsigned long vtkMRMLMessageCollection::GetNthMessageType(int index) const
{
  return index < 0 || index >= this->GetNumberOfMessages() ? 0 : this->Messages[index].Type;
}

std::string vtkMRMLMessageCollection::GetNthMessageText(int index) const
{
  return index < 0 || index >= this->GetNumberOfMessages() ? "" : this->Messages[index].Text;
}

void vtkMRMLMessageCollection::AddMessage(unsigned long messageType, const std::string& messageText)
{
  this->Messages.push_back({messageType, messageText});
  this->Modified();
}

void vtkMRMLMessageCollection::AddMessages(vtkMRMLMessageCollection* source,
                                           const std::string& prefix)
{
  for (int n = 0; source && n < source->GetNumberOfMessages(); ++n)
  {
    this->AddMessage(source->GetNthMessageType(n), prefix + source->GetNthMessageText(n));
  }
}

void vtkMRMLMessageCollection::ClearMessages()
{
  this->Messages.clear();
  this->Modified();
}

void vtkMRMLMessageCollection::DeepCopy(vtkMRMLMessageCollection* source)
{
  this->Messages = source ? source->Messages : std::vector<Message>();
  this->Modified();
}

std::string vtkMRMLMessageCollection::GetAllMessagesAsString(bool* errorFound, bool* warningFound)
{
  const bool errors = this->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent) > 0;
  const bool warnings = this->GetNumberOfMessagesOfType(vtkCommand::WarningEvent) > 0;
  if (errorFound)
  {
    *errorFound = errors;
  }
  if (warningFound)
  {
    *warningFound = warnings;
  }
  std::string all;
  for (const Message& message : this->Messages)
  {
    all += message.Type == vtkCommand::ErrorEvent     ? "- Error: "
           : message.Type == vtkCommand::WarningEvent ? "- Warning: "
                                                      : "- ";
    all += message.Text + "\n";
  }
  return all;
}

void vtkMRMLMessageCollection::SetObservedObject(vtkObject* observedObject)
{
  if (this->ObservedObject)
  {
    this->ObservedObject->RemoveObserver(this->CallbackCommand);
  }
  this->ObservedObject = observedObject;
  if (observedObject)
  {
    observedObject->AddObserver(vtkCommand::ErrorEvent, this->CallbackCommand);
    observedObject->AddObserver(vtkCommand::WarningEvent, this->CallbackCommand);
  }
}

void vtkMRMLMessageCollection::CallbackFunction(vtkObject*, unsigned long event, void* clientData,
                                                void* callData)
{
  static_cast<vtkMRMLMessageCollection*>(clientData)
      ->AddMessage(event, callData ? static_cast<const char*>(callData) : "");
}
