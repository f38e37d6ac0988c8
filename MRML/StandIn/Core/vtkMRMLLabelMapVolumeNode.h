#pragma once

#include "vtkMRMLScalarVolumeNode.h"

/// A volume of labels.
class VTK_MRML_EXPORT vtkMRMLLabelMapVolumeNode : public vtkMRMLScalarVolumeNode
{
public:
  static vtkMRMLLabelMapVolumeNode* New();
  vtkTypeMacro(vtkMRMLLabelMapVolumeNode, vtkMRMLScalarVolumeNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "LabelMapVolume"; }
  void CreateDefaultDisplayNodes() override;

protected:
  vtkMRMLLabelMapVolumeNode() = default;
  ~vtkMRMLLabelMapVolumeNode() override = default;
  vtkMRMLLabelMapVolumeNode(const vtkMRMLLabelMapVolumeNode&) = delete;
  void operator=(const vtkMRMLLabelMapVolumeNode&) = delete;
};
