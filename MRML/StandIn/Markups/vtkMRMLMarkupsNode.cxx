#include "vtkMRMLMarkupsNode.h"

#include "vtkMRMLEnumText.h"
#include "vtkMRMLMarkupsDisplayNode.h"
#include "vtkMRMLMarkupsJsonStorageNode.h"
#include "vtkMRMLScene.h"

#include <vtkAbstractTransform.h>
#include <vtkBoundingBox.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace
{

const char* const positionStatuses[] = {"undefined", "preview", "defined", "missing"};

} // namespace

vtkMRMLMarkupsNode::vtkMRMLMarkupsNode()
{
  this->ContentModifiedEvents->InsertNextValue(vtkMRMLMarkupsNode::PointModifiedEvent);
}

vtkMRMLMarkupsNode::~vtkMRMLMarkupsNode() = default;

void vtkMRMLMarkupsNode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& point : this->ControlPoints)
  {
    os << indent << "Point " << point->Label << ": " << point->Position[0] << ", "
       << point->Position[1] << ", " << point->Position[2] << "\n";
  }
}

void vtkMRMLMarkupsNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLBooleanMacro(locked, Locked);
  vtkMRMLWriteXMLStdStringMacro(controlPointLabelFormat, ControlPointLabelFormat);
  vtkMRMLWriteXMLMatrix4x4Macro(interactionHandleToWorldMatrix, InteractionHandleToWorldMatrix);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLMarkupsNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->RemoveAllControlPoints();
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLBooleanMacro(locked, Locked);
  vtkMRMLReadXMLStdStringMacro(markupLabelFormat, ControlPointLabelFormat); // Slicer 4
  vtkMRMLReadXMLStdStringMacro(controlPointLabelFormat, ControlPointLabelFormat);
  vtkMRMLReadXMLOwnedMatrix4x4Macro(interactionHandleToWorldMatrix, InteractionHandleToWorldMatrix);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLMarkupsNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  auto* source = vtkMRMLMarkupsNode::SafeDownCast(anode);
  if (!source)
  {
    return;
  }
  this->SetLocked(source->Locked);
  this->SetControlPointLabelFormat(source->ControlPointLabelFormat);
  this->InteractionHandleToWorldMatrix->DeepCopy(source->InteractionHandleToWorldMatrix);
  this->RequiredNumberOfControlPoints = source->RequiredNumberOfControlPoints;
  this->MaximumNumberOfControlPoints = source->MaximumNumberOfControlPoints;
  this->CurveClosed = source->CurveClosed;
  this->FixedNumberOfControlPoints = false;
  this->RemoveAllControlPoints();
  for (const auto& point : source->ControlPoints)
  {
    this->AddControlPoint(new ControlPoint(*point), false);
  }
  this->LastUsedControlPointNumber = source->LastUsedControlPointNumber;
  this->SetFixedNumberOfControlPoints(source->FixedNumberOfControlPoints);
}

vtkMRMLStorageNode* vtkMRMLMarkupsNode::CreateDefaultStorageNode()
{
  return vtkMRMLMarkupsJsonStorageNode::New();
}

void vtkMRMLMarkupsNode::CreateDefaultDisplayNodes()
{
  if (!this->GetMarkupsDisplayNode() && this->GetScene())
  {
    this->SetAndObserveDisplayNodeID(
        this->GetScene()->AddNewNodeByClass(this->GetDefaultDisplayNodeClass())->GetID());
  }
}

vtkMRMLMarkupsDisplayNode* vtkMRMLMarkupsNode::GetMarkupsDisplayNode()
{
  return vtkMRMLMarkupsDisplayNode::SafeDownCast(this->GetDisplayNode());
}

const char* vtkMRMLMarkupsNode::GetPositionStatusAsString(int id)
{
  return vtkMRMLEnumText(positionStatuses, id);
}

int vtkMRMLMarkupsNode::GetPositionStatusFromString(const char* name)
{
  return vtkMRMLEnumFromText(positionStatuses, name);
}

void vtkMRMLMarkupsNode::SetLocked(int locked)
{
  if (this->Locked != locked)
  {
    this->Locked = locked;
    this->StorableModified();
    this->Modified();
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::LockModifiedEvent);
  }
}

