#include "vtkMRMLDisplayNode.h"

#include "vtkMRMLColorNode.h"
#include "vtkMRMLDisplayableNode.h"
#include "vtkMRMLEnumText.h"
#include "vtkMRMLScene.h"

#include <vtkAssignAttribute.h>
#include <vtkDataArray.h>
#include <vtkScalarsToColors.h>

#include <algorithm>

namespace
{

const char* const scalarRangeFlags[] = {"UseManual", "UseData", "UseColorNode", "UseDataType",
                                        "UseDirectMapping"};
const char* const showModes[] = {"Default", "Ignore"};
const char* const locations[] = {"point", "cell", "vertex", "edge"};

} // namespace

vtkMRMLDisplayNode::vtkMRMLDisplayNode() : ActiveAttributeLocation(vtkAssignAttribute::POINT_DATA)
{
  this->HideFromEditors = 1;
}

vtkMRMLDisplayNode::~vtkMRMLDisplayNode()
{
  delete[] this->ColorNodeID;
  delete[] this->ActiveScalarName;
}

void vtkMRMLDisplayNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLVectorMacro(color, Color, double, 3);
  vtkMRMLWriteXMLVectorMacro(edgeColor, EdgeColor, double, 3);
  vtkMRMLWriteXMLVectorMacro(selectedColor, SelectedColor, double, 3);
  vtkMRMLWriteXMLFloatMacro(selectedAmbient, SelectedAmbient);
  vtkMRMLWriteXMLFloatMacro(ambient, Ambient);
  vtkMRMLWriteXMLFloatMacro(diffuse, Diffuse);
  vtkMRMLWriteXMLFloatMacro(selectedSpecular, SelectedSpecular);
  vtkMRMLWriteXMLFloatMacro(specular, Specular);
  vtkMRMLWriteXMLFloatMacro(power, Power);
  vtkMRMLWriteXMLFloatMacro(metallic, Metallic);
  vtkMRMLWriteXMLFloatMacro(roughness, Roughness);
  vtkMRMLWriteXMLFloatMacro(opacity, Opacity);
  vtkMRMLWriteXMLFloatMacro(sliceIntersectionOpacity, SliceIntersectionOpacity);
  vtkMRMLWriteXMLFloatMacro(pointSize, PointSize);
  vtkMRMLWriteXMLFloatMacro(lineWidth, LineWidth);
  vtkMRMLWriteXMLIntMacro(representation, Representation);
  vtkMRMLWriteXMLBooleanMacro(lighting, Lighting);
  vtkMRMLWriteXMLIntMacro(interpolation, Interpolation);
  vtkMRMLWriteXMLBooleanMacro(shading, Shading);
  vtkMRMLWriteXMLBooleanMacro(visibility, Visibility);
  vtkMRMLWriteXMLBooleanMacro(visibility2D, Visibility2D);
  vtkMRMLWriteXMLBooleanMacro(visibility3D, Visibility3D);
  vtkMRMLWriteXMLBooleanMacro(edgeVisibility, EdgeVisibility);
  vtkMRMLWriteXMLBooleanMacro(clipping, Clipping);
  vtkMRMLWriteXMLIntMacro(sliceIntersectionThickness, SliceIntersectionThickness);
  vtkMRMLWriteXMLBooleanMacro(frontfaceCulling, FrontfaceCulling);
  vtkMRMLWriteXMLBooleanMacro(backfaceCulling, BackfaceCulling);
  vtkMRMLWriteXMLBooleanMacro(scalarVisibility, ScalarVisibility);
  vtkMRMLWriteXMLBooleanMacro(vectorVisibility, VectorVisibility);
  vtkMRMLWriteXMLBooleanMacro(tensorVisibility, TensorVisibility);
  vtkMRMLWriteXMLBooleanMacro(interpolateTexture, InterpolateTexture);
  vtkMRMLWriteXMLStringMacro(scalarRangeFlag, ScalarRangeFlagAsString);
  vtkMRMLWriteXMLVectorMacro(scalarRange, ScalarRange, double, 2);
  vtkMRMLWriteXMLStringMacro(colorNodeID, ColorNodeID);
  vtkMRMLWriteXMLStringMacro(activeScalarName, ActiveScalarName);
  vtkMRMLWriteXMLStringMacro(activeAttributeLocation, ActiveAttributeLocationAsString);
  vtkMRMLWriteXMLStdStringVectorMacro(viewNodeRef, ViewNodeIDs, std::vector);
  vtkMRMLWriteXMLBooleanMacro(folderDisplayOverrideAllowed, FolderDisplayOverrideAllowed);
  if (this->ShowMode != ShowDefault)
  {
    vtkMRMLWriteXMLEnumMacro(showMode, ShowMode);
  }
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLDisplayNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLVectorMacro(color, Color, double, 3);
  vtkMRMLReadXMLVectorMacro(edgeColor, EdgeColor, double, 3);
  vtkMRMLReadXMLVectorMacro(selectedColor, SelectedColor, double, 3);
  vtkMRMLReadXMLFloatMacro(selectedAmbient, SelectedAmbient);
  vtkMRMLReadXMLFloatMacro(ambient, Ambient);
  vtkMRMLReadXMLFloatMacro(diffuse, Diffuse);
  vtkMRMLReadXMLFloatMacro(selectedSpecular, SelectedSpecular);
  vtkMRMLReadXMLFloatMacro(specular, Specular);
  vtkMRMLReadXMLFloatMacro(power, Power);
  vtkMRMLReadXMLFloatMacro(metallic, Metallic);
  vtkMRMLReadXMLFloatMacro(roughness, Roughness);
  vtkMRMLReadXMLFloatMacro(opacity, Opacity);
  vtkMRMLReadXMLFloatMacro(sliceIntersectionOpacity, SliceIntersectionOpacity);
  vtkMRMLReadXMLFloatMacro(pointSize, PointSize);
  vtkMRMLReadXMLFloatMacro(lineWidth, LineWidth);
  vtkMRMLReadXMLIntMacro(representation, Representation);
  vtkMRMLReadXMLBooleanMacro(lighting, Lighting);
  vtkMRMLReadXMLIntMacro(interpolation, Interpolation);
  vtkMRMLReadXMLBooleanMacro(shading, Shading);
  vtkMRMLReadXMLBooleanMacro(visibility, Visibility);
  vtkMRMLReadXMLBooleanMacro(visibility2D, Visibility2D);
  vtkMRMLReadXMLBooleanMacro(visibility3D, Visibility3D);
  vtkMRMLReadXMLBooleanMacro(edgeVisibility, EdgeVisibility);
  vtkMRMLReadXMLBooleanMacro(clipping, Clipping);
  vtkMRMLReadXMLBooleanMacro(sliceIntersectionVisibility, Visibility2D); // Slicer 4
  vtkMRMLReadXMLIntMacro(sliceIntersectionThickness, SliceIntersectionThickness);
  vtkMRMLReadXMLBooleanMacro(frontfaceCulling, FrontfaceCulling);
  vtkMRMLReadXMLBooleanMacro(backfaceCulling, BackfaceCulling);
  vtkMRMLReadXMLBooleanMacro(scalarVisibility, ScalarVisibility);
  vtkMRMLReadXMLBooleanMacro(vectorVisibility, VectorVisibility);
  vtkMRMLReadXMLBooleanMacro(tensorVisibility, TensorVisibility);
  vtkMRMLReadXMLBooleanMacro(interpolateTexture, InterpolateTexture);
  vtkMRMLReadXMLStringMacro(scalarRangeFlag, ScalarRangeFlagFromString);
  vtkMRMLReadXMLVectorMacro(scalarRange, ScalarRange, double, 2);
  vtkMRMLReadXMLStringMacro(colorNodeID, AndObserveColorNodeID);
  vtkMRMLReadXMLStringMacro(colorNodeRef, AndObserveColorNodeID);
  vtkMRMLReadXMLStringMacro(activeScalarName, ActiveScalarName);
  vtkMRMLReadXMLStringMacro(activeAttributeLocation, ActiveAttributeLocationFromString);
  vtkMRMLReadXMLStdStringVectorMacro(viewNodeRef, ViewNodeIDs, std::vector);
  vtkMRMLReadXMLBooleanMacro(folderDisplayOverrideAllowed, FolderDisplayOverrideAllowed);
  vtkMRMLReadXMLEnumMacro(showMode, ShowMode);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLDisplayNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  vtkMRMLCopyBeginMacro(anode);
  vtkMRMLCopyVectorMacro(Color, double, 3);
  vtkMRMLCopyVectorMacro(EdgeColor, double, 3);
  vtkMRMLCopyVectorMacro(SelectedColor, double, 3);
  vtkMRMLCopyFloatMacro(SelectedAmbient);
  vtkMRMLCopyFloatMacro(SelectedSpecular);
  vtkMRMLCopyFloatMacro(Ambient);
  vtkMRMLCopyFloatMacro(Diffuse);
  vtkMRMLCopyFloatMacro(Specular);
  vtkMRMLCopyFloatMacro(Power);
  vtkMRMLCopyFloatMacro(Metallic);
  vtkMRMLCopyFloatMacro(Roughness);
  vtkMRMLCopyFloatMacro(Opacity);
  vtkMRMLCopyFloatMacro(SliceIntersectionOpacity);
  vtkMRMLCopyFloatMacro(PointSize);
  vtkMRMLCopyFloatMacro(LineWidth);
  vtkMRMLCopyIntMacro(Representation);
  vtkMRMLCopyBooleanMacro(Lighting);
  vtkMRMLCopyIntMacro(Interpolation);
  vtkMRMLCopyBooleanMacro(Shading);
  vtkMRMLCopyBooleanMacro(Visibility);
  vtkMRMLCopyBooleanMacro(Visibility2D);
  vtkMRMLCopyBooleanMacro(Visibility3D);
  vtkMRMLCopyBooleanMacro(EdgeVisibility);
  vtkMRMLCopyBooleanMacro(Clipping);
  vtkMRMLCopyIntMacro(SliceIntersectionThickness);
  vtkMRMLCopyBooleanMacro(FrontfaceCulling);
  vtkMRMLCopyBooleanMacro(BackfaceCulling);
  vtkMRMLCopyBooleanMacro(ScalarVisibility);
  vtkMRMLCopyBooleanMacro(VectorVisibility);
  vtkMRMLCopyBooleanMacro(TensorVisibility);
  vtkMRMLCopyBooleanMacro(InterpolateTexture);
  vtkMRMLCopyIntMacro(ScalarRangeFlag);
  vtkMRMLCopyVectorMacro(ScalarRange, double, 2);
  this->SetAndObserveColorNodeID(copySourceNode->GetColorNodeID());
  vtkMRMLCopyStringMacro(ActiveScalarName);
  vtkMRMLCopyIntMacro(ActiveAttributeLocation);
  vtkMRMLCopyStdStringVectorMacro(ViewNodeIDs);
  vtkMRMLCopyBooleanMacro(FolderDisplayOverrideAllowed);
  vtkMRMLCopyIntMacro(ShowMode);
  vtkMRMLCopyEndMacro();
}

