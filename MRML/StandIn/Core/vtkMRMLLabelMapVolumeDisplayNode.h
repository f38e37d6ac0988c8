#pragma once

#include "vtkMRMLVolumeDisplayNode.h"

/// How is a label map seen in slices.
class VTK_MRML_EXPORT vtkMRMLLabelMapVolumeDisplayNode : public vtkMRMLVolumeDisplayNode
{
public:
  static vtkMRMLLabelMapVolumeDisplayNode* New();
  vtkTypeMacro(vtkMRMLLabelMapVolumeDisplayNode, vtkMRMLVolumeDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "LabelMapVolumeDisplay"; }
  vtkMRMLCopyContentDefaultMacro(vtkMRMLLabelMapVolumeDisplayNode);
  void SetDefaultColorMap() override;

protected:
  vtkMRMLLabelMapVolumeDisplayNode() = default;
  ~vtkMRMLLabelMapVolumeDisplayNode() override = default;
  vtkMRMLLabelMapVolumeDisplayNode(const vtkMRMLLabelMapVolumeDisplayNode&) = delete;
  void operator=(const vtkMRMLLabelMapVolumeDisplayNode&) = delete;
};
