#pragma once

#include "vtkMRMLMarkupsNode.h"

/// A plane: its base frame has its origin in the plane and its z axis along the normal. Three control
/// points, one point with a kept normal, or a fit through many define it.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsPlaneNode : public vtkMRMLMarkupsNode
{
public:
  static vtkMRMLMarkupsPlaneNode* New();
  vtkTypeMacro(vtkMRMLMarkupsPlaneNode, vtkMRMLMarkupsNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsPlane"; }
  const char* GetMarkupType() override { return "Plane"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLMarkupsPlaneNode);
  vtkMRMLStorageNode* CreateDefaultStorageNode() override;

  enum
  {
    SizeModeAuto,
    SizeModeAbsolute,
    SizeMode_Last,
  };
  enum
  {
    PlaneType3Points,
    PlaneTypePointNormal,
    PlaneTypePlaneFit,
    PlaneType_Last
  };
  vtkGetMacro(PlaneType, int);
  void SetPlaneType(int planeType);
  static const char* GetPlaneTypeAsString(int planeType);
  static int GetPlaneTypeFromString(const char* planeType);
  vtkGetMacro(SizeMode, int);
  void SetSizeMode(int sizeMode);
  static const char* GetSizeModeAsString(int sizeMode);
  static int GetSizeModeFromString(const char* sizeMode);
  vtkGetMacro(AutoSizeScalingFactor, double);
  vtkSetMacro(AutoSizeScalingFactor, double);
  vtkGetMacro(IsPlaneValid, bool);

  /// \name Size of the part that is shown [mm], and where it lies in the plane's own frame
  ///@{
  void GetSize(double size[2]);
  double* GetSize() VTK_SIZEHINT(2) { return this->Size; }
  virtual void SetSize(double x, double y);
  virtual void SetSize(double size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector4Macro(PlaneBounds, double);
  virtual void SetPlaneBounds(double x0, double x1, double y0, double y1);
  virtual void SetPlaneBounds(double bounds[4]);
  ///@}

  void GetNormal(double normal[3]);
  void GetNormalWorld(double normal[3]);
  void SetNormal(const double normal[3]);
  void SetNormal(double x, double y, double z);
  void SetNormalWorld(const double normal[3]);
  void SetNormalWorld(double x, double y, double z);
  void GetOrigin(double origin[3]);
  void GetOriginWorld(double origin[3]);
  void SetOrigin(const double origin[3]);
  void SetOrigin(double x, double y, double z);
  void SetOriginWorld(const double origin[3]);
  void SetOriginWorld(double x, double y, double z);
  void GetCenter(double origin[3]) { this->GetOrigin(origin); }
  void GetCenterWorld(double origin[3]) { this->GetOriginWorld(origin); }
  void SetCenter(const double origin[3]) { this->SetOrigin(origin); }
  void SetCenterWorld(const double origin[3]) { this->SetOriginWorld(origin); }
  /// Orthonormal and right-handed.
  void GetAxes(double x[3], double y[3], double z[3]);
  void SetAxes(const double x[3], const double y[3], const double z[3]);
  void GetAxesWorld(double x[3], double y[3], double z[3]);
  void SetAxesWorld(const double x[3], const double y[3], const double z[3]);
  virtual void GetObjectToNodeMatrix(vtkMatrix4x4* objectToNodeMatrix);
  virtual void GetObjectToWorldMatrix(vtkMatrix4x4* objectToWorldMatrix);
  virtual vtkMatrix4x4* GetObjectToBaseMatrix() { return this->ObjectToBaseMatrix; }
  virtual vtkMatrix4x4* GetBaseToNodeMatrix() { return this->BaseToNodeMatrix; }

  void ApplyTransform(vtkAbstractTransform* transform) override;

protected:
  vtkMRMLMarkupsPlaneNode();
  ~vtkMRMLMarkupsPlaneNode() override = default;
  vtkMRMLMarkupsPlaneNode(const vtkMRMLMarkupsPlaneNode&) = delete;
  void operator=(const vtkMRMLMarkupsPlaneNode&) = delete;

  const char* GetDefaultDisplayNodeClass() override { return "vtkMRMLMarkupsPlaneDisplayNode"; }

  vtkSetMacro(MaximumNumberOfControlPoints, int);
  vtkSetMacro(RequiredNumberOfControlPoints, int);
  void OnControlPointsChanged() override;

private:
  void SetLimitsOfType();
  void MovePlane(vtkMatrix4x4* newObjectToNode);
  void FrameFrom3Points();
  void FrameFromFit();
  void SizeFromPoints();
  void NodeToWorld(vtkMatrix4x4* matrix);

  int PlaneType = PlaneTypePointNormal;
  int SizeMode = SizeModeAuto;
  double AutoSizeScalingFactor = 1.0;
  bool IsPlaneValid = false;
  bool IsMovingPlane = false;
  double Size[2] = {100.0, 100.0};
  double PlaneBounds[4] = {-50.0, 50.0, -50.0, 50.0};
  vtkNew<vtkMatrix4x4> ObjectToBaseMatrix;
  vtkNew<vtkMatrix4x4> BaseToNodeMatrix;
};
