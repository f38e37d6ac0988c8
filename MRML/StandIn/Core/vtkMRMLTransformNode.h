#pragma once

#include "vtkMRMLDisplayableNode.h"

class vtkAbstractTransform;
class vtkGeneralTransform;
class vtkMatrix4x4;

/// A transform from its own frame to its parent's: matrices act on columns, points are RAS [mm].
class VTK_MRML_EXPORT vtkMRMLTransformNode : public vtkMRMLDisplayableNode
{
public:
  static vtkMRMLTransformNode* New();
  vtkTypeMacro(vtkMRMLTransformNode, vtkMRMLDisplayableNode);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "Transform"; }
  void ReadXMLAttributes(const char** atts) override;
  vtkMRMLCopyContentMacro(vtkMRMLTransformNode);
  void ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData) override;

  virtual int IsLinear();
  virtual vtkAbstractTransform* GetTransformToParent();
  virtual vtkAbstractTransform* GetTransformFromParent();
  void SetAndObserveTransformToParent(vtkAbstractTransform* transform);
  void SetAndObserveTransformFromParent(vtkAbstractTransform* transform);
  /// 0 (and the identity) where the transform is not linear.
  virtual int GetMatrixTransformToParent(vtkMatrix4x4* matrix);
  virtual int GetMatrixTransformFromParent(vtkMatrix4x4* matrix);
  virtual int SetMatrixTransformToParent(vtkMatrix4x4* matrix);
  virtual int SetMatrixTransformFromParent(vtkMatrix4x4* matrix);
  void Inverse();

  int IsTransformToWorldLinear();
  void GetTransformToWorld(vtkGeneralTransform* transformToWorld);
  void GetTransformFromWorld(vtkGeneralTransform* transformFromWorld);
  virtual int GetMatrixTransformToWorld(vtkMatrix4x4* transformToWorld);
  virtual int GetMatrixTransformFromWorld(vtkMatrix4x4* transformFromWorld);
  /// A null node is the world.
  static void GetTransformBetweenNodes(vtkMRMLTransformNode* sourceNode,
                                       vtkMRMLTransformNode* targetNode,
                                       vtkGeneralTransform* transformSourceToTarget);
  static int GetMatrixTransformBetweenNodes(vtkMRMLTransformNode* sourceNode,
                                            vtkMRMLTransformNode* targetNode,
                                            vtkMatrix4x4* transformSourceToTarget);
  int IsTransformNodeMyParent(vtkMRMLTransformNode* node);
  int IsTransformNodeMyChild(vtkMRMLTransformNode* node);

  bool CanApplyNonLinearTransforms() const override;
  void ApplyTransformMatrix(vtkMatrix4x4* transformMatrix) override;
  void ApplyTransform(vtkAbstractTransform* transform) override;
  vtkMRMLStorageNode* CreateDefaultStorageNode() override;
  void CreateDefaultDisplayNodes() override;
  bool GetModifiedSinceRead() override;
  virtual void TransformModified();

protected:
  vtkMRMLTransformNode() = default;
  ~vtkMRMLTransformNode() override;
  vtkMRMLTransformNode(const vtkMRMLTransformNode&) = delete;
  void operator=(const vtkMRMLTransformNode&) = delete;

private:
  vtkAbstractTransform* TransformToParent = nullptr; ///< null is the identity
};
