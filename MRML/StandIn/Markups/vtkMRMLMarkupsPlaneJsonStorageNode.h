#pragma once

#include "vtkMRMLMarkupsJsonStorageNode.h"

/// A plane's .mrk.json file.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsPlaneJsonStorageNode
    : public vtkMRMLMarkupsJsonStorageNode
{
public:
  static vtkMRMLMarkupsPlaneJsonStorageNode* New();
  vtkTypeMacro(vtkMRMLMarkupsPlaneJsonStorageNode, vtkMRMLMarkupsJsonStorageNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsPlaneJsonStorage"; }
  bool CanReadInReferenceNode(vtkMRMLNode* refNode) override;

protected:
  vtkMRMLMarkupsPlaneJsonStorageNode() = default;
  ~vtkMRMLMarkupsPlaneJsonStorageNode() override = default;
  vtkMRMLMarkupsPlaneJsonStorageNode(const vtkMRMLMarkupsPlaneJsonStorageNode&) = delete;
  void operator=(const vtkMRMLMarkupsPlaneJsonStorageNode&) = delete;
};
