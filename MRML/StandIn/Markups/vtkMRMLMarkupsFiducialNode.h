#pragma once

#include "vtkMRMLMarkupsNode.h"

/// A list of points.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsFiducialNode : public vtkMRMLMarkupsNode
{
public:
  static vtkMRMLMarkupsFiducialNode* New();
  vtkTypeMacro(vtkMRMLMarkupsFiducialNode, vtkMRMLMarkupsNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsFiducial"; }
  const char* GetMarkupType() override { return "Fiducial"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentDefaultMacro(vtkMRMLMarkupsFiducialNode);
  vtkSetMacro(MaximumNumberOfControlPoints, int);
  vtkSetMacro(RequiredNumberOfControlPoints, int);

protected:
  vtkMRMLMarkupsFiducialNode() = default;
  ~vtkMRMLMarkupsFiducialNode() override = default;
  vtkMRMLMarkupsFiducialNode(const vtkMRMLMarkupsFiducialNode&) = delete;
  void operator=(const vtkMRMLMarkupsFiducialNode&) = delete;

  const char* GetDefaultDisplayNodeClass() override { return "vtkMRMLMarkupsFiducialDisplayNode"; }
};