void vtkMRMLMarkupsNode::SetFixedNumberOfControlPoints(bool fixed)
{
  if (this->FixedNumberOfControlPoints != fixed)
  {
    this->FixedNumberOfControlPoints = fixed;
    this->StorableModified();
    this->Modified();
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::FixedNumberOfControlPointsModifiedEvent);
  }
}

void vtkMRMLMarkupsNode::SetControlPointLabelFormat(std::string format)
{
  if (this->ControlPointLabelFormat != format)
  {
    this->ControlPointLabelFormat = format;
    this->StorableModified();
    this->Modified();
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::LabelFormatModifiedEvent);
  }
}

// --- Points that come and go -------------------------------------------------------------------

vtkMRMLMarkupsNode::ControlPoint* vtkMRMLMarkupsNode::GetNthControlPoint(int n)
{
  return this->ControlPointExists(n) ? this->ControlPoints[n].get() : nullptr;
}

vtkMRMLMarkupsNode::ControlPoint* vtkMRMLMarkupsNode::PointForChange(int n, const char* method)
{
  if (!this->ControlPointExists(n))
  {
    vtkErrorMacro(<< method << ": there is no control point " << n);
    return nullptr;
  }
  return this->ControlPoints[n].get();
}

int vtkMRMLMarkupsNode::GetNumberOfDefinedControlPoints(bool includePreview)
{
  return static_cast<int>(std::count_if(this->ControlPoints.begin(), this->ControlPoints.end(),
                                        [includePreview](const auto& point)
                                        {
                                          return point->PositionStatus == PositionDefined ||
                                                 (includePreview &&
                                                  point->PositionStatus == PositionPreview);
                                        }));
}

void vtkMRMLMarkupsNode::PointsModified(int event, int pointIndex)
{
  this->StorableModified();
  this->OnControlPointsChanged();
  this->InvokeCustomModifiedEvent(event, &pointIndex);
  if (event != vtkMRMLMarkupsNode::PointModifiedEvent)
  {
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::PointModifiedEvent, &pointIndex);
  }
  this->Modified();
}

bool vtkMRMLMarkupsNode::HasRoomFor(const char* method)
{
  const int count = this->GetNumberOfControlPoints();
  if (this->FixedNumberOfControlPoints ||
      (this->MaximumNumberOfControlPoints >= 0 && count >= this->MaximumNumberOfControlPoints))
  {
    vtkErrorMacro(<< method << ": the node takes no more control points than its " << count);
    return false;
  }
  return true;
}

void vtkMRMLMarkupsNode::InsertPoint(std::unique_ptr<ControlPoint> point, int index)
{
  const bool defined = point->PositionStatus == PositionDefined;
  if (point->ID.empty())
  {
    point->ID = std::to_string(++this->LastUsedControlPointNumber);
  }
  this->ControlPoints.insert(this->ControlPoints.begin() + index, std::move(point));
  this->PointsModified(vtkMRMLMarkupsNode::PointAddedEvent, index);
  if (defined)
  {
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::PointPositionDefinedEvent, &index);
  }
}

std::string vtkMRMLMarkupsNode::LabelOf(int number)
{
  std::string label = this->ControlPointLabelFormat;
  vtksys::SystemTools::ReplaceString(label, "%N", this->GetName() ? this->GetName() : "");
  vtksys::SystemTools::ReplaceString(label, "%d", std::to_string(number));
  return label;
}

int vtkMRMLMarkupsNode::AddControlPoint(ControlPoint* controlPoint, bool autoLabel)
{
  std::unique_ptr<ControlPoint> point(controlPoint);
  if (!point || !this->HasRoomFor("AddControlPoint"))
  {
    return -1;
  }
  if (point->ID.empty())
  {
    point->ID = std::to_string(++this->LastUsedControlPointNumber);
  }
  if (point->Label.empty() && autoLabel)
  {
    point->Label = this->LabelOf(this->LastUsedControlPointNumber);
  }
  this->InsertPoint(std::move(point), this->GetNumberOfControlPoints());
  return this->GetNumberOfControlPoints() - 1;
}

