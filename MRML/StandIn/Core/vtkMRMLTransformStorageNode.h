#pragma once

#include "vtkMRMLStorageNode.h"

/// A linear transform's file: .tfm or .h5 of ITK, with the transform from the parent in LPS.
class VTK_MRML_EXPORT vtkMRMLTransformStorageNode : public vtkMRMLStorageNode
{
public:
  static vtkMRMLTransformStorageNode* New();
  vtkTypeMacro(vtkMRMLTransformStorageNode, vtkMRMLStorageNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "TransformStorage"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;
  bool CanReadInReferenceNode(vtkMRMLNode* refNode) override;
  vtkGetMacro(PreferITKv3CompatibleTransforms, int);
  vtkSetMacro(PreferITKv3CompatibleTransforms, int);
  vtkBooleanMacro(PreferITKv3CompatibleTransforms, int);

protected:
  vtkMRMLTransformStorageNode();
  ~vtkMRMLTransformStorageNode() override = default;
  vtkMRMLTransformStorageNode(const vtkMRMLTransformStorageNode&) = delete;
  void operator=(const vtkMRMLTransformStorageNode&) = delete;

  void InitializeSupportedReadFileTypes() override;
  void InitializeSupportedWriteFileTypes() override;
  int ReadDataInternal(vtkMRMLNode* refNode) override;
  int WriteDataInternal(vtkMRMLNode* refNode) override;

private:
  int PreferITKv3CompatibleTransforms = 0;
};
