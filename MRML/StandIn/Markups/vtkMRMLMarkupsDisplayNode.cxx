#include "vtkMRMLMarkupsDisplayNode.h"

#include "vtkMRMLEnumText.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsDisplayNode);

namespace
{

const char* const glyphTypes[] = {"Invalid",      "StarBurst2D",  "Cross2D",      "CrossDot2D",
                                  "ThickCross2D", "Dash2D",       "Sphere3D",     "Vertex2D",
                                  "Circle2D",     "Triangle2D",   "Square2D",     "Diamond2D",
                                  "Arrow2D",      "ThickArrow2D", "HookedArrow2D"};

} // namespace

vtkMRMLMarkupsDisplayNode::vtkMRMLMarkupsDisplayNode()
{
  this->Visibility2D = 1;
  this->SetColor(0.4, 1.0, 1.0);
  this->SetSelectedColor(1.0, 0.5, 0.5);
}

void vtkMRMLMarkupsDisplayNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLBooleanMacro(propertiesLabelVisibility, PropertiesLabelVisibility);
  vtkMRMLWriteXMLBooleanMacro(pointLabelsVisibility, PointLabelsVisibility);
  vtkMRMLWriteXMLFloatMacro(textScale, TextScale);
  vtkMRMLWriteXMLFloatMacro(glyphScale, GlyphScale);
  vtkMRMLWriteXMLFloatMacro(glyphSize, GlyphSize);
  vtkMRMLWriteXMLBooleanMacro(useGlyphScale, UseGlyphScale);
  vtkMRMLWriteXMLEnumMacro(glyphType, GlyphType);
  vtkMRMLWriteXMLFloatMacro(lineThickness, LineThickness);
  vtkMRMLWriteXMLFloatMacro(lineDiameter, LineDiameter);
  vtkMRMLWriteXMLBooleanMacro(handlesInteractive, HandlesInteractive);
  vtkMRMLWriteXMLBooleanMacro(fillVisibility, FillVisibility);
  vtkMRMLWriteXMLBooleanMacro(outlineVisibility, OutlineVisibility);
  vtkMRMLWriteXMLFloatMacro(fillOpacity, FillOpacity);
  vtkMRMLWriteXMLFloatMacro(outlineOpacity, OutlineOpacity);
  vtkMRMLWriteXMLBooleanMacro(occludedVisibility, OccludedVisibility);
  vtkMRMLWriteXMLFloatMacro(occludedOpacity, OccludedOpacity);
  vtkMRMLWriteXMLVectorMacro(activeColor, ActiveColor, double, 3);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLMarkupsDisplayNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLBooleanMacro(propertiesLabelVisibility, PropertiesLabelVisibility);
  vtkMRMLReadXMLBooleanMacro(pointLabelsVisibility, PointLabelsVisibility);
  vtkMRMLReadXMLFloatMacro(textScale, TextScale);
  vtkMRMLReadXMLFloatMacro(glyphScale, GlyphScale);
  vtkMRMLReadXMLFloatMacro(glyphSize, GlyphSize);
  vtkMRMLReadXMLBooleanMacro(useGlyphScale, UseGlyphScale);
  vtkMRMLReadXMLEnumMacro(glyphType, GlyphType);
  vtkMRMLReadXMLFloatMacro(lineThickness, LineThickness);
  vtkMRMLReadXMLFloatMacro(lineDiameter, LineDiameter);
  vtkMRMLReadXMLBooleanMacro(handlesInteractive, HandlesInteractive);
  vtkMRMLReadXMLBooleanMacro(fillVisibility, FillVisibility);
  vtkMRMLReadXMLBooleanMacro(outlineVisibility, OutlineVisibility);
  vtkMRMLReadXMLFloatMacro(fillOpacity, FillOpacity);
  vtkMRMLReadXMLFloatMacro(outlineOpacity, OutlineOpacity);
  vtkMRMLReadXMLBooleanMacro(occludedVisibility, OccludedVisibility);
  vtkMRMLReadXMLFloatMacro(occludedOpacity, OccludedOpacity);
  vtkMRMLReadXMLVectorMacro(activeColor, ActiveColor, double, 3);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLMarkupsDisplayNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  vtkMRMLCopyBeginMacro(anode);
  vtkMRMLCopyBooleanMacro(PropertiesLabelVisibility);
  vtkMRMLCopyBooleanMacro(PointLabelsVisibility);
  vtkMRMLCopyFloatMacro(TextScale);
  vtkMRMLCopyFloatMacro(GlyphScale);
  vtkMRMLCopyFloatMacro(GlyphSize);
  vtkMRMLCopyBooleanMacro(UseGlyphScale);
  vtkMRMLCopyEnumMacro(GlyphType);
  vtkMRMLCopyFloatMacro(LineThickness);
  vtkMRMLCopyFloatMacro(LineDiameter);
  vtkMRMLCopyBooleanMacro(HandlesInteractive);
  vtkMRMLCopyBooleanMacro(FillVisibility);
  vtkMRMLCopyBooleanMacro(OutlineVisibility);
  vtkMRMLCopyFloatMacro(FillOpacity);
  vtkMRMLCopyFloatMacro(OutlineOpacity);
  vtkMRMLCopyBooleanMacro(OccludedVisibility);
  vtkMRMLCopyFloatMacro(OccludedOpacity);
  vtkMRMLCopyVectorMacro(ActiveColor, double, 3);
  vtkMRMLCopyEndMacro();
}

const char* vtkMRMLMarkupsDisplayNode::GetGlyphTypeAsString(int g)
{
  return vtkMRMLEnumText(glyphTypes, g, "Invalid");
}

int vtkMRMLMarkupsDisplayNode::GetGlyphTypeFromString(const char* glyphString)
{
  return vtkMRMLEnumFromText(glyphTypes, glyphString);
}
