#include "vtkMRMLTransformableNode.h"

#include "vtkMRMLScene.h"
#include "vtkMRMLTransformNode.h"

#include <vtkGeneralTransform.h>
#include <vtkTransform.h>

vtkMRMLTransformableNode::vtkMRMLTransformableNode()
{
  vtkNew<vtkIntArray> events;
  events->InsertNextValue(vtkCommand::ModifiedEvent);
  events->InsertNextValue(vtkMRMLTransformableNode::TransformModifiedEvent);
  this->AddNodeReferenceRole("transform", "transformNodeRef", events);
}

bool vtkMRMLTransformableNode::SetAndObserveTransformNodeID(const char* transformNodeID)
{
  auto* own = vtkMRMLTransformNode::SafeDownCast(this);
  auto* parent = vtkMRMLTransformNode::SafeDownCast(
      this->GetScene() ? this->GetScene()->GetNodeByID(transformNodeID) : nullptr);
  if (own && parent && (own == parent || own->IsTransformNodeMyChild(parent)))
  {
    vtkErrorMacro("SetAndObserveTransformNodeID: a transform cannot be its own parent");
    return false;
  }
  this->SetAndObserveNodeReferenceID(this->GetTransformNodeReferenceRole(), transformNodeID);
  return true;
}

const char* vtkMRMLTransformableNode::GetTransformNodeID()
{
  return this->GetNodeReferenceID(this->GetTransformNodeReferenceRole());
}

vtkMRMLTransformNode* vtkMRMLTransformableNode::GetParentTransformNode()
{
  return vtkMRMLTransformNode::SafeDownCast(
      this->GetNodeReference(this->GetTransformNodeReferenceRole()));
}

void vtkMRMLTransformableNode::ProcessMRMLEvents(vtkObject* caller, unsigned long event,
                                                 void* callData)
{
  this->Superclass::ProcessMRMLEvents(caller, event, callData);
  if (caller && event == vtkMRMLTransformableNode::TransformModifiedEvent &&
      caller == this->GetParentTransformNode())
  {
    this->InvokeCustomModifiedEvent(vtkMRMLTransformableNode::TransformModifiedEvent);
  }
}

void vtkMRMLTransformableNode::NoticeTransform(vtkMRMLNodeReference* reference)
{
  if (std::string(reference->GetReferenceRole()) == this->GetTransformNodeReferenceRole())
  {
    this->OnTransformNodeReferenceChanged(
        vtkMRMLTransformNode::SafeDownCast(reference->GetReferencedNode()));
  }
}

void vtkMRMLTransformableNode::OnNodeReferenceAdded(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceAdded(reference);
  this->NoticeTransform(reference);
}

void vtkMRMLTransformableNode::OnNodeReferenceModified(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceModified(reference);
  this->NoticeTransform(reference);
}

void vtkMRMLTransformableNode::OnNodeReferenceRemoved(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceRemoved(reference);
  this->NoticeTransform(reference);
}

void vtkMRMLTransformableNode::OnTransformNodeReferenceChanged(vtkMRMLTransformNode* transformNode)
{
  this->InvokeCustomModifiedEvent(vtkMRMLTransformableNode::TransformModifiedEvent, transformNode);
}

bool vtkMRMLTransformableNode::CanApplyNonLinearTransforms() const
{
  return false;
}

void vtkMRMLTransformableNode::ApplyTransformMatrix(vtkMatrix4x4* transformMatrix)
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(transformMatrix);
  this->ApplyTransform(transform);
}

void vtkMRMLTransformableNode::ApplyTransform(vtkAbstractTransform*)
{
  vtkErrorMacro("ApplyTransform: not for a " << this->GetClassName());
}

bool vtkMRMLTransformableNode::HardenTransform()
{
  vtkMRMLTransformNode* parent = this->GetParentTransformNode();
  if (!parent)
  {
    return true;
  }
  if (parent->IsTransformToWorldLinear())
  {
    vtkNew<vtkMatrix4x4> matrix;
    parent->GetMatrixTransformToWorld(matrix);
    this->ApplyTransformMatrix(matrix);
  }
  else
  {
    vtkNew<vtkGeneralTransform> transform;
    parent->GetTransformToWorld(transform);
    this->ApplyTransform(transform);
  }
  this->SetAndObserveTransformNodeID(nullptr);
  return true;
}

void vtkMRMLTransformableNode::TransformPointToWorld(const double inLocal[3], double outWorld[3])
{
  vtkNew<vtkGeneralTransform> transform;
  vtkMRMLTransformNode::GetTransformBetweenNodes(this->GetParentTransformNode(), nullptr,
                                                 transform);
  transform->TransformPoint(inLocal, outWorld);
}

void vtkMRMLTransformableNode::TransformPointToWorld(const vtkVector3d& inLocal,
                                                     vtkVector3d& outWorld)
{
  this->TransformPointToWorld(inLocal.GetData(), outWorld.GetData());
}

void vtkMRMLTransformableNode::TransformPointFromWorld(const double inWorld[3], double outLocal[3])
{
  vtkNew<vtkGeneralTransform> transform;
  vtkMRMLTransformNode::GetTransformBetweenNodes(nullptr, this->GetParentTransformNode(),
                                                 transform);
  transform->TransformPoint(inWorld, outLocal);
}

void vtkMRMLTransformableNode::TransformPointFromWorld(const vtkVector3d& inWorld,
                                                       vtkVector3d& outLocal)
{
  this->TransformPointFromWorld(inWorld.GetData(), outLocal.GetData());
}
