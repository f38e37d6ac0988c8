#include "vtkObserverManager.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkObserverManager);

vtkObserverManager::vtkObserverManager() = default;

vtkObserverManager::~vtkObserverManager()
{
  for (auto& [object, observations] : this->Observations)
  {
    for (const Observation& observation : observations)
    {
      object->RemoveObserver(observation.Tag);
    }
  }
}

void vtkObserverManager::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Observed objects: " << this->Observations.size() << "\n";
}

vtkObject* vtkObserverManager::GetObserver()
{
  return this->Owner ? this->Owner : this;
}

void vtkObserverManager::SetObject(vtkObject** nodePtr, vtkObject* node)
{
  this->RemoveObjectEvents(*nodePtr);
  if (*nodePtr == node)
  {
    return;
  }
  vtkObject* previous = *nodePtr;
  *nodePtr = node;
  if (node)
  {
    node->Register(this);
  }
  if (previous)
  {
    previous->UnRegister(this);
  }
}

void vtkObserverManager::SetAndObserveObject(vtkObject** nodePtr, vtkObject* node, float priority,
                                             bool)
{
  this->SetObject(nodePtr, node);
  this->ObserveObject(node, priority);
}

void vtkObserverManager::SetAndObserveObjectEvents(vtkObject** nodePtr, vtkObject* node,
                                                   vtkIntArray* events, vtkFloatArray* priorities,
                                                   bool)
{
  this->SetObject(nodePtr, node);
  this->AddObjectEvents(node, events, priorities);
}

void vtkObserverManager::ObserveObject(vtkObject* node, float priority)
{
  vtkNew<vtkIntArray> events;
  events->InsertNextValue(vtkCommand::ModifiedEvent);
  vtkNew<vtkFloatArray> priorities;
  priorities->InsertNextValue(priority);
  this->AddObjectEvents(node, events, priorities);
}

void vtkObserverManager::AddObjectEvents(vtkObject* nodePtr, vtkIntArray* events,
                                         vtkFloatArray* priorities)
{
  if (!nodePtr || !events)
  {
    return;
  }
  std::vector<Observation>& observations = this->Observations[nodePtr];
  for (vtkIdType i = 0; i < events->GetNumberOfTuples(); ++i)
  {
    const auto event = static_cast<unsigned long>(events->GetValue(i));
    const float priority =
        priorities && i < priorities->GetNumberOfTuples() ? priorities->GetValue(i) : 0.0F;
    observations.push_back({event, nodePtr->AddObserver(event, this->CallbackCommand, priority)});
  }
}

void vtkObserverManager::RemoveObjectEvents(vtkObject* nodePtr)
{
  const auto found = this->Observations.find(nodePtr);
  if (found == this->Observations.end())
  {
    return;
  }
  for (const Observation& observation : found->second)
  {
    nodePtr->RemoveObserver(observation.Tag);
  }
  this->Observations.erase(found);
}

int vtkObserverManager::GetObservationsCount(vtkObject* nodePtr, unsigned long event)
{
  const auto found = this->Observations.find(nodePtr);
  if (found == this->Observations.end())
  {
    return 0;
  }
  return static_cast<int>(std::count_if(found->second.begin(), found->second.end(),
                                        [event](const Observation& one)
                                        { return event == 0 || one.Event == event; }));
}
