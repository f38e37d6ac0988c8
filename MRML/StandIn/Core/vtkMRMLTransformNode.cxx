#include "vtkMRMLTransformNode.h"

#include "vtkMRMLScene.h"
#include "vtkMRMLTransformStorageNode.h"

#include <vtkGeneralTransform.h>
#include <vtkLinearTransform.h>
#include <vtkObjectFactory.h>
#include <vtkTransform.h>

#include <algorithm>

vtkMRMLNodeNewMacro(vtkMRMLTransformNode);

vtkMRMLTransformNode::~vtkMRMLTransformNode()
{
  vtkSetAndObserveMRMLObjectMacro(this->TransformToParent, nullptr);
}

void vtkMRMLTransformNode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  if (this->TransformToParent)
  {
    this->TransformToParent->PrintSelf(os, indent.GetNextIndent());
  }
}

void vtkMRMLTransformNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  if (!std::strcmp(xmlReadAttName, "matrixTransformToParent"))
  {
    vtkNew<vtkMatrix4x4> matrix;
    const char* rest = xmlReadAttValue;
    double number = 0.0;
    for (int i = 0; i < 16 && vtkMRMLNextNumber(rest, number); ++i)
    {
      matrix->SetElement(i / 4, i % 4, number);
    }
    this->SetMatrixTransformToParent(matrix);
  }
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLTransformNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  auto* node = vtkMRMLTransformNode::SafeDownCast(anode);
  if (!node)
  {
    return;
  }
  vtkSmartPointer<vtkAbstractTransform> transform = node->TransformToParent;
  if (transform && deepCopy)
  {
    transform = vtkSmartPointer<vtkAbstractTransform>::Take(transform->MakeTransform());
    transform->DeepCopy(node->TransformToParent);
  }
  this->SetAndObserveTransformToParent(transform);
}

void vtkMRMLTransformNode::ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData)
{
  this->Superclass::ProcessMRMLEvents(caller, event, callData);
  if (caller && caller == this->TransformToParent && event == vtkCommand::ModifiedEvent)
  {
    this->StorableModified();
    this->TransformModified();
  }
}

void vtkMRMLTransformNode::TransformModified()
{
  this->InvokeCustomModifiedEvent(vtkMRMLTransformableNode::TransformModifiedEvent);
}

// --- To the parent -----------------------------------------------------------------------------

int vtkMRMLTransformNode::IsLinear()
{
  return !this->TransformToParent || vtkLinearTransform::SafeDownCast(this->TransformToParent) ? 1
                                                                                               : 0;
}

vtkAbstractTransform* vtkMRMLTransformNode::GetTransformToParent()
{
  return this->TransformToParent;
}

vtkAbstractTransform* vtkMRMLTransformNode::GetTransformFromParent()
{
  return this->TransformToParent ? this->TransformToParent->GetInverse() : nullptr;
}

void vtkMRMLTransformNode::SetAndObserveTransformToParent(vtkAbstractTransform* transform)
{
  if (transform == this->TransformToParent)
  {
    return;
  }
  MRMLNodeModifyBlocker blocker(this);
  vtkSetAndObserveMRMLObjectMacro(this->TransformToParent, transform);
  this->StorableModified();
  this->TransformModified();
}

void vtkMRMLTransformNode::SetAndObserveTransformFromParent(vtkAbstractTransform* transform)
{
  this->SetAndObserveTransformToParent(transform ? transform->GetInverse() : nullptr);
}

int vtkMRMLTransformNode::GetMatrixTransformToParent(vtkMatrix4x4* matrix)
{
  matrix->Identity();
  if (!this->TransformToParent)
  {
    return 1;
  }
  auto* linear = vtkLinearTransform::SafeDownCast(this->TransformToParent);
  if (!linear)
  {
    vtkErrorMacro("GetMatrixTransformToParent: the transform is not linear");
    return 0;
  }
  linear->GetMatrix(matrix);
  return 1;
}

int vtkMRMLTransformNode::GetMatrixTransformFromParent(vtkMatrix4x4* matrix)
{
  const int linear = this->GetMatrixTransformToParent(matrix);
  matrix->Invert();
  return linear;
}

int vtkMRMLTransformNode::SetMatrixTransformToParent(vtkMatrix4x4* matrix)
{
  if (!this->IsLinear())
  {
    vtkErrorMacro("SetMatrixTransformToParent: the transform is not linear");
    return 0;
  }
  vtkNew<vtkTransform> transform;
  if (matrix)
  {
    transform->SetMatrix(matrix);
  }
  this->SetAndObserveTransformToParent(transform);
  return 1;
}

int vtkMRMLTransformNode::SetMatrixTransformFromParent(vtkMatrix4x4* matrix)
{
  vtkNew<vtkMatrix4x4> inverse;
  if (matrix)
  {
    vtkMatrix4x4::Invert(matrix, inverse);
  }
  return this->SetMatrixTransformToParent(inverse);
}

void vtkMRMLTransformNode::Inverse()
{
  if (this->IsLinear())
  {
    vtkNew<vtkMatrix4x4> matrix;
    this->GetMatrixTransformFromParent(matrix);
    this->SetMatrixTransformToParent(matrix);
  }
  else
  {
    this->SetAndObserveTransformToParent(this->TransformToParent->GetInverse());
  }
}

// --- To the world ------------------------------------------------------------------------------

int vtkMRMLTransformNode::IsTransformToWorldLinear()
{
  for (vtkMRMLTransformNode* node = this; node; node = node->GetParentTransformNode())
  {
    if (!node->IsLinear())
    {
      return 0;
    }
  }
  return 1;
}

