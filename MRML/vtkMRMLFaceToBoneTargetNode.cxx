#include "vtkMRMLFaceToBoneTargetNode.h"

#include <vtkMRMLModelNode.h>

#include <vtkObjectFactory.h>
#include <vtkVariant.h>

#include <cstring>

namespace
{
const char* const KindNames[] = {"mesh", "scan", "warp", "movement"};
}

vtkMRMLNodeNewMacro(vtkMRMLFaceToBoneTargetNode);

vtkMRMLFaceToBoneTargetNode::vtkMRMLFaceToBoneTargetNode()
{
  this->HideFromEditors = 0;
  for (const char* role : {ReferenceSkinRole, TargetSkinRole, ScanRole, WarpFromRole, WarpToRole})
    this->AddNodeReferenceRole(role);
}

void vtkMRMLFaceToBoneTargetNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(kind, Kind);
  vtkMRMLReadXMLStdStringMacro(meshFileName, MeshFileName);
  vtkMRMLReadXMLStdStringMacro(scanFileName, ScanFileName);
  vtkMRMLReadXMLStdStringMacro(warpFromFileName, WarpFromFileName);
  vtkMRMLReadXMLStdStringMacro(warpToFileName, WarpToFileName);
  vtkMRMLReadXMLFloatMacro(scanReachMm, ScanReachMm);
  vtkMRMLReadXMLFloatMacro(warpRadiusMm, WarpRadiusMm);
  vtkMRMLReadXMLFloatMacro(maskMm, MaskMm);
  vtkMRMLReadXMLFloatMacro(peakDisplacementMm, PeakDisplacementMm);
  vtkMRMLReadXMLStdStringMacro(otherSettings, OtherSettings);
  if (!strcmp(xmlReadAttName, "movements"))
  {
    this->Movements.FromText(xmlReadAttValue);
    this->Modified();
  }
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLFaceToBoneTargetNode::WriteXML(ostream& of, int indent)
{
  Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLEnumMacro(kind, Kind);
  vtkMRMLWriteXMLStdStringMacro(meshFileName, MeshFileName);
  vtkMRMLWriteXMLStdStringMacro(scanFileName, ScanFileName);
  vtkMRMLWriteXMLStdStringMacro(warpFromFileName, WarpFromFileName);
  vtkMRMLWriteXMLStdStringMacro(warpToFileName, WarpToFileName);
  vtkMRMLFaceToBoneWriteXMLExactMacro(scanReachMm, ScanReachMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(warpRadiusMm, WarpRadiusMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(maskMm, MaskMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(peakDisplacementMm, PeakDisplacementMm);
  vtkMRMLWriteXMLStdStringMacro(otherSettings, OtherSettings);
  vtkMRMLWriteXMLEndMacro();
  of << " movements=\"" << this->XMLAttributeEncodeString(this->Movements.ToText()) << "\"";
}

void vtkMRMLFaceToBoneTargetNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::CopyContent(anode, deepCopy);
  vtkMRMLCopyBeginMacro(anode);
  vtkMRMLCopyEnumMacro(Kind);
  vtkMRMLCopyStdStringMacro(MeshFileName);
  vtkMRMLCopyStdStringMacro(ScanFileName);
  vtkMRMLCopyStdStringMacro(WarpFromFileName);
  vtkMRMLCopyStdStringMacro(WarpToFileName);
  vtkMRMLCopyFloatMacro(ScanReachMm);
  vtkMRMLCopyFloatMacro(WarpRadiusMm);
  vtkMRMLCopyFloatMacro(MaskMm);
  vtkMRMLCopyFloatMacro(PeakDisplacementMm);
  vtkMRMLCopyStdStringMacro(OtherSettings);
  vtkMRMLCopyEndMacro();
  const auto* node = vtkMRMLFaceToBoneTargetNode::SafeDownCast(anode);
  if (node && node->Movements != this->Movements)
  {
    this->Movements = node->Movements;
    this->Modified();
  }
}

void vtkMRMLFaceToBoneTargetNode::PrintSelf(ostream& os, vtkIndent indent)
{
  Superclass::PrintSelf(os, indent);
  vtkMRMLPrintBeginMacro(os, indent);
  vtkMRMLPrintEnumMacro(Kind);
  vtkMRMLPrintStdStringMacro(MeshFileName);
  vtkMRMLPrintStdStringMacro(ScanFileName);
  vtkMRMLPrintStdStringMacro(WarpFromFileName);
  vtkMRMLPrintStdStringMacro(WarpToFileName);
  vtkMRMLPrintFloatMacro(ScanReachMm);
  vtkMRMLPrintFloatMacro(WarpRadiusMm);
  vtkMRMLPrintFloatMacro(MaskMm);
  vtkMRMLPrintFloatMacro(PeakDisplacementMm);
  vtkMRMLPrintStdStringMacro(OtherSettings);
  vtkMRMLPrintEndMacro();
  os << indent << "Movements: " << this->Movements.ToText() << "\n";
}

const char* vtkMRMLFaceToBoneTargetNode::GetKindAsString(int kind)
{
  return kind >= 0 && kind < Kind_Last ? KindNames[kind] : "";
}

int vtkMRMLFaceToBoneTargetNode::GetKindFromString(const char* kind)
{
  for (int k = 0; kind && k < Kind_Last; ++k)
    if (!strcmp(kind, KindNames[k]))
      return k;
  return -1;
}

void vtkMRMLFaceToBoneTargetNode::SetMovement(const std::string& fragment, const double movement[6])
{
  if (this->Movements.Set(fragment, movement))
    this->Modified();
}

bool vtkMRMLFaceToBoneTargetNode::GetMovement(const std::string& fragment, double movement[6])
{
  return this->Movements.Get(fragment, movement);
}

std::vector<std::string> vtkMRMLFaceToBoneTargetNode::GetMovementFragments()
{
  return this->Movements.Fragments();
}

void vtkMRMLFaceToBoneTargetNode::RemoveMovements()
{
  if (this->Movements.Remove())
    this->Modified();
}

vtkMRMLModelNode* vtkMRMLFaceToBoneTargetNode::GetReferenceSkinNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(ReferenceSkinRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBoneTargetNode::GetTargetSkinNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(TargetSkinRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBoneTargetNode::GetScanNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(ScanRole));
}

void vtkMRMLFaceToBoneTargetNode::SetReferenceSkinNodeID(const char* id)
{
  this->SetNodeReferenceID(ReferenceSkinRole, id);
}

void vtkMRMLFaceToBoneTargetNode::SetTargetSkinNodeID(const char* id)
{
  this->SetNodeReferenceID(TargetSkinRole, id);
}

void vtkMRMLFaceToBoneTargetNode::SetScanNodeID(const char* id)
{
  this->SetNodeReferenceID(ScanRole, id);
}