int vtkMRMLMarkupsNode::AddNControlPoints(int n, std::string label, vtkVector3d* point)
{
  int index = -1;
  for (int i = 0; i < n; ++i)
  {
    auto* added = new ControlPoint;
    added->Label = label;
    added->PositionStatus = point ? PositionDefined : PositionUndefined;
    for (int axis = 0; point && axis < 3; ++axis)
    {
      added->Position[axis] = (*point)[axis];
    }
    index = this->AddControlPoint(added);
  }
  return index;
}

int vtkMRMLMarkupsNode::AddControlPoint(vtkVector3d point, std::string label)
{
  return this->AddNControlPoints(1, label, &point);
}

int vtkMRMLMarkupsNode::AddControlPoint(double point[3], std::string label)
{
  return this->AddControlPoint(vtkVector3d(point), label);
}

int vtkMRMLMarkupsNode::AddControlPoint(double x, double y, double z, std::string label)
{
  return this->AddControlPoint(vtkVector3d(x, y, z), label);
}

int vtkMRMLMarkupsNode::AddControlPointWorld(vtkVector3d point, std::string label)
{
  vtkVector3d local;
  this->TransformPointFromWorld(point, local);
  return this->AddControlPoint(local, label);
}

int vtkMRMLMarkupsNode::AddControlPointWorld(double point[3], std::string label)
{
  return this->AddControlPointWorld(vtkVector3d(point), label);
}

int vtkMRMLMarkupsNode::AddControlPointWorld(double x, double y, double z, std::string label)
{
  return this->AddControlPointWorld(vtkVector3d(x, y, z), label);
}

bool vtkMRMLMarkupsNode::InsertControlPoint(int n, double point[3], std::string label)
{
  if (!this->HasRoomFor("InsertControlPoint"))
  {
    return false;
  }
  auto added = std::make_unique<ControlPoint>();
  std::copy(point, point + 3, added->Position);
  added->PositionStatus = PositionDefined;
  added->ID = std::to_string(++this->LastUsedControlPointNumber);
  added->Label = label.empty() ? this->LabelOf(this->LastUsedControlPointNumber) : label;
  this->InsertPoint(std::move(added), std::clamp(n, 0, this->GetNumberOfControlPoints()));
  return true;
}

void vtkMRMLMarkupsNode::RemoveNthControlPoint(int pointIndex)
{
  if (!this->PointForChange(pointIndex, "RemoveNthControlPoint"))
  {
    return;
  }
  if (this->FixedNumberOfControlPoints)
  {
    vtkErrorMacro("RemoveNthControlPoint: the number of control points is fixed");
    return;
  }
  this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::PointAboutToBeRemovedEvent, &pointIndex);
  this->ControlPoints.erase(this->ControlPoints.begin() + pointIndex);
  this->PointsModified(vtkMRMLMarkupsNode::PointRemovedEvent, pointIndex);
}

void vtkMRMLMarkupsNode::RemoveAllControlPoints()
{
  if (this->ControlPoints.empty())
  {
    return;
  }
  if (this->FixedNumberOfControlPoints)
  {
    vtkErrorMacro("RemoveAllControlPoints: the number of control points is fixed");
    return;
  }
  this->ControlPoints.clear();
  this->PointsModified(vtkMRMLMarkupsNode::PointRemovedEvent, -1);
}

// --- Positions ---------------------------------------------------------------------------------

double* vtkMRMLMarkupsNode::GetNthControlPointPosition(int pointIndex)
{
  this->GetNthControlPointPosition(pointIndex, this->PositionCopy);
  return this->PositionCopy;
}

void vtkMRMLMarkupsNode::GetNthControlPointPosition(int pointIndex, double point[3])
{
  std::fill(point, point + 3, 0.0);
  if (const ControlPoint* found = this->PointForChange(pointIndex, "GetNthControlPointPosition"))
  {
    std::copy(found->Position, found->Position + 3, point);
  }
}

vtkVector3d vtkMRMLMarkupsNode::GetNthControlPointPositionVector(int pointIndex)
{
  return vtkVector3d(this->GetNthControlPointPosition(pointIndex));
}

int vtkMRMLMarkupsNode::GetNthControlPointPositionWorld(int pointIndex, double worldxyz[3])
{
  double local[3];
  this->GetNthControlPointPosition(pointIndex, local);
  this->TransformPointToWorld(local, worldxyz);
  return this->ControlPointExists(pointIndex) ? 1 : 0;
}

