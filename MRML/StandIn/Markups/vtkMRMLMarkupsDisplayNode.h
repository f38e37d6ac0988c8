#pragma once

#include "vtkMRMLDisplayNode.h"
#include "vtkSlicerMarkupsModuleMRMLExport.h"

/// How are control points, lines and planes seen; Slicer's other settings are kept as text.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsDisplayNode : public vtkMRMLDisplayNode
{
public:
  static vtkMRMLMarkupsDisplayNode* New();
  vtkTypeMacro(vtkMRMLMarkupsDisplayNode, vtkMRMLDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsDisplay"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLMarkupsDisplayNode);

  enum GlyphShapes
  {
    GlyphTypeInvalid = 0,
    StarBurst2D,
    Cross2D,
    CrossDot2D,
    ThickCross2D,
    Dash2D,
    Sphere3D,
    Vertex2D,
    Circle2D,
    Triangle2D,
    Square2D,
    Diamond2D,
    Arrow2D,
    ThickArrow2D,
    HookedArrow2D,
    GlyphType_Last
  };
  vtkSetMacro(GlyphType, int);
  vtkGetMacro(GlyphType, int);
  static const char* GetGlyphTypeAsString(int g);
  static int GetGlyphTypeFromString(const char* glyphString);
  /// Of the screen [%], and in the world [mm] where UseGlyphScale is off.
  vtkSetMacro(GlyphScale, double);
  vtkGetMacro(GlyphScale, double);
  vtkSetMacro(GlyphSize, double);
  vtkGetMacro(GlyphSize, double);
  vtkSetMacro(UseGlyphScale, bool);
  vtkGetMacro(UseGlyphScale, bool);
  vtkBooleanMacro(UseGlyphScale, bool);
  vtkSetMacro(TextScale, double);
  vtkGetMacro(TextScale, double);
  vtkSetMacro(PointLabelsVisibility, bool);
  vtkGetMacro(PointLabelsVisibility, bool);
  vtkBooleanMacro(PointLabelsVisibility, bool);
  vtkSetMacro(PropertiesLabelVisibility, bool);
  vtkGetMacro(PropertiesLabelVisibility, bool);
  vtkBooleanMacro(PropertiesLabelVisibility, bool);
  vtkSetMacro(FillVisibility, bool);
  vtkGetMacro(FillVisibility, bool);
  vtkBooleanMacro(FillVisibility, bool);
  vtkSetMacro(OutlineVisibility, bool);
  vtkGetMacro(OutlineVisibility, bool);
  vtkBooleanMacro(OutlineVisibility, bool);
  vtkSetMacro(FillOpacity, double);
  vtkGetMacro(FillOpacity, double);
  vtkSetMacro(OutlineOpacity, double);
  vtkGetMacro(OutlineOpacity, double);
  vtkSetMacro(LineThickness, double);
  vtkGetMacro(LineThickness, double);
  vtkSetMacro(LineDiameter, double);
  vtkGetMacro(LineDiameter, double);
  vtkSetMacro(OccludedVisibility, bool);
  vtkGetMacro(OccludedVisibility, bool);
  vtkBooleanMacro(OccludedVisibility, bool);
  vtkSetMacro(OccludedOpacity, double);
  vtkGetMacro(OccludedOpacity, double);
  vtkSetMacro(HandlesInteractive, bool);
  vtkGetMacro(HandlesInteractive, bool);
  vtkBooleanMacro(HandlesInteractive, bool);
  vtkSetVector3Macro(ActiveColor, double);
  vtkGetVector3Macro(ActiveColor, double);

protected:
  vtkMRMLMarkupsDisplayNode();
  ~vtkMRMLMarkupsDisplayNode() override = default;
  vtkMRMLMarkupsDisplayNode(const vtkMRMLMarkupsDisplayNode&) = delete;
  void operator=(const vtkMRMLMarkupsDisplayNode&) = delete;

private:
  int GlyphType = Sphere3D;
  double GlyphScale = 3.0;
  double GlyphSize = 5.0;
  bool UseGlyphScale = true;
  double TextScale = 3.0;
  bool PointLabelsVisibility = false;
  bool PropertiesLabelVisibility = true;
  bool FillVisibility = true;
  bool OutlineVisibility = true;
  double FillOpacity = 0.5;
  double OutlineOpacity = 1.0;
  double LineThickness = 0.2;
  double LineDiameter = 1.0;
  bool OccludedVisibility = false;
  double OccludedOpacity = 0.3;
  bool HandlesInteractive = false;
  double ActiveColor[3] = {0.4, 1.0, 0.0};
};
