#include "vtkMRMLMarkupsCurveNode.h"

#include "vtkMRMLEnumText.h"

#include <vtkCardinalSpline.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsCurveNode);

namespace
{

const char* const curveTypes[] = {"linear", "spline", "kochanekSpline", "polynomial",
                                  "shortestSurfaceDistance"};
const int linear = 0;
const int cardinalSpline = 1;

} // namespace

void vtkMRMLMarkupsCurveNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLEnumMacro(curveType, CurveType);
  vtkMRMLWriteXMLIntMacro(numberOfPointsPerInterpolatingSegment,
                          NumberOfPointsPerInterpolatingSegment);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLMarkupsCurveNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(curveType, CurveType);
  vtkMRMLReadXMLIntMacro(numberOfPointsPerInterpolatingSegment,
                         NumberOfPointsPerInterpolatingSegment);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLMarkupsCurveNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  vtkMRMLCopyBeginMacro(anode);
  vtkMRMLCopyEnumMacro(CurveType);
  vtkMRMLCopyIntMacro(NumberOfPointsPerInterpolatingSegment);
  vtkMRMLCopyEndMacro();
}

void vtkMRMLMarkupsCurveNode::SetCurveType(int type)
{
  if (this->CurveType != type)
  {
    this->CurveType = type;
    this->StorableModified();
    this->Modified();
  }
}

const char* vtkMRMLMarkupsCurveNode::GetCurveTypeAsString(int id)
{
  return vtkMRMLEnumText(curveTypes, id);
}

int vtkMRMLMarkupsCurveNode::GetCurveTypeFromString(const char* name)
{
  return vtkMRMLEnumFromText(curveTypes, name);
}

void vtkMRMLMarkupsCurveNode::SetCurveTypeToLinear()
{
  this->SetCurveType(linear);
}

void vtkMRMLMarkupsCurveNode::SetCurveTypeToCardinalSpline()
{
  this->SetCurveType(cardinalSpline);
}

void vtkMRMLMarkupsCurveNode::SetNumberOfPointsPerInterpolatingSegment(int pointsPerSegment)
{
  const int points = std::clamp(pointsPerSegment, 1, 1000);
  if (this->PointsPerSegment != points)
  {
    this->PointsPerSegment = points;
    this->Modified();
  }
}

vtkPoints* vtkMRMLMarkupsCurveNode::GetCurvePointsWorld()
{
  vtkNew<vtkPoints> controls;
  controls->SetDataTypeToDouble();
  for (int n = 0; n < this->GetNumberOfControlPoints(); ++n)
  {
    if (this->GetNthControlPointPositionStatus(n) == PositionDefined)
    {
      controls->InsertNextPoint(this->GetNthControlPointPositionWorld(n).GetData());
    }
  }
  const auto count = static_cast<int>(controls->GetNumberOfPoints());
  this->CurvePointsWorld->SetDataTypeToDouble();
  this->CurvePointsWorld->Reset();
  if (count < 2)
  {
    this->CurvePointsWorld->DeepCopy(controls);
    return this->CurvePointsWorld;
  }
  vtkNew<vtkCardinalSpline> splines[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    splines[axis]->SetClosed(this->CurveClosed);
    for (int n = 0; n < count; ++n)
    {
      splines[axis]->AddPoint(n, controls->GetPoint(n)[axis]);
    }
  }
  const int segments = this->CurveClosed ? count : count - 1;
  for (int step = 0; step <= segments * this->PointsPerSegment; ++step)
  {
    const double at = static_cast<double>(step) / this->PointsPerSegment;
    const auto first = std::min(static_cast<int>(at), segments - 1);
    double a[3];
    double b[3];
    controls->GetPoint(first % count, a);
    controls->GetPoint((first + 1) % count, b);
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = this->CurveType == linear ? a[axis] + (at - first) * (b[axis] - a[axis])
                                              : splines[axis]->Evaluate(at);
    }
    this->CurvePointsWorld->InsertNextPoint(point);
  }
  return this->CurvePointsWorld;
}

double vtkMRMLMarkupsCurveNode::GetCurveLengthWorld()
{
  vtkPoints* points = this->GetCurvePointsWorld();
  double length = 0.0;
  for (vtkIdType i = 1; i < points->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    points->GetPoint(i - 1, a);
    points->GetPoint(i, b);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
  }
  return length;
}