vtkVector3d vtkMRMLMarkupsNode::GetNthControlPointPositionWorld(int pointIndex)
{
  vtkVector3d world;
  this->GetNthControlPointPositionWorld(pointIndex, world.GetData());
  return world;
}

void vtkMRMLMarkupsNode::SetNthControlPointPosition(const int pointIndex, const double position[3],
                                                    int positionStatus)
{
  ControlPoint* point = this->PointForChange(pointIndex, "SetNthControlPointPosition");
  if (!point)
  {
    return;
  }
  const int before = point->PositionStatus;
  std::copy(position, position + 3, point->Position);
  point->PositionStatus = positionStatus;
  this->PointsModified(vtkMRMLMarkupsNode::PointModifiedEvent, pointIndex);
  int index = pointIndex;
  if (before != PositionDefined && positionStatus == PositionDefined)
  {
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::PointPositionDefinedEvent, &index);
  }
  else if (before == PositionDefined && positionStatus != PositionDefined)
  {
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::PointPositionUndefinedEvent, &index);
  }
}

void vtkMRMLMarkupsNode::SetNthControlPointPosition(const int pointIndex, const double x,
                                                    const double y, const double z,
                                                    int positionStatus)
{
  const double position[3] = {x, y, z};
  this->SetNthControlPointPosition(pointIndex, position, positionStatus);
}

void vtkMRMLMarkupsNode::SetNthControlPointPositionWorld(const int pointIndex,
                                                         const double position[3],
                                                         int positionStatus)
{
  double local[3];
  this->TransformPointFromWorld(position, local);
  this->SetNthControlPointPosition(pointIndex, local, positionStatus);
}

void vtkMRMLMarkupsNode::SetNthControlPointPositionWorld(const int pointIndex, const double x,
                                                         const double y, const double z,
                                                         int positionStatus)
{
  const double position[3] = {x, y, z};
  this->SetNthControlPointPositionWorld(pointIndex, position, positionStatus);
}

void vtkMRMLMarkupsNode::SetControlPointPositionsWorld(vtkPoints* points)
{
  MRMLNodeModifyBlocker blocker(this);
  const auto count = points ? static_cast<int>(points->GetNumberOfPoints()) : 0;
  while (this->GetNumberOfControlPoints() > count && !this->FixedNumberOfControlPoints)
  {
    this->RemoveNthControlPoint(this->GetNumberOfControlPoints() - 1);
  }
  for (int i = 0; i < count; ++i)
  {
    if (i < this->GetNumberOfControlPoints())
    {
      this->SetNthControlPointPositionWorld(i, points->GetPoint(i));
    }
    else
    {
      this->AddControlPointWorld(vtkVector3d(points->GetPoint(i)));
    }
  }
}

void vtkMRMLMarkupsNode::GetControlPointPositionsWorld(vtkPoints* points)
{
  points->SetNumberOfPoints(this->GetNumberOfControlPoints());
  for (int i = 0; i < this->GetNumberOfControlPoints(); ++i)
  {
    points->SetPoint(i, this->GetNthControlPointPositionWorld(i).GetData());
  }
}

int vtkMRMLMarkupsNode::GetNthControlPointPositionStatus(int pointIndex)
{
  const ControlPoint* point = this->GetNthControlPoint(pointIndex);
  return point ? point->PositionStatus : static_cast<int>(PositionUndefined);
}

void vtkMRMLMarkupsNode::UnsetNthControlPointPosition(int pointIndex)
{
  ControlPoint* point = this->PointForChange(pointIndex, "UnsetNthControlPointPosition");
  if (point && point->PositionStatus != PositionUndefined)
  {
    point->PositionStatus = PositionUndefined;
    this->PointsModified(vtkMRMLMarkupsNode::PointModifiedEvent, pointIndex);
    this->InvokeCustomModifiedEvent(vtkMRMLMarkupsNode::PointPositionUndefinedEvent, &pointIndex);
  }
}

// --- Other properties of points ----------------------------------------------------------------

double* vtkMRMLMarkupsNode::GetNthControlPointOrientationMatrix(int n)
{
  ControlPoint* point = this->PointForChange(n, "GetNthControlPointOrientationMatrix");
  return point ? point->OrientationMatrix : nullptr;
}

