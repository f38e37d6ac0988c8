#pragma once

#include "vtkMRMLStorableNode.h"

#include <vtkVector.h>

class vtkAbstractTransform;
class vtkMatrix4x4;
class vtkMRMLTransformNode;

/// A node that lives in a frame: the world (RAS), or that of its parent transform.
class VTK_MRML_EXPORT vtkMRMLTransformableNode : public vtkMRMLStorableNode
{
public:
  vtkTypeMacro(vtkMRMLTransformableNode, vtkMRMLStorableNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  void ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData) override;

  /// False where that would make a loop.
  bool SetAndObserveTransformNodeID(const char* transformNodeID);
  const char* GetTransformNodeID();
  vtkMRMLTransformNode* GetParentTransformNode();

  enum
  {
    TransformModifiedEvent = 15000
  };

  virtual bool CanApplyNonLinearTransforms() const;
  virtual void ApplyTransformMatrix(vtkMatrix4x4* transformMatrix);
  virtual void ApplyTransform(vtkAbstractTransform* transform);
  /// Applies the parent transforms to the data and leaves them.
  bool HardenTransform();
  virtual void TransformPointToWorld(const double inLocal[3], double outWorld[3]);
  virtual void TransformPointToWorld(const vtkVector3d& inLocal, vtkVector3d& outWorld);
  virtual void TransformPointFromWorld(const double inWorld[3], double outLocal[3]);
  virtual void TransformPointFromWorld(const vtkVector3d& inWorld, vtkVector3d& outLocal);

protected:
  vtkMRMLTransformableNode();
  ~vtkMRMLTransformableNode() override = default;
  vtkMRMLTransformableNode(const vtkMRMLTransformableNode&) = delete;
  void operator=(const vtkMRMLTransformableNode&) = delete;

  virtual const char* GetTransformNodeReferenceRole() { return "transform"; }
  virtual const char* GetTransformNodeReferenceMRMLAttributeName() { return "transformNodeRef"; }
  void OnNodeReferenceAdded(vtkMRMLNodeReference* reference) override;
  void OnNodeReferenceModified(vtkMRMLNodeReference* reference) override;
  void OnNodeReferenceRemoved(vtkMRMLNodeReference* reference) override;
  virtual void OnTransformNodeReferenceChanged(vtkMRMLTransformNode* transformNode);

private:
  void NoticeTransform(vtkMRMLNodeReference* reference);
};