vtkMRMLDisplayableNode* vtkMRMLDisplayNode::GetDisplayableNode()
{
  std::vector<vtkMRMLNode*> nodes;
  if (this->GetScene())
  {
    this->GetScene()->GetReferencingNodes(this, nodes);
  }
  for (vtkMRMLNode* node : nodes)
  {
    auto* displayable = vtkMRMLDisplayableNode::SafeDownCast(node);
    if (displayable && displayable->HasDisplayNodeID(this->GetID()))
    {
      return displayable;
    }
  }
  return nullptr;
}

// --- Colour node -------------------------------------------------------------------------------

void vtkMRMLDisplayNode::SetAndObserveColorNodeID(const char* id)
{
  const std::string before = this->ColorNodeID ? this->ColorNodeID : "";
  const std::string after = id ? id : "";
  if (before == after)
  {
    return;
  }
  delete[] this->ColorNodeID;
  this->ColorNodeID = after.empty() ? nullptr : vtksys::SystemTools::DuplicateString(after.c_str());
  if (this->GetScene())
  {
    this->GetScene()->RemoveReferencedNodeID(before.c_str(), this);
    this->GetScene()->AddReferencedNodeID(after.c_str(), this);
  }
  this->Modified();
}

void vtkMRMLDisplayNode::SetAndObserveColorNodeID(const std::string& id)
{
  this->SetAndObserveColorNodeID(id.c_str());
}