void vtkMRMLMarkupsNode::SetNthControlPointOrientationMatrix(int n, double orientationMatrix[9])
{
  if (ControlPoint* point = this->PointForChange(n, "SetNthControlPointOrientationMatrix"))
  {
    std::copy(orientationMatrix, orientationMatrix + 9, point->OrientationMatrix);
    this->PointsModified(vtkMRMLMarkupsNode::PointModifiedEvent, n);
  }
}

std::string vtkMRMLMarkupsNode::GetNthControlPointID(int n)
{
  const ControlPoint* point = this->GetNthControlPoint(n);
  return point ? point->ID : "";
}

int vtkMRMLMarkupsNode::GetNthControlPointIndexByID(const char* controlPointID)
{
  for (int n = 0; controlPointID && n < this->GetNumberOfControlPoints(); ++n)
  {
    if (this->ControlPoints[n]->ID == controlPointID)
    {
      return n;
    }
  }
  return -1;
}

void vtkMRMLMarkupsNode::GetControlPointLabels(vtkStringArray* labels)
{
  labels->Reset();
  for (const auto& point : this->ControlPoints)
  {
    labels->InsertNextValue(point->Label);
  }
}

/// Get and Set of one member of a control point.
#define vtkMRMLControlPointMemberMacro(Type, Member, otherwise)                                    \
  Type vtkMRMLMarkupsNode::GetNthControlPoint##Member(int n)                                       \
  {                                                                                                \
    const ControlPoint* point = this->GetNthControlPoint(n);                                       \
    return point ? point->Member : otherwise;                                                      \
  }                                                                                                \
  void vtkMRMLMarkupsNode::SetNthControlPoint##Member(int n, Type value)                           \
  {                                                                                                \
    ControlPoint* point = this->PointForChange(n, "SetNthControlPoint" #Member);                   \
    if (point && point->Member != value)                                                           \
    {                                                                                              \
      point->Member = value;                                                                       \
      this->PointsModified(vtkMRMLMarkupsNode::PointModifiedEvent, n);                             \
    }                                                                                              \
  }

vtkMRMLControlPointMemberMacro(std::string, Label, std::string());
vtkMRMLControlPointMemberMacro(std::string, Description, std::string());
vtkMRMLControlPointMemberMacro(std::string, AssociatedNodeID, std::string());
vtkMRMLControlPointMemberMacro(bool, Selected, false);
vtkMRMLControlPointMemberMacro(bool, Locked, false);
vtkMRMLControlPointMemberMacro(bool, Visibility, false);

// --- Frame -------------------------------------------------------------------------------------

bool vtkMRMLMarkupsNode::CanApplyNonLinearTransforms() const
{
  return true;
}

void vtkMRMLMarkupsNode::ApplyTransform(vtkAbstractTransform* transform)
{
  MRMLNodeModifyBlocker blocker(this);
  for (int n = 0; n < this->GetNumberOfControlPoints(); ++n)
  {
    double moved[3];
    transform->TransformPoint(this->GetNthControlPointPosition(n), moved);
    this->SetNthControlPointPosition(n, moved, this->GetNthControlPointPositionStatus(n));
  }
}

void vtkMRMLMarkupsNode::BoundsOfPoints(bool world, double bounds[6])
{
  this->vtkMRMLDisplayableNode::GetBounds(bounds);
  vtkBoundingBox box;
  for (int n = 0; n < this->GetNumberOfControlPoints(); ++n)
  {
    if (this->GetNthControlPointPositionStatus(n) == PositionDefined)
    {
      vtkVector3d point = world ? this->GetNthControlPointPositionWorld(n)
                                : this->GetNthControlPointPositionVector(n);
      box.AddPoint(point.GetData());
    }
  }
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
}

void vtkMRMLMarkupsNode::GetRASBounds(double bounds[6])
{
  this->BoundsOfPoints(true, bounds);
}

void vtkMRMLMarkupsNode::GetBounds(double bounds[6])
{
  this->BoundsOfPoints(false, bounds);
}

vtkMatrix4x4* vtkMRMLMarkupsNode::GetInteractionHandleToWorldMatrix()
{
  return this->InteractionHandleToWorldMatrix;
}
