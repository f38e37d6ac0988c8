#pragma once

#include "vtkMRMLMarkupsCurveNode.h"

/// A curve that returns to its first control point.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsClosedCurveNode
    : public vtkMRMLMarkupsCurveNode
{
public:
  static vtkMRMLMarkupsClosedCurveNode* New();
  vtkTypeMacro(vtkMRMLMarkupsClosedCurveNode, vtkMRMLMarkupsCurveNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsClosedCurve"; }
  const char* GetMarkupType() override { return "ClosedCurve"; }
  vtkMRMLCopyContentDefaultMacro(vtkMRMLMarkupsClosedCurveNode);

protected:
  vtkMRMLMarkupsClosedCurveNode();
  ~vtkMRMLMarkupsClosedCurveNode() override = default;
  vtkMRMLMarkupsClosedCurveNode(const vtkMRMLMarkupsClosedCurveNode&) = delete;
  void operator=(const vtkMRMLMarkupsClosedCurveNode&) = delete;
};
