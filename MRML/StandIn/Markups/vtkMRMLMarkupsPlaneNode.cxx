#include "vtkMRMLMarkupsPlaneNode.h"

#include "vtkMRMLEnumText.h"
#include "vtkMRMLMarkupsPlaneJsonStorageNode.h"
#include "vtkMRMLTransformNode.h"

#include <vtkAbstractTransform.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsPlaneNode);

namespace
{

const char* const planeTypes[] = {"threePoints", "pointNormal", "planeFit"};
const char* const sizeModes[] = {"auto", "absolute"};

void GetColumn(vtkMatrix4x4* matrix, int column, double values[3])
{
  for (int row = 0; row < 3; ++row)
  {
    values[row] = matrix->GetElement(row, column);
  }
}

void SetColumn(vtkMatrix4x4* matrix, int column, const double values[3])
{
  for (int row = 0; row < 3; ++row)
  {
    matrix->SetElement(row, column, values[row]);
  }
}

/// The rotation that takes one unit vector to another by the shortest way.
void RotationBetween(const double from[3], const double to[3], double rotation[3][3])
{
  double axis[3];
  vtkMath::Cross(from, to, axis);
  const double sine = vtkMath::Norm(axis);
  const double cosine = vtkMath::Dot(from, to);
  if (sine < 1e-12)
  {
    vtkMath::Perpendiculars(from, axis, nullptr, 0.0); // opposite: any axis across
  }
  vtkMath::Normalize(axis);
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    rotation[i][i] = cosine + axis[i] * axis[i] * (1.0 - cosine);
    rotation[i][j] = axis[i] * axis[j] * (1.0 - cosine) - axis[k] * sine;
    rotation[j][i] = axis[i] * axis[j] * (1.0 - cosine) + axis[k] * sine;
  }
  if (sine < 1e-12 && cosine > 0.0)
  {
    vtkMath::Identity3x3(rotation);
  }
}

} // namespace

vtkMRMLMarkupsPlaneNode::vtkMRMLMarkupsPlaneNode()
{
  this->SetLimitsOfType();
}

void vtkMRMLMarkupsPlaneNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLIntMacro(maximumNumberOfControlPoints, MaximumNumberOfControlPoints);
  vtkMRMLWriteXMLIntMacro(requiredNumberOfControlPoints, RequiredNumberOfControlPoints);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLMarkupsPlaneNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLIntMacro(maximumNumberOfControlPoints, MaximumNumberOfControlPoints);
  vtkMRMLReadXMLIntMacro(requiredNumberOfControlPoints, RequiredNumberOfControlPoints);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLMarkupsPlaneNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  auto* source = vtkMRMLMarkupsPlaneNode::SafeDownCast(anode);
  if (!source)
  {
    return;
  }
  // The points of the copy shall not define it once more.
  this->IsMovingPlane = true;
  this->Superclass::CopyContent(anode, deepCopy);
  this->IsMovingPlane = false;
  this->PlaneType = source->PlaneType;
  this->SizeMode = source->SizeMode;
  this->AutoSizeScalingFactor = source->AutoSizeScalingFactor;
  this->IsPlaneValid = source->IsPlaneValid;
  std::copy(source->Size, source->Size + 2, this->Size);
  std::copy(source->PlaneBounds, source->PlaneBounds + 4, this->PlaneBounds);
  this->ObjectToBaseMatrix->DeepCopy(source->ObjectToBaseMatrix);
  this->BaseToNodeMatrix->DeepCopy(source->BaseToNodeMatrix);
  this->Modified();
}

vtkMRMLStorageNode* vtkMRMLMarkupsPlaneNode::CreateDefaultStorageNode()
{
  return vtkMRMLMarkupsPlaneJsonStorageNode::New();
}

// --- Type and size -----------------------------------------------------------------------------

const char* vtkMRMLMarkupsPlaneNode::GetPlaneTypeAsString(int planeType)
{
  return vtkMRMLEnumText(planeTypes, planeType);
}

int vtkMRMLMarkupsPlaneNode::GetPlaneTypeFromString(const char* planeType)
{
  return vtkMRMLEnumFromText(planeTypes, planeType);
}

const char* vtkMRMLMarkupsPlaneNode::GetSizeModeAsString(int sizeMode)
{
  return vtkMRMLEnumText(sizeModes, sizeMode);
}

