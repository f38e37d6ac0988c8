#pragma once

#include "vtkMRMLDisplayableNode.h"
#include "vtkSlicerMarkupsModuleMRMLExport.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkVector.h>

#include <memory>

class vtkMRMLMarkupsDisplayNode;
class vtkPoints;
class vtkStringArray;

/// Control points, in the node's own frame (RAS [mm]) or, where a name says so, in the world.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsNode : public vtkMRMLDisplayableNode
{
public:
  enum
  {
    PositionUndefined,
    PositionPreview,
    PositionDefined,
    PositionMissing,
    PositionStatus_Last
  };
  struct ControlPoint
  {
    double Position[3] = {0.0, 0.0, 0.0};
    double OrientationMatrix[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    std::string ID;
    std::string Label;
    std::string Description;
    std::string AssociatedNodeID;
    bool Selected = true;
    bool Locked = false;
    bool Visibility = true;
    int PositionStatus = PositionUndefined;
    bool AutoCreated = false;
  };

  vtkTypeMacro(vtkMRMLMarkupsNode, vtkMRMLDisplayableNode);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  virtual const char* GetMarkupType() { return "Markup"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLMarkupsNode);
  vtkMRMLStorageNode* CreateDefaultStorageNode() override;
  void CreateDefaultDisplayNodes() override;
  vtkMRMLMarkupsDisplayNode* GetMarkupsDisplayNode();

  enum
  {
    LockModifiedEvent = 19000,
    LabelFormatModifiedEvent,
    PointAddedEvent,
    PointRemovedEvent,
    PointPositionDefinedEvent,
    PointPositionUndefinedEvent,
    PointPositionMissingEvent,
    PointPositionNonMissingEvent,
    PointModifiedEvent,
    PointStartInteractionEvent,
    PointEndInteractionEvent,
    CenterOfRotationModifiedEvent,
    FixedNumberOfControlPointsModifiedEvent,
    PointAboutToBeRemovedEvent,
  };
  static const char* GetPositionStatusAsString(int id);
  static int GetPositionStatusFromString(const char* name);

  vtkGetMacro(Locked, int);
  void SetLocked(int locked);
  vtkBooleanMacro(Locked, int);
  bool GetFixedNumberOfControlPoints() { return this->FixedNumberOfControlPoints; }
  void SetFixedNumberOfControlPoints(bool fixed);
  vtkGetMacro(RequiredNumberOfControlPoints, int);
  vtkGetMacro(MaximumNumberOfControlPoints, int);
  vtkGetMacro(CurveClosed, bool);
  vtkGetMacro(LastUsedControlPointNumber, int);
  vtkSetMacro(LastUsedControlPointNumber, int);
  /// "%N" stands for the node's name, "%d" for the point's number.
  std::string GetControlPointLabelFormat() { return this->ControlPointLabelFormat; }
  void SetControlPointLabelFormat(std::string format);

  /// \name Control points; an index out of range is an error and changes nothing
  ///@{
  int GetNumberOfControlPoints() { return static_cast<int>(this->ControlPoints.size()); }
  int GetNumberOfDefinedControlPoints(bool includePreview = false);
  bool ControlPointExists(int n) { return n >= 0 && n < this->GetNumberOfControlPoints(); }
  ControlPoint* GetNthControlPoint(int n);
  /// \return the new point's index, -1 where there is no room for it
  int AddControlPoint(vtkVector3d point, std::string label = std::string());
  int AddControlPoint(double point[3], std::string label = std::string());
  int AddControlPoint(double x, double y, double z, std::string label = std::string());
  /// Takes the point over.
  int AddControlPoint(ControlPoint* controlPoint, bool autoLabel = true);
  int AddControlPointWorld(vtkVector3d point, std::string label = std::string());
  int AddControlPointWorld(double point[3], std::string label = std::string());
  int AddControlPointWorld(double x, double y, double z, std::string label = std::string());
  int AddNControlPoints(int n, std::string label = std::string(), vtkVector3d* point = nullptr);
  bool InsertControlPoint(int n, double point[3], std::string label = std::string());
  void RemoveNthControlPoint(int pointIndex);
  virtual void RemoveAllControlPoints();

  double* GetNthControlPointPosition(int pointIndex) VTK_SIZEHINT(3);
  void GetNthControlPointPosition(int pointIndex, double point[3]);
  vtkVector3d GetNthControlPointPositionVector(int pointIndex);
  int GetNthControlPointPositionWorld(int pointIndex, double worldxyz[3]);
  vtkVector3d GetNthControlPointPositionWorld(int pointIndex);
  void SetNthControlPointPosition(const int pointIndex, const double x, const double y,
                                  const double z, int positionStatus = PositionDefined);
  void SetNthControlPointPosition(const int pointIndex, const double position[3],
                                  int positionStatus = PositionDefined);
  void SetNthControlPointPositionWorld(const int pointIndex, const double x, const double y,
                                       const double z, int positionStatus = PositionDefined);
  void SetNthControlPointPositionWorld(const int pointIndex, const double position[3],
                                       int positionStatus = PositionDefined);
  void SetControlPointPositionsWorld(vtkPoints* points);
  void GetControlPointPositionsWorld(vtkPoints* points);
  int GetNthControlPointPositionStatus(int pointIndex);
  void UnsetNthControlPointPosition(int pointIndex);

  double* GetNthControlPointOrientationMatrix(int n) VTK_SIZEHINT(9);
  void SetNthControlPointOrientationMatrix(int n, double orientationMatrix[9]);
  std::string GetNthControlPointID(int n);
  int GetNthControlPointIndexByID(const char* controlPointID);
  std::string GetNthControlPointLabel(int n = 0);
  void SetNthControlPointLabel(int n, std::string label);
  void GetControlPointLabels(vtkStringArray* labels);
  std::string GetNthControlPointDescription(int n = 0);
  void SetNthControlPointDescription(int n, std::string description);
  std::string GetNthControlPointAssociatedNodeID(int n = 0);
  void SetNthControlPointAssociatedNodeID(int n, std::string id);
  bool GetNthControlPointSelected(int n = 0);
  void SetNthControlPointSelected(int n, bool flag);
  bool GetNthControlPointLocked(int n = 0);
  void SetNthControlPointLocked(int n, bool flag);
  bool GetNthControlPointVisibility(int n = 0);
  void SetNthControlPointVisibility(int n, bool flag);
  ///@}

  bool CanApplyNonLinearTransforms() const override;
  void ApplyTransform(vtkAbstractTransform* transform) override;
  void GetRASBounds(double bounds[6]) override;
  void GetBounds(double bounds[6]) override;
  virtual vtkMatrix4x4* GetInteractionHandleToWorldMatrix();

protected:
  vtkMRMLMarkupsNode();
  ~vtkMRMLMarkupsNode() override;
  vtkMRMLMarkupsNode(const vtkMRMLMarkupsNode&) = delete;
  void operator=(const vtkMRMLMarkupsNode&) = delete;

  virtual const char* GetDefaultDisplayNodeClass() { return "vtkMRMLMarkupsDisplayNode"; }
  /// Called after points have come, gone or moved.
  virtual void OnControlPointsChanged() {}

  int RequiredNumberOfControlPoints = 0;
  int MaximumNumberOfControlPoints = -1; ///< negative: any
  bool CurveClosed = false;
  int Locked = 0;
  bool FixedNumberOfControlPoints = false;
  std::string ControlPointLabelFormat = "%N-%d";
  int LastUsedControlPointNumber = 0;
  vtkNew<vtkMatrix4x4> InteractionHandleToWorldMatrix;

private:
  ControlPoint* PointForChange(int n, const char* method);
  bool HasRoomFor(const char* method);
  void InsertPoint(std::unique_ptr<ControlPoint> point, int index);
  void PointsModified(int event, int pointIndex);
  std::string LabelOf(int number);
  void BoundsOfPoints(bool world, double bounds[6]);

  std::vector<std::unique_ptr<ControlPoint>> ControlPoints;
  double PositionCopy[3] = {0.0, 0.0, 0.0};
};
