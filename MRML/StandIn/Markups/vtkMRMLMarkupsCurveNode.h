#pragma once

#include "vtkMRMLMarkupsNode.h"

#include <vtkPoints.h>

/// A line through control points: straight pieces, or a cardinal spline; Slicer's other types are kept
/// by name and drawn as the spline.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsCurveNode : public vtkMRMLMarkupsNode
{
public:
  static vtkMRMLMarkupsCurveNode* New();
  vtkTypeMacro(vtkMRMLMarkupsCurveNode, vtkMRMLMarkupsNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsCurve"; }
  const char* GetMarkupType() override { return "Curve"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLMarkupsCurveNode);

  int GetCurveType() { return this->CurveType; }
  void SetCurveType(int type);
  /// "linear", "spline", ...
  const char* GetCurveTypeAsString(int id);
  int GetCurveTypeFromString(const char* name);
  void SetCurveTypeToLinear();
  void SetCurveTypeToCardinalSpline();
  int GetNumberOfPointsPerInterpolatingSegment() { return this->PointsPerSegment; }
  void SetNumberOfPointsPerInterpolatingSegment(int pointsPerSegment);

  /// Points along the curve, from the first control point to the last, or back to the first where it
  /// is closed; valid until the next call.
  vtkPoints* GetCurvePointsWorld();
  double GetCurveLengthWorld();

protected:
  vtkMRMLMarkupsCurveNode() = default;
  ~vtkMRMLMarkupsCurveNode() override = default;
  vtkMRMLMarkupsCurveNode(const vtkMRMLMarkupsCurveNode&) = delete;
  void operator=(const vtkMRMLMarkupsCurveNode&) = delete;

private:
  int CurveType = 1;
  int PointsPerSegment = 10;
  vtkNew<vtkPoints> CurvePointsWorld;
};
