#pragma once

#include "vtkMRMLMarkupsDisplayNode.h"

/// How is a list of points seen.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsFiducialDisplayNode
    : public vtkMRMLMarkupsDisplayNode
{
public:
  static vtkMRMLMarkupsFiducialDisplayNode* New();
  vtkTypeMacro(vtkMRMLMarkupsFiducialDisplayNode, vtkMRMLMarkupsDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsFiducialDisplay"; }
  vtkMRMLCopyContentDefaultMacro(vtkMRMLMarkupsFiducialDisplayNode);

protected:
  vtkMRMLMarkupsFiducialDisplayNode();
  ~vtkMRMLMarkupsFiducialDisplayNode() override = default;
  vtkMRMLMarkupsFiducialDisplayNode(const vtkMRMLMarkupsFiducialDisplayNode&) = delete;
  void operator=(const vtkMRMLMarkupsFiducialDisplayNode&) = delete;
};