vtkMRMLColorNode* vtkMRMLDisplayNode::GetColorNode()
{
  return vtkMRMLColorNode::SafeDownCast(
      this->GetScene() ? this->GetScene()->GetNodeByID(this->ColorNodeID) : nullptr);
}

void vtkMRMLDisplayNode::SetSceneReferences()
{
  this->Superclass::SetSceneReferences();
  this->GetScene()->AddReferencedNodeID(this->ColorNodeID, this);
}

void vtkMRMLDisplayNode::UpdateReferenceID(const char* oldID, const char* newID)
{
  this->Superclass::UpdateReferenceID(oldID, newID);
  if (this->ColorNodeID && std::string(this->ColorNodeID) == oldID)
  {
    this->SetAndObserveColorNodeID(newID);
  }
}

// --- Scalars -----------------------------------------------------------------------------------

void vtkMRMLDisplayNode::SetScalarVisibility(int visibility)
{
  if (this->ScalarVisibility != visibility)
  {
    this->ScalarVisibility = visibility;
    this->Modified();
  }
}

void vtkMRMLDisplayNode::SetActiveScalarName(const char* scalarName)
{
  const std::string before = this->ActiveScalarName ? this->ActiveScalarName : "";
  const std::string after = scalarName ? scalarName : "";
  if (before == after && (this->ActiveScalarName != nullptr) == (scalarName != nullptr))
  {
    return;
  }
  MRMLNodeModifyBlocker blocker(this);
  delete[] this->ActiveScalarName;
  this->ActiveScalarName =
      scalarName ? vtksys::SystemTools::DuplicateString(after.c_str()) : nullptr;
  this->UpdateAssignedAttribute();
  this->UpdateScalarRange();
  this->Modified();
}