int vtkMRMLMarkupsPlaneNode::GetSizeModeFromString(const char* sizeMode)
{
  return vtkMRMLEnumFromText(sizeModes, sizeMode);
}

void vtkMRMLMarkupsPlaneNode::SetLimitsOfType()
{
  const bool one = this->PlaneType == PlaneTypePointNormal;
  const bool any = this->PlaneType == PlaneTypePlaneFit;
  this->RequiredNumberOfControlPoints = any ? 0 : one ? 1 : 3;
  this->MaximumNumberOfControlPoints = any ? -1 : this->RequiredNumberOfControlPoints;
}

void vtkMRMLMarkupsPlaneNode::SetPlaneType(int planeType)
{
  if (planeType < 0 || planeType >= PlaneType_Last || planeType == this->PlaneType)
  {
    return;
  }
  MRMLNodeModifyBlocker blocker(this);
  this->PlaneType = planeType;
  this->SetLimitsOfType();
  if (planeType == PlaneTypePointNormal && this->IsPlaneValid)
  {
    this->IsMovingPlane = true;
    double origin[3];
    this->GetOrigin(origin);
    this->RemoveAllControlPoints();
    this->AddControlPoint(origin);
    this->IsMovingPlane = false;
  }
  this->OnControlPointsChanged();
  this->StorableModified();
  this->Modified();
}

void vtkMRMLMarkupsPlaneNode::SetSizeMode(int sizeMode)
{
  if (sizeMode >= 0 && sizeMode < SizeMode_Last && sizeMode != this->SizeMode)
  {
    this->SizeMode = sizeMode;
    this->StorableModified();
    this->Modified();
  }
}

void vtkMRMLMarkupsPlaneNode::GetSize(double size[2])
{
  std::copy(this->Size, this->Size + 2, size);
}

void vtkMRMLMarkupsPlaneNode::SetSize(double x, double y)
{
  const double wanted[2] = {x, y};
  double bounds[4];
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int end = 0; end < 2; ++end)
    {
      const double before = this->Size[axis];
      bounds[2 * axis + end] = before > 0.0
                                   ? this->PlaneBounds[2 * axis + end] / before * wanted[axis]
                                   : (end - 0.5) * wanted[axis];
    }
  }
  this->SetPlaneBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
}

void vtkMRMLMarkupsPlaneNode::SetPlaneBounds(double x0, double x1, double y0, double y1)
{
  const double bounds[4] = {x0, x1, y0, y1};
  if (std::equal(bounds, bounds + 4, this->PlaneBounds))
  {
    return;
  }
  std::copy(bounds, bounds + 4, this->PlaneBounds);
  this->Size[0] = x1 - x0;
  this->Size[1] = y1 - y0;
  this->StorableModified();
  this->Modified();
}

void vtkMRMLMarkupsPlaneNode::SetPlaneBounds(double bounds[4])
{
  this->SetPlaneBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
}

// --- From control points -----------------------------------------------------------------------

void vtkMRMLMarkupsPlaneNode::OnControlPointsChanged()
{
  if (this->IsMovingPlane)
  {
    return;
  }
  const int defined = this->GetNumberOfDefinedControlPoints(true);
  this->IsPlaneValid = defined >= (this->PlaneType == PlaneTypePointNormal ? 1 : 3);
  if (!this->IsPlaneValid)
  {
    return;
  }
  if (this->PlaneType == PlaneTypePointNormal)
  {
    SetColumn(this->BaseToNodeMatrix, 3, this->GetNthControlPointPosition(0));
    return;
  }
  if (this->PlaneType == PlaneType3Points)
  {
    this->FrameFrom3Points();
  }
  else
  {
    this->FrameFromFit();
  }
  this->SizeFromPoints();
}

void vtkMRMLMarkupsPlaneNode::FrameFrom3Points()
{
  double points[3][3];
  for (int n = 0; n < 3; ++n)
  {
    this->GetNthControlPointPosition(n, points[n]);
  }
  double x[3];
  double across[3];
  double y[3];
  double z[3];
  vtkMath::Subtract(points[1], points[0], x);
  vtkMath::Subtract(points[2], points[0], across);
  vtkMath::Cross(x, across, z);
  if (vtkMath::Normalize(x) == 0.0 || vtkMath::Normalize(z) == 0.0)
  {
    this->IsPlaneValid = false; // on one line
    return;
  }
  vtkMath::Cross(z, x, y);
  SetColumn(this->BaseToNodeMatrix, 0, x);
  SetColumn(this->BaseToNodeMatrix, 1, y);
  SetColumn(this->BaseToNodeMatrix, 2, z);
  SetColumn(this->BaseToNodeMatrix, 3, points[0]);
}

