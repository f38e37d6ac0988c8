#pragma once

#include "vtkMRMLNode.h"

class vtkDataArray;
class vtkDataSet;
class vtkMRMLColorNode;
class vtkMRMLDisplayableNode;

/// How is a node seen: colour, opacity, surface, and scalars through a colour node.
class VTK_MRML_EXPORT vtkMRMLDisplayNode : public vtkMRMLNode
{
public:
  vtkTypeMacro(vtkMRMLDisplayNode, vtkMRMLNode);
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLDisplayNode);
  void SetSceneReferences() override;
  void UpdateReferenceID(const char* oldID, const char* newID) override;
  virtual vtkMRMLDisplayableNode* GetDisplayableNode();

  enum RepresentationType
  {
    PointsRepresentation = 0,
    WireframeRepresentation,
    SurfaceRepresentation
  };
  enum InterpolationType
  {
    FlatInterpolation = 0,
    GouraudInterpolation,
    PhongInterpolation,
    PBRInterpolation
  };
  /// Where the range that the colours span comes from.
  enum ScalarRangeFlagType
  {
    UseManualScalarRange = 0,
    UseDataScalarRange,
    UseColorNodeScalarRange,
    UseDataTypeScalarRange,
    UseDirectMapping,
    NUM_SCALAR_RANGE_FLAGS
  };
  enum ShowModeType
  {
    ShowDefault = 0,
    ShowIgnore,
    ShowMode_Last
  };
  static const char* GetScalarRangeFlagTypeAsString(int flag);
  static int GetScalarRangeFlagTypeFromString(const char* name);
  static const char* GetShowModeAsString(int flag);
  static int GetShowModeFromString(const char* name);
  static const char* GetAttributeLocationAsString(int id);
  static int GetAttributeLocationFromString(const char* name);

  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  vtkSetVector3Macro(EdgeColor, double);
  vtkGetVector3Macro(EdgeColor, double);
  vtkSetVector3Macro(SelectedColor, double);
  vtkGetVector3Macro(SelectedColor, double);
  vtkSetMacro(SelectedAmbient, double);
  vtkGetMacro(SelectedAmbient, double);
  vtkSetMacro(SelectedSpecular, double);
  vtkGetMacro(SelectedSpecular, double);
  vtkSetMacro(PointSize, double);
  vtkGetMacro(PointSize, double);
  vtkSetMacro(LineWidth, double);
  vtkGetMacro(LineWidth, double);
  vtkSetMacro(Representation, int);
  vtkGetMacro(Representation, int);
  vtkSetMacro(Opacity, double);
  vtkGetMacro(Opacity, double);
  vtkSetMacro(SliceIntersectionOpacity, double);
  vtkGetMacro(SliceIntersectionOpacity, double);
  vtkSetMacro(Ambient, double);
  vtkGetMacro(Ambient, double);
  vtkSetMacro(Diffuse, double);
  vtkGetMacro(Diffuse, double);
  vtkSetMacro(Specular, double);
  vtkGetMacro(Specular, double);
  vtkSetMacro(Power, double);
  vtkGetMacro(Power, double);
  vtkSetMacro(Metallic, double);
  vtkGetMacro(Metallic, double);
  vtkSetMacro(Roughness, double);
  vtkGetMacro(Roughness, double);
  vtkSetMacro(Visibility, int);
  vtkGetMacro(Visibility, int);
  vtkBooleanMacro(Visibility, int);
  vtkSetMacro(Visibility2D, int);
  vtkGetMacro(Visibility2D, int);
  vtkBooleanMacro(Visibility2D, int);
  vtkSetMacro(Visibility3D, int);
  vtkGetMacro(Visibility3D, int);
  vtkBooleanMacro(Visibility3D, int);
  vtkSetMacro(EdgeVisibility, int);
  vtkGetMacro(EdgeVisibility, int);
  vtkBooleanMacro(EdgeVisibility, int);
  vtkSetMacro(Clipping, int);
  vtkGetMacro(Clipping, int);
  vtkBooleanMacro(Clipping, int);
  vtkSetMacro(SliceIntersectionThickness, int);
  vtkGetMacro(SliceIntersectionThickness, int);
  vtkSetMacro(FrontfaceCulling, int);
  vtkGetMacro(FrontfaceCulling, int);
  vtkBooleanMacro(FrontfaceCulling, int);
  vtkSetMacro(BackfaceCulling, int);
  vtkGetMacro(BackfaceCulling, int);
  vtkBooleanMacro(BackfaceCulling, int);
  vtkSetMacro(Lighting, int);
  vtkGetMacro(Lighting, int);
  vtkBooleanMacro(Lighting, int);
  vtkSetMacro(Interpolation, int);
  vtkGetMacro(Interpolation, int);
  vtkSetMacro(Shading, int);
  vtkGetMacro(Shading, int);
  virtual void SetScalarVisibility(int visibility);
  vtkGetMacro(ScalarVisibility, int);
  vtkBooleanMacro(ScalarVisibility, int);
  vtkSetMacro(VectorVisibility, int);
  vtkGetMacro(VectorVisibility, int);
  vtkSetMacro(TensorVisibility, int);
  vtkGetMacro(TensorVisibility, int);
  vtkSetMacro(InterpolateTexture, int);
  vtkGetMacro(InterpolateTexture, int);
  vtkSetVector2Macro(ScalarRange, double);
  vtkGetVector2Macro(ScalarRange, double);
  virtual void SetScalarRangeFlag(int flag);
  vtkGetMacro(ScalarRangeFlag, int);
  const char* GetScalarRangeFlagAsString();
  void SetScalarRangeFlagFromString(const char* str);
  /// Sets ScalarRange as the flag says, from the active array.
  virtual void UpdateScalarRange();
  vtkSetMacro(FolderDisplayOverrideAllowed, bool);
  vtkGetMacro(FolderDisplayOverrideAllowed, bool);
  vtkSetMacro(ShowMode, int);
  vtkGetMacro(ShowMode, int);

  virtual void SetAndObserveColorNodeID(const char* ColorNodeID);
  void SetAndObserveColorNodeID(const std::string& ColorNodeID);
  vtkGetStringMacro(ColorNodeID);
  virtual vtkMRMLColorNode* GetColorNode();

  /// The array that is shown, and where it lies (vtkAssignAttribute::POINT_DATA or CELL_DATA).
  virtual void SetActiveScalarName(const char* scalarName);
  vtkGetStringMacro(ActiveScalarName);
  virtual void SetActiveAttributeLocation(int location);
  vtkGetMacro(ActiveAttributeLocation, int);
  const char* GetActiveAttributeLocationAsString();
  void SetActiveAttributeLocationFromString(const char* str);
  virtual void SetActiveScalar(const char* scalarName, int location);
  virtual void UpdateAssignedAttribute() {}
  virtual vtkDataSet* GetScalarDataSet() { return nullptr; }
  virtual vtkDataArray* GetActiveScalarArray() { return nullptr; }

  /// Views that show the node; all where there is none.
  void AddViewNodeID(const char* viewNodeID);
  void RemoveAllViewNodeIDs();
  int GetNumberOfViewNodeIDs() const { return static_cast<int>(this->ViewNodeIDs.size()); }
  std::vector<std::string> GetViewNodeIDs() const { return this->ViewNodeIDs; }
  void SetViewNodeIDs(const std::vector<std::string>& viewNodeIDs);
  bool IsDisplayableInView(const char* viewNodeID) const;

