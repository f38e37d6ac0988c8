#include "vtkMRMLDisplayableNode.h"

#include "vtkMRMLDisplayNode.h"
#include "vtkMRMLScene.h"

#include <vtkMath.h>

vtkMRMLDisplayableNode::vtkMRMLDisplayableNode()
{
  vtkNew<vtkIntArray> events;
  events->InsertNextValue(vtkCommand::ModifiedEvent);
  this->AddNodeReferenceRole("display", "displayNodeRef", events);
}

void vtkMRMLDisplayableNode::ProcessMRMLEvents(vtkObject* caller, unsigned long event,
                                               void* callData)
{
  this->Superclass::ProcessMRMLEvents(caller, event, callData);
  auto* display = vtkMRMLDisplayNode::SafeDownCast(caller);
  if (display && event == vtkCommand::ModifiedEvent && this->HasDisplayNodeID(display->GetID()))
  {
    this->InvokeCustomModifiedEvent(vtkMRMLDisplayableNode::DisplayModifiedEvent, display);
  }
}

void vtkMRMLDisplayableNode::NoticeDisplay(vtkMRMLNodeReference* reference)
{
  if (std::string(reference->GetReferenceRole()) == this->GetDisplayNodeReferenceRole())
  {
    this->InvokeCustomModifiedEvent(vtkMRMLDisplayableNode::DisplayModifiedEvent,
                                    reference->GetReferencedNode());
  }
}

void vtkMRMLDisplayableNode::OnNodeReferenceAdded(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceAdded(reference);
  this->NoticeDisplay(reference);
}

void vtkMRMLDisplayableNode::OnNodeReferenceModified(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceModified(reference);
  this->NoticeDisplay(reference);
}

void vtkMRMLDisplayableNode::OnNodeReferenceRemoved(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceRemoved(reference);
  this->NoticeDisplay(reference);
}

void vtkMRMLDisplayableNode::SetAndObserveDisplayNodeID(const char* displayNodeID)
{
  this->SetAndObserveNodeReferenceID(this->GetDisplayNodeReferenceRole(), displayNodeID);
}

void vtkMRMLDisplayableNode::AddAndObserveDisplayNodeID(const char* displayNodeID)
{
  this->AddAndObserveNodeReferenceID(this->GetDisplayNodeReferenceRole(), displayNodeID);
}

void vtkMRMLDisplayableNode::SetAndObserveNthDisplayNodeID(int n, const char* displayNodeID)
{
  this->SetAndObserveNthNodeReferenceID(this->GetDisplayNodeReferenceRole(), n, displayNodeID);
}

void vtkMRMLDisplayableNode::RemoveNthDisplayNodeID(int n)
{
  this->RemoveNthNodeReferenceID(this->GetDisplayNodeReferenceRole(), n);
}

void vtkMRMLDisplayableNode::RemoveAllDisplayNodeIDs()
{
  this->RemoveNodeReferenceIDs(this->GetDisplayNodeReferenceRole());
}

bool vtkMRMLDisplayableNode::HasDisplayNodeID(const char* displayNodeID)
{
  return this->HasNodeReferenceID(this->GetDisplayNodeReferenceRole(), displayNodeID);
}

int vtkMRMLDisplayableNode::GetNumberOfDisplayNodes()
{
  return this->GetNumberOfNodeReferences(this->GetDisplayNodeReferenceRole());
}

const char* vtkMRMLDisplayableNode::GetNthDisplayNodeID(int n)
{
  return this->GetNthNodeReferenceID(this->GetDisplayNodeReferenceRole(), n);
}

const char* vtkMRMLDisplayableNode::GetDisplayNodeID()
{
  return this->GetNthDisplayNodeID(0);
}

vtkMRMLDisplayNode* vtkMRMLDisplayableNode::GetNthDisplayNode(int n)
{
  return vtkMRMLDisplayNode::SafeDownCast(
      this->GetNthNodeReference(this->GetDisplayNodeReferenceRole(), n));
}

vtkMRMLDisplayNode* vtkMRMLDisplayableNode::GetDisplayNode()
{
  return this->GetNthDisplayNode(0);
}

int vtkMRMLDisplayableNode::GetDisplayVisibility()
{
  int visible = -1;
  for (int n = 0; n < this->GetNumberOfDisplayNodes(); ++n)
  {
    vtkMRMLDisplayNode* display = this->GetNthDisplayNode(n);
    if (display && visible >= 0 && display->GetVisibility() != visible)
    {
      return 2;
    }
    visible = display ? display->GetVisibility() : visible;
  }
  return visible < 0 ? 0 : visible;
}

void vtkMRMLDisplayableNode::SetDisplayVisibility(int visible)
{
  for (int n = 0; n < this->GetNumberOfDisplayNodes(); ++n)
  {
    if (vtkMRMLDisplayNode* display = this->GetNthDisplayNode(n))
    {
      display->SetVisibility(visible);
    }
  }
}

void vtkMRMLDisplayableNode::GetRASBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
}

void vtkMRMLDisplayableNode::GetBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
}
