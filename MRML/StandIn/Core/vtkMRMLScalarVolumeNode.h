#pragma once

#include "vtkMRMLVolumeNode.h"

class vtkMRMLScalarVolumeDisplayNode;

/// A volume with one number a voxel, such as a CT.
class VTK_MRML_EXPORT vtkMRMLScalarVolumeNode : public vtkMRMLVolumeNode
{
public:
  static vtkMRMLScalarVolumeNode* New();
  vtkTypeMacro(vtkMRMLScalarVolumeNode, vtkMRMLVolumeNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "Volume"; }
  vtkMRMLCopyContentDefaultMacro(vtkMRMLScalarVolumeNode);
  virtual vtkMRMLScalarVolumeDisplayNode* GetScalarVolumeDisplayNode();
  vtkMRMLStorageNode* CreateDefaultStorageNode() override;
  void CreateDefaultDisplayNodes() override;

protected:
  vtkMRMLScalarVolumeNode() = default;
  ~vtkMRMLScalarVolumeNode() override = default;
  vtkMRMLScalarVolumeNode(const vtkMRMLScalarVolumeNode&) = delete;
  void operator=(const vtkMRMLScalarVolumeNode&) = delete;
};