protected:
  vtkMRMLDisplayNode();
  ~vtkMRMLDisplayNode() override;
  vtkMRMLDisplayNode(const vtkMRMLDisplayNode&) = delete;
  void operator=(const vtkMRMLDisplayNode&) = delete;

  char* ColorNodeID = nullptr;
  char* ActiveScalarName = nullptr;
  int ActiveAttributeLocation;
  double Color[3] = {0.9, 0.9, 0.3};
  double EdgeColor[3] = {0.0, 0.0, 0.0};
  double SelectedColor[3] = {1.0, 0.0, 0.0};
  double SelectedAmbient = 0.4;
  double SelectedSpecular = 0.5;
  double Opacity = 1.0;
  double SliceIntersectionOpacity = 1.0;
  double Ambient = 0.0;
  double Diffuse = 1.0;
  double Specular = 0.0;
  double Power = 1.0;
  double Metallic = 0.0;
  double Roughness = 0.5;
  double PointSize = 1.0;
  double LineWidth = 1.0;
  int Representation = SurfaceRepresentation;
  int Lighting = 1;
  int Interpolation = GouraudInterpolation;
  int Shading = 1;
  int Visibility = 1;
  int Visibility2D = 0;
  int Visibility3D = 1;
  int EdgeVisibility = 0;
  int Clipping = 0;
  int SliceIntersectionThickness = 1;
  int FrontfaceCulling = 0;
  int BackfaceCulling = 0;
  int ScalarVisibility = 0;
  int VectorVisibility = 0;
  int TensorVisibility = 0;
  int InterpolateTexture = 0;
  double ScalarRange[2] = {0.0, 100.0};
  int ScalarRangeFlag = UseDataScalarRange;
  bool FolderDisplayOverrideAllowed = true;
  int ShowMode = ShowDefault;
  std::vector<std::string> ViewNodeIDs;
};