void vtkMRMLMarkupsPlaneNode::FrameFromFit()
{
  const int count = this->GetNumberOfControlPoints();
  double middle[3] = {0.0, 0.0, 0.0};
  for (int n = 0; n < count; ++n)
  {
    vtkMath::Add(middle, this->GetNthControlPointPosition(n), middle);
  }
  vtkMath::MultiplyScalar(middle, 1.0 / count);
  double spread[3][3] = {};
  for (int n = 0; n < count; ++n)
  {
    double from[3];
    vtkMath::Subtract(this->GetNthControlPointPosition(n), middle, from);
    for (int i = 0; i < 9; ++i)
    {
      spread[i / 3][i % 3] += from[i / 3] * from[i % 3];
    }
  }
  double values[3];
  double vectors[3][3];
  double* rows[3] = {spread[0], spread[1], spread[2]};
  double* columns[3] = {vectors[0], vectors[1], vectors[2]};
  vtkMath::Jacobi(rows, values, columns);
  // The normal is where the points spread least, on the side of the one before.
  double normal[3] = {vectors[0][2], vectors[1][2], vectors[2][2]};
  double before[3];
  GetColumn(this->BaseToNodeMatrix, 2, before);
  if (vtkMath::Dot(normal, before) < 0.0)
  {
    vtkMath::MultiplyScalar(normal, -1.0);
  }
  double rotation[3][3];
  RotationBetween(before, normal, rotation);
  for (int column = 0; column < 3; ++column)
  {
    double axis[3];
    GetColumn(this->BaseToNodeMatrix, column, axis);
    vtkMath::Multiply3x3(rotation, axis, axis);
    SetColumn(this->BaseToNodeMatrix, column, axis);
  }
  SetColumn(this->BaseToNodeMatrix, 3, middle);
}

void vtkMRMLMarkupsPlaneNode::SizeFromPoints()
{
  if (this->SizeMode != SizeModeAuto || !this->IsPlaneValid)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> nodeToBase;
  vtkMatrix4x4::Invert(this->BaseToNodeMatrix, nodeToBase);
  double half[2] = {0.0, 0.0};
  for (int n = 0; n < this->GetNumberOfControlPoints(); ++n)
  {
    const vtkVector3d position = this->GetNthControlPointPositionVector(n);
    double point[4] = {position[0], position[1], position[2], 1.0};
    nodeToBase->MultiplyPoint(point, point);
    half[0] = std::max(half[0], std::abs(point[0]));
    half[1] = std::max(half[1], std::abs(point[1]));
  }
  const double scale = this->AutoSizeScalingFactor;
  this->SetPlaneBounds(-half[0] * scale, half[0] * scale, -half[1] * scale, half[1] * scale);
}

// --- Origin, normal, axes ----------------------------------------------------------------------

void vtkMRMLMarkupsPlaneNode::NodeToWorld(vtkMatrix4x4* matrix)
{
  vtkMRMLTransformNode::GetMatrixTransformBetweenNodes(this->GetParentTransformNode(), nullptr,
                                                       matrix);
}

void vtkMRMLMarkupsPlaneNode::GetObjectToNodeMatrix(vtkMatrix4x4* objectToNodeMatrix)
{
  vtkMatrix4x4::Multiply4x4(this->BaseToNodeMatrix, this->ObjectToBaseMatrix, objectToNodeMatrix);
}

void vtkMRMLMarkupsPlaneNode::GetObjectToWorldMatrix(vtkMatrix4x4* objectToWorldMatrix)
{
  vtkNew<vtkMatrix4x4> toNode;
  vtkNew<vtkMatrix4x4> toWorld;
  this->GetObjectToNodeMatrix(toNode);
  this->NodeToWorld(toWorld);
  vtkMatrix4x4::Multiply4x4(toWorld, toNode, objectToWorldMatrix);
}

