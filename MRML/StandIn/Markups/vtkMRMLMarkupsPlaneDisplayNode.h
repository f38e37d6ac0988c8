#pragma once

#include "vtkMRMLMarkupsDisplayNode.h"

/// How is a plane seen.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsPlaneDisplayNode
    : public vtkMRMLMarkupsDisplayNode
{
public:
  static vtkMRMLMarkupsPlaneDisplayNode* New();
  vtkTypeMacro(vtkMRMLMarkupsPlaneDisplayNode, vtkMRMLMarkupsDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsPlaneDisplay"; }
  vtkMRMLCopyContentDefaultMacro(vtkMRMLMarkupsPlaneDisplayNode);

protected:
  vtkMRMLMarkupsPlaneDisplayNode();
  ~vtkMRMLMarkupsPlaneDisplayNode() override = default;
  vtkMRMLMarkupsPlaneDisplayNode(const vtkMRMLMarkupsPlaneDisplayNode&) = delete;
  void operator=(const vtkMRMLMarkupsPlaneDisplayNode&) = delete;
};
