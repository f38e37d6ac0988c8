#pragma once

#include "vtkMRMLDisplayNode.h"

class vtkMRMLVolumeNode;

/// How is a volume seen in slices.
class VTK_MRML_EXPORT vtkMRMLVolumeDisplayNode : public vtkMRMLDisplayNode
{
public:
  vtkTypeMacro(vtkMRMLVolumeDisplayNode, vtkMRMLDisplayNode);
  const char* GetNodeTagName() override = 0;
  vtkMRMLCopyContentMacro(vtkMRMLVolumeDisplayNode);
  /// Names Slicer's colours for the class of volume; nothing here draws with them.
  virtual void SetDefaultColorMap() {}
  vtkMRMLVolumeNode* GetVolumeNode();

protected:
  vtkMRMLVolumeDisplayNode() = default;
  ~vtkMRMLVolumeDisplayNode() override = default;
  vtkMRMLVolumeDisplayNode(const vtkMRMLVolumeDisplayNode&) = delete;
  void operator=(const vtkMRMLVolumeDisplayNode&) = delete;
};