/// The control points go along.
void vtkMRMLMarkupsPlaneNode::MovePlane(vtkMatrix4x4* newObjectToNode)
{
  MRMLNodeModifyBlocker blocker(this);
  vtkNew<vtkMatrix4x4> nodeToOldObject;
  this->GetObjectToNodeMatrix(nodeToOldObject);
  nodeToOldObject->Invert();
  vtkNew<vtkMatrix4x4> movement;
  vtkMatrix4x4::Multiply4x4(newObjectToNode, nodeToOldObject, movement);
  vtkMatrix4x4::Multiply4x4(movement, this->BaseToNodeMatrix, this->BaseToNodeMatrix);

  this->IsMovingPlane = true;
  double origin[3];
  GetColumn(newObjectToNode, 3, origin);
  if (this->PlaneType == PlaneTypePointNormal)
  {
    if (this->GetNumberOfControlPoints() == 0)
    {
      this->AddControlPoint(origin);
    }
    // Exactly, so that the frame and its point never part.
    GetColumn(this->BaseToNodeMatrix, 3, origin);
    this->SetNthControlPointPosition(0, origin);
    this->IsPlaneValid = true;
  }
  else
  {
    for (int n = 0; n < this->GetNumberOfControlPoints(); ++n)
    {
      const vtkVector3d position = this->GetNthControlPointPositionVector(n);
      double point[4] = {position[0], position[1], position[2], 1.0};
      movement->MultiplyPoint(point, point);
      this->SetNthControlPointPosition(n, point, this->GetNthControlPointPositionStatus(n));
    }
  }
  this->IsMovingPlane = false;
  this->StorableModified();
  this->Modified();
}

void vtkMRMLMarkupsPlaneNode::GetOrigin(double origin[3])
{
  vtkNew<vtkMatrix4x4> frame;
  this->GetObjectToNodeMatrix(frame);
  GetColumn(frame, 3, origin);
}

void vtkMRMLMarkupsPlaneNode::SetOrigin(const double origin[3])
{
  vtkNew<vtkMatrix4x4> frame;
  this->GetObjectToNodeMatrix(frame);
  SetColumn(frame, 3, origin);
  this->MovePlane(frame);
}

void vtkMRMLMarkupsPlaneNode::SetOrigin(double x, double y, double z)
{
  const double origin[3] = {x, y, z};
  this->SetOrigin(origin);
}

void vtkMRMLMarkupsPlaneNode::GetOriginWorld(double origin[3])
{
  double local[3];
  this->GetOrigin(local);
  this->TransformPointToWorld(local, origin);
}

void vtkMRMLMarkupsPlaneNode::SetOriginWorld(const double origin[3])
{
  double local[3];
  this->TransformPointFromWorld(origin, local);
  this->SetOrigin(local);
}

void vtkMRMLMarkupsPlaneNode::SetOriginWorld(double x, double y, double z)
{
  const double origin[3] = {x, y, z};
  this->SetOriginWorld(origin);
}

void vtkMRMLMarkupsPlaneNode::GetAxes(double x[3], double y[3], double z[3])
{
  vtkNew<vtkMatrix4x4> frame;
  this->GetObjectToNodeMatrix(frame);
  GetColumn(frame, 0, x);
  GetColumn(frame, 1, y);
  GetColumn(frame, 2, z);
}

void vtkMRMLMarkupsPlaneNode::SetAxes(const double x[3], const double y[3], const double z[3])
{
  double across[3];
  vtkMath::Cross(x, y, across);
  if (vtkMath::Dot(across, z) < 1.0 - 1e-5 || std::abs(vtkMath::Dot(x, y)) > 1e-5 ||
      std::abs(vtkMath::Norm(x) - 1.0) > 1e-5 || std::abs(vtkMath::Norm(y) - 1.0) > 1e-5)
  {
    vtkErrorMacro("SetAxes: the axes are not orthonormal and right-handed");
    return;
  }
  vtkNew<vtkMatrix4x4> frame;
  this->GetObjectToNodeMatrix(frame);
  SetColumn(frame, 0, x);
  SetColumn(frame, 1, y);
  SetColumn(frame, 2, z);
  this->MovePlane(frame);
}

