#pragma once

#include "vtkMRMLStorageNode.h"

/// A scalar volume's file: .nrrd, .mha or .nii, read and written by ITK (its LPS is turned to RAS);
/// .nhdr and .mhd with their separate voxels are read.
class VTK_MRML_EXPORT vtkMRMLVolumeArchetypeStorageNode : public vtkMRMLStorageNode
{
public:
  static vtkMRMLVolumeArchetypeStorageNode* New();
  vtkTypeMacro(vtkMRMLVolumeArchetypeStorageNode, vtkMRMLStorageNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "VolumeArchetypeStorage"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;
  bool CanReadInReferenceNode(vtkMRMLNode* refNode) override;
  vtkGetMacro(CenterImage, int);
  vtkSetMacro(CenterImage, int);
  vtkGetMacro(SingleFile, int);
  vtkSetMacro(SingleFile, int);
  vtkGetMacro(UseOrientationFromFile, int);
  vtkSetMacro(UseOrientationFromFile, int);

protected:
  vtkMRMLVolumeArchetypeStorageNode();
  ~vtkMRMLVolumeArchetypeStorageNode() override = default;
  vtkMRMLVolumeArchetypeStorageNode(const vtkMRMLVolumeArchetypeStorageNode&) = delete;
  void operator=(const vtkMRMLVolumeArchetypeStorageNode&) = delete;

  void InitializeSupportedReadFileTypes() override;
  void InitializeSupportedWriteFileTypes() override;
  int ReadDataInternal(vtkMRMLNode* refNode) override;
  int WriteDataInternal(vtkMRMLNode* refNode) override;

private:
  int CenterImage = 0;
  int SingleFile = 0;
  int UseOrientationFromFile = 1;
};