void vtkMRMLTransformNode::GetTransformToWorld(vtkGeneralTransform* transformToWorld)
{
  GetTransformBetweenNodes(this, nullptr, transformToWorld);
}

void vtkMRMLTransformNode::GetTransformFromWorld(vtkGeneralTransform* transformFromWorld)
{
  GetTransformBetweenNodes(nullptr, this, transformFromWorld);
}

int vtkMRMLTransformNode::GetMatrixTransformToWorld(vtkMatrix4x4* transformToWorld)
{
  return GetMatrixTransformBetweenNodes(this, nullptr, transformToWorld);
}

int vtkMRMLTransformNode::GetMatrixTransformFromWorld(vtkMatrix4x4* transformFromWorld)
{
  return GetMatrixTransformBetweenNodes(nullptr, this, transformFromWorld);
}

void vtkMRMLTransformNode::GetTransformBetweenNodes(vtkMRMLTransformNode* sourceNode,
                                                    vtkMRMLTransformNode* targetNode,
                                                    vtkGeneralTransform* transformSourceToTarget)
{
  transformSourceToTarget->Identity();
  transformSourceToTarget->PostMultiply();
  for (auto* node = sourceNode; node; node = node->GetParentTransformNode())
  {
    if (node->GetTransformToParent())
    {
      transformSourceToTarget->Concatenate(node->GetTransformToParent());
    }
  }
  std::vector<vtkMRMLTransformNode*> down;
  for (auto* node = targetNode; node; node = node->GetParentTransformNode())
  {
    down.push_back(node);
  }
  for (auto node = down.rbegin(); node != down.rend(); ++node)
  {
    if ((*node)->GetTransformFromParent())
    {
      transformSourceToTarget->Concatenate((*node)->GetTransformFromParent());
    }
  }
}

int vtkMRMLTransformNode::GetMatrixTransformBetweenNodes(vtkMRMLTransformNode* sourceNode,
                                                         vtkMRMLTransformNode* targetNode,
                                                         vtkMatrix4x4* transformSourceToTarget)
{
  transformSourceToTarget->Identity();
  if ((sourceNode && !sourceNode->IsTransformToWorldLinear()) ||
      (targetNode && !targetNode->IsTransformToWorldLinear()))
  {
    vtkGenericWarningMacro("GetMatrixTransformBetweenNodes: a transform is not linear");
    return 0;
  }
  const auto toWorld = [](vtkMRMLTransformNode* from, vtkMatrix4x4* matrix)
  {
    matrix->Identity();
    vtkNew<vtkMatrix4x4> one;
    for (auto* node = from; node; node = node->GetParentTransformNode())
    {
      node->GetMatrixTransformToParent(one);
      vtkMatrix4x4::Multiply4x4(one, matrix, matrix);
    }
  };
  vtkNew<vtkMatrix4x4> source;
  vtkNew<vtkMatrix4x4> target;
  toWorld(sourceNode, source);
  toWorld(targetNode, target);
  if (targetNode)
  {
    target->Invert();
  }
  vtkMatrix4x4::Multiply4x4(target, source, transformSourceToTarget);
  return 1;
}

int vtkMRMLTransformNode::IsTransformNodeMyParent(vtkMRMLTransformNode* node)
{
  for (auto* above = this->GetParentTransformNode(); above; above = above->GetParentTransformNode())
  {
    if (above == node)
    {
      return 1;
    }
  }
  return 0;
}

int vtkMRMLTransformNode::IsTransformNodeMyChild(vtkMRMLTransformNode* node)
{
  return node ? node->IsTransformNodeMyParent(this) : 0;
}

bool vtkMRMLTransformNode::CanApplyNonLinearTransforms() const
{
  return true;
}

void vtkMRMLTransformNode::ApplyTransformMatrix(vtkMatrix4x4* transformMatrix)
{
  if (!this->IsLinear())
  {
    this->Superclass::ApplyTransformMatrix(transformMatrix);
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  this->GetMatrixTransformToParent(matrix);
  vtkMatrix4x4::Multiply4x4(transformMatrix, matrix, matrix);
  this->SetMatrixTransformToParent(matrix);
}

void vtkMRMLTransformNode::ApplyTransform(vtkAbstractTransform* transform)
{
  auto* linear = vtkLinearTransform::SafeDownCast(transform);
  if (linear && this->IsLinear())
  {
    this->ApplyTransformMatrix(linear->GetMatrix());
    return;
  }
  vtkNew<vtkGeneralTransform> both;
  both->PostMultiply();
  if (this->TransformToParent)
  {
    both->Concatenate(this->TransformToParent);
  }
  both->Concatenate(transform);
  this->SetAndObserveTransformToParent(both);
}

vtkMRMLStorageNode* vtkMRMLTransformNode::CreateDefaultStorageNode()
{
  return vtkMRMLTransformStorageNode::New();
}

void vtkMRMLTransformNode::CreateDefaultDisplayNodes()
{
  if (!this->GetDisplayNode() && this->GetScene())
  {
    this->SetAndObserveDisplayNodeID(
        this->GetScene()->AddNewNodeByClass("vtkMRMLTransformDisplayNode")->GetID());
  }
}

bool vtkMRMLTransformNode::GetModifiedSinceRead()
{
  return this->Superclass::GetModifiedSinceRead() ||
         (this->TransformToParent &&
          this->TransformToParent->GetMTime() > this->GetStoredTime().GetMTime());
}