void vtkMRMLDisplayNode::SetActiveAttributeLocation(int location)
{
  if (this->ActiveAttributeLocation != location)
  {
    MRMLNodeModifyBlocker blocker(this);
    this->ActiveAttributeLocation = location;
    this->UpdateAssignedAttribute();
    this->UpdateScalarRange();
    this->Modified();
  }
}

void vtkMRMLDisplayNode::SetActiveScalar(const char* scalarName, int location)
{
  MRMLNodeModifyBlocker blocker(this);
  this->SetActiveAttributeLocation(location);
  this->SetActiveScalarName(scalarName);
}

void vtkMRMLDisplayNode::SetScalarRangeFlag(int flag)
{
  if (this->ScalarRangeFlag != flag)
  {
    MRMLNodeModifyBlocker blocker(this);
    this->ScalarRangeFlag = flag;
    this->UpdateScalarRange();
    this->Modified();
  }
}

void vtkMRMLDisplayNode::UpdateScalarRange()
{
  vtkDataArray* array = this->GetActiveScalarArray();
  double range[2] = {this->ScalarRange[0], this->ScalarRange[1]};
  if (this->ScalarRangeFlag == UseDataScalarRange && array)
  {
    array->GetRange(range);
  }
  else if (this->ScalarRangeFlag == UseDataTypeScalarRange && array)
  {
    array->GetDataTypeRange(range);
  }
  else if (this->ScalarRangeFlag == UseColorNodeScalarRange && this->GetColorNode() &&
           this->GetColorNode()->GetScalarsToColors())
  {
    const double* colours = this->GetColorNode()->GetScalarsToColors()->GetRange();
    std::copy(colours, colours + 2, range);
  }
  this->SetScalarRange(range);
}

const char* vtkMRMLDisplayNode::GetScalarRangeFlagTypeAsString(int flag)
{
  return vtkMRMLEnumText(scalarRangeFlags, flag);
}

int vtkMRMLDisplayNode::GetScalarRangeFlagTypeFromString(const char* name)
{
  return vtkMRMLEnumFromText(scalarRangeFlags, name);
}

const char* vtkMRMLDisplayNode::GetScalarRangeFlagAsString()
{
  return GetScalarRangeFlagTypeAsString(this->ScalarRangeFlag);
}

void vtkMRMLDisplayNode::SetScalarRangeFlagFromString(const char* str)
{
  const int flag = GetScalarRangeFlagTypeFromString(str);
  if (flag >= 0)
  {
    this->SetScalarRangeFlag(flag);
  }
}

const char* vtkMRMLDisplayNode::GetShowModeAsString(int flag)
{
  return vtkMRMLEnumText(showModes, flag);
}

int vtkMRMLDisplayNode::GetShowModeFromString(const char* name)
{
  return vtkMRMLEnumFromText(showModes, name);
}

const char* vtkMRMLDisplayNode::GetAttributeLocationAsString(int id)
{
  return vtkMRMLEnumText(locations, id);
}

int vtkMRMLDisplayNode::GetAttributeLocationFromString(const char* name)
{
  return vtkMRMLEnumFromText(locations, name);
}

const char* vtkMRMLDisplayNode::GetActiveAttributeLocationAsString()
{
  return GetAttributeLocationAsString(this->ActiveAttributeLocation);
}

void vtkMRMLDisplayNode::SetActiveAttributeLocationFromString(const char* str)
{
  const int location = GetAttributeLocationFromString(str);
  if (location >= 0)
  {
    this->SetActiveAttributeLocation(location);
  }
}

// --- Views -------------------------------------------------------------------------------------

void vtkMRMLDisplayNode::AddViewNodeID(const char* viewNodeID)
{
  if (viewNodeID && *viewNodeID &&
      std::find(this->ViewNodeIDs.begin(), this->ViewNodeIDs.end(), viewNodeID) ==
          this->ViewNodeIDs.end())
  {
    this->ViewNodeIDs.emplace_back(viewNodeID);
    this->Modified();
  }
}

void vtkMRMLDisplayNode::RemoveAllViewNodeIDs()
{
  this->SetViewNodeIDs({});
}

void vtkMRMLDisplayNode::SetViewNodeIDs(const std::vector<std::string>& viewNodeIDs)
{
  if (this->ViewNodeIDs != viewNodeIDs)
  {
    this->ViewNodeIDs = viewNodeIDs;
    this->Modified();
  }
}

bool vtkMRMLDisplayNode::IsDisplayableInView(const char* viewNodeID) const
{
  return this->ViewNodeIDs.empty() ||
         (viewNodeID && std::find(this->ViewNodeIDs.begin(), this->ViewNodeIDs.end(), viewNodeID) !=
                            this->ViewNodeIDs.end());
}