void vtkMRMLMarkupsPlaneNode::GetAxesWorld(double x[3], double y[3], double z[3])
{
  vtkNew<vtkMatrix4x4> frame;
  this->GetObjectToWorldMatrix(frame);
  GetColumn(frame, 0, x);
  GetColumn(frame, 1, y);
  vtkMath::Normalize(x);
  vtkMath::Cross(x, y, z);
  vtkMath::Normalize(z);
  vtkMath::Cross(z, x, y);
}

void vtkMRMLMarkupsPlaneNode::SetAxesWorld(const double x[3], const double y[3], const double z[3])
{
  vtkNew<vtkMatrix4x4> toNode;
  this->NodeToWorld(toNode);
  toNode->Invert();
  const double* world[3] = {x, y, z};
  double local[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double direction[4] = {world[axis][0], world[axis][1], world[axis][2], 0.0};
    double turned[4];
    toNode->MultiplyPoint(direction, turned);
    std::copy(turned, turned + 3, local[axis]);
    vtkMath::Normalize(local[axis]);
  }
  this->SetAxes(local[0], local[1], local[2]);
}

void vtkMRMLMarkupsPlaneNode::GetNormal(double normal[3])
{
  double x[3];
  double y[3];
  this->GetAxes(x, y, normal);
}

void vtkMRMLMarkupsPlaneNode::SetNormal(const double normal[3])
{
  double wanted[3] = {normal[0], normal[1], normal[2]};
  if (vtkMath::Normalize(wanted) < 1e-4)
  {
    vtkErrorMacro("SetNormal: the normal has no length");
    return;
  }
  double axes[3][3];
  this->GetAxes(axes[0], axes[1], axes[2]);
  double rotation[3][3];
  RotationBetween(axes[2], wanted, rotation);
  vtkNew<vtkMatrix4x4> frame;
  this->GetObjectToNodeMatrix(frame);
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkMath::Multiply3x3(rotation, axes[axis], axes[axis]);
    SetColumn(frame, axis, axes[axis]);
  }
  SetColumn(frame, 2, wanted);
  this->MovePlane(frame);
}

void vtkMRMLMarkupsPlaneNode::SetNormal(double x, double y, double z)
{
  const double normal[3] = {x, y, z};
  this->SetNormal(normal);
}

void vtkMRMLMarkupsPlaneNode::GetNormalWorld(double normal[3])
{
  double x[3];
  double y[3];
  this->GetAxesWorld(x, y, normal);
}

void vtkMRMLMarkupsPlaneNode::SetNormalWorld(const double normal[3])
{
  // Normals go with the transpose of the matrix back.
  vtkNew<vtkMatrix4x4> back;
  this->NodeToWorld(back);
  back->Transpose();
  const double world[4] = {normal[0], normal[1], normal[2], 0.0};
  double local[4];
  back->MultiplyPoint(world, local);
  this->SetNormal(local);
}

void vtkMRMLMarkupsPlaneNode::SetNormalWorld(double x, double y, double z)
{
  const double normal[3] = {x, y, z};
  this->SetNormalWorld(normal);
}

void vtkMRMLMarkupsPlaneNode::ApplyTransform(vtkAbstractTransform* transform)
{
  double origin[3];
  double axes[3][3];
  this->GetOrigin(origin);
  this->GetAxes(axes[0], axes[1], axes[2]);
  double moved[3];
  transform->TransformPoint(origin, moved);
  double tips[2][3];
  for (int axis = 0; axis < 2; ++axis)
  {
    vtkMath::Add(origin, axes[axis], tips[axis]);
    transform->TransformPoint(tips[axis], tips[axis]);
    vtkMath::Subtract(tips[axis], moved, tips[axis]);
  }
  double z[3];
  vtkMath::Cross(tips[0], tips[1], z);
  if (vtkMath::Normalize(tips[0]) == 0.0 || vtkMath::Normalize(z) == 0.0)
  {
    vtkErrorMacro("ApplyTransform: the transform leaves no plane");
    return;
  }
  vtkMath::Cross(z, tips[0], tips[1]);
  vtkNew<vtkMatrix4x4> frame;
  SetColumn(frame, 0, tips[0]);
  SetColumn(frame, 1, tips[1]);
  SetColumn(frame, 2, z);
  SetColumn(frame, 3, moved);
  this->MovePlane(frame);
}
