#include "vtkMRMLFaceToBoneOptionsNode.h"

#include <vtkMRMLScene.h>

#include <vtkObjectFactory.h>
#include <vtkVariant.h>

#include <cstring>

vtkMRMLFaceToBoneOptionsNode::vtkMRMLFaceToBoneOptionsNode() = default;

vtkMRMLFaceToBoneOptionsNode::~vtkMRMLFaceToBoneOptionsNode() = default;

void vtkMRMLFaceToBoneOptionsNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLStdStringMacro(caseFolder, CaseFolder);
  vtkMRMLReadXMLStdStringMacro(caseName, CaseName);
  vtkMRMLReadXMLStdStringMacro(volumeFileName, VolumeFileName);
  vtkMRMLReadXMLStdStringMacro(landmarksFileName, LandmarksFileName);
  vtkMRMLReadXMLFloatMacro(spacingMm, SpacingMm);
  vtkMRMLReadXMLFloatMacro(headClosingMm, HeadClosingMm);
  vtkMRMLReadXMLFloatMacro(boneClosingMm, BoneClosingMm);
  vtkMRMLReadXMLFloatMacro(skinThicknessMm, SkinThicknessMm);
  vtkMRMLReadXMLStdStringMacro(materials, Materials);
  vtkMRMLReadXMLFloatMacro(meshDensity, MeshDensity);
  vtkMRMLReadXMLFloatMacro(releaseMarginMm, ReleaseMarginMm);
  vtkMRMLReadXMLFloatMacro(contactToleranceMm, ContactToleranceMm);
  vtkMRMLReadXMLIntMacro(threads, Threads);
  vtkMRMLReadXMLIntMacro(maxNewtonIterations, MaxNewtonIterations);
  vtkMRMLReadXMLFloatMacro(stepToleranceMm, StepToleranceMm);
  vtkMRMLReadXMLIntMacro(maxFitIterations, MaxFitIterations);
  vtkMRMLReadXMLStdStringMacro(predictModel, PredictModel);
  vtkMRMLReadXMLBooleanMacro(suggestConfirm, SuggestConfirm);
  vtkMRMLReadXMLFloatMacro(suggestDensity, SuggestDensity);
  vtkMRMLReadXMLStdStringMacro(reportTextsFileName, ReportTextsFileName);
  vtkMRMLReadXMLBooleanMacro(reportIdentity, ReportIdentity);
  vtkMRMLReadXMLFloatMacro(forceStiffness, ForceStiffness);
  vtkMRMLReadXMLBooleanMacro(forceStiffnessAutomatic, ForceStiffnessAutomatic);
  vtkMRMLReadXMLFloatMacro(forceResidualMm, ForceResidualMm);
  vtkMRMLReadXMLFloatMacro(forceRestLengthMm, ForceRestLengthMm);
  vtkMRMLReadXMLStdStringMacro(forceLoad, ForceLoad);
  vtkMRMLReadXMLStdStringMacro(otherSettings, OtherSettings);
  this->ReadNumbersAndLists(xmlReadAttName, xmlReadAttValue);
  vtkMRMLReadXMLEndMacro();
  this->Modified();
}

void vtkMRMLFaceToBoneOptionsNode::ReadNumbersAndLists(const char* name, const std::string& value)
{
  using namespace vtkMRMLFaceToBoneText;
  if (!strcmp(name, "skinThresholdHU"))
    this->SkinThresholdHU.FromText(value);
  else if (!strcmp(name, "boneThresholdHU"))
    this->BoneThresholdHU.FromText(value);
  else if (!strcmp(name, "region"))
    this->Region.FromText(value);
  else if (!strcmp(name, "forceLandmarks"))
    this->ForceLandmarks = ToList(value);
  else if (!strcmp(name, "statedMovements"))
    this->StatedMovements.FromText(value);
}

void vtkMRMLFaceToBoneOptionsNode::WriteXML(ostream& of, int indent)
{
  Superclass::WriteXML(of, indent);
  this->WriteOptions(of);
  this->WriteNumbersAndLists(of);
}

void vtkMRMLFaceToBoneOptionsNode::WriteOptions(ostream& of)
{
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLStdStringMacro(caseName, CaseName);
  vtkMRMLWriteXMLStdStringMacro(volumeFileName, VolumeFileName);
  vtkMRMLWriteXMLStdStringMacro(landmarksFileName, LandmarksFileName);
  vtkMRMLFaceToBoneWriteXMLExactMacro(spacingMm, SpacingMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(headClosingMm, HeadClosingMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(boneClosingMm, BoneClosingMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(skinThicknessMm, SkinThicknessMm);
  vtkMRMLWriteXMLStdStringMacro(materials, Materials);
  vtkMRMLFaceToBoneWriteXMLExactMacro(meshDensity, MeshDensity);
  vtkMRMLFaceToBoneWriteXMLExactMacro(releaseMarginMm, ReleaseMarginMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(contactToleranceMm, ContactToleranceMm);
  vtkMRMLWriteXMLIntMacro(threads, Threads);
  vtkMRMLWriteXMLIntMacro(maxNewtonIterations, MaxNewtonIterations);
  vtkMRMLFaceToBoneWriteXMLExactMacro(stepToleranceMm, StepToleranceMm);
  vtkMRMLWriteXMLIntMacro(maxFitIterations, MaxFitIterations);
  vtkMRMLWriteXMLStdStringMacro(predictModel, PredictModel);
  vtkMRMLWriteXMLBooleanMacro(suggestConfirm, SuggestConfirm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(suggestDensity, SuggestDensity);
  vtkMRMLWriteXMLStdStringMacro(reportTextsFileName, ReportTextsFileName);
  vtkMRMLWriteXMLBooleanMacro(reportIdentity, ReportIdentity);
  vtkMRMLFaceToBoneWriteXMLExactMacro(forceStiffness, ForceStiffness);
  vtkMRMLWriteXMLBooleanMacro(forceStiffnessAutomatic, ForceStiffnessAutomatic);
  vtkMRMLFaceToBoneWriteXMLExactMacro(forceResidualMm, ForceResidualMm);
  vtkMRMLFaceToBoneWriteXMLExactMacro(forceRestLengthMm, ForceRestLengthMm);
  vtkMRMLWriteXMLStdStringMacro(forceLoad, ForceLoad);
  vtkMRMLWriteXMLStdStringMacro(otherSettings, OtherSettings);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLFaceToBoneOptionsNode::WriteNumbersAndLists(ostream& of)
{
  using namespace vtkMRMLFaceToBoneText;
  const std::pair<const char*, std::string> texts[] = {
      {"caseFolder", this->GetCaseFolderInScene()},
      {"skinThresholdHU", this->SkinThresholdHU.ToText()},
      {"boneThresholdHU", this->BoneThresholdHU.ToText()},
      {"region", this->Region.ToText()},
      {"forceLandmarks", FromList(this->ForceLandmarks)},
      {"statedMovements", this->StatedMovements.ToText()}};
  for (const auto& text : texts)
    if (!text.second.empty())
      of << " " << text.first << "=\"" << this->XMLAttributeEncodeString(text.second) << "\"";
}

/// Relative to the scene's own folder where it lies in it, so that both can be moved together.
std::string vtkMRMLFaceToBoneOptionsNode::GetCaseFolderInScene()
{
  const char* root = this->Scene ? this->Scene->GetRootDirectory() : nullptr;
  if (!root || !*root || !vtksys::SystemTools::FileIsFullPath(this->CaseFolder))
    return this->CaseFolder;
  const std::string home = vtksys::SystemTools::CollapseFullPath(root);
  const std::string folder = vtksys::SystemTools::CollapseFullPath(this->CaseFolder);
  if (folder == home)
    return ".";
  return vtksys::SystemTools::IsSubDirectory(folder, home) ? folder.substr(home.size() + 1)
                                                           : this->CaseFolder;
}

/// The folder that a scene file names starts from that file's own, not from where the program does.
void vtkMRMLFaceToBoneOptionsNode::UpdateScene(vtkMRMLScene* scene)
{
  Superclass::UpdateScene(scene);
  const char* root = scene ? scene->GetRootDirectory() : nullptr;
  if (root && *root && !this->CaseFolder.empty() &&
      !vtksys::SystemTools::FileIsFullPath(this->CaseFolder))
    this->SetCaseFolder(vtksys::SystemTools::CollapseFullPath(
        this->CaseFolder, vtksys::SystemTools::CollapseFullPath(root)));
}

void vtkMRMLFaceToBoneOptionsNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::CopyContent(anode, deepCopy);
  auto* node = vtkMRMLFaceToBoneOptionsNode::SafeDownCast(anode);
  if (!node)
  {
    vtkErrorMacro("Copy failed: invalid source node");
    return;
  }
  // what is saved is what there is: equal texts are equal contents
  std::ostringstream mine, other;
  this->WriteOptions(mine);
  this->WriteNumbersAndLists(mine);
  node->WriteOptions(other);
  node->WriteNumbersAndLists(other);
  if (mine.str() == other.str() && this->CaseFolder == node->CaseFolder)
    return;
  this->CaseFolder = node->CaseFolder;
  this->CaseName = node->CaseName;
  this->VolumeFileName = node->VolumeFileName;
  this->LandmarksFileName = node->LandmarksFileName;
  this->SkinThresholdHU = node->SkinThresholdHU;
  this->BoneThresholdHU = node->BoneThresholdHU;
  this->Region = node->Region;
  this->SpacingMm = node->SpacingMm;
  this->HeadClosingMm = node->HeadClosingMm;
  this->BoneClosingMm = node->BoneClosingMm;
  this->SkinThicknessMm = node->SkinThicknessMm;
  this->Materials = node->Materials;
  this->MeshDensity = node->MeshDensity;
  this->ReleaseMarginMm = node->ReleaseMarginMm;
  this->ContactToleranceMm = node->ContactToleranceMm;
  this->Threads = node->Threads;
  this->MaxNewtonIterations = node->MaxNewtonIterations;
  this->StepToleranceMm = node->StepToleranceMm;
  this->MaxFitIterations = node->MaxFitIterations;
  this->PredictModel = node->PredictModel;
  this->SuggestConfirm = node->SuggestConfirm;
  this->SuggestDensity = node->SuggestDensity;
  this->ReportTextsFileName = node->ReportTextsFileName;
  this->ReportIdentity = node->ReportIdentity;
  this->ForceStiffness = node->ForceStiffness;
  this->ForceStiffnessAutomatic = node->ForceStiffnessAutomatic;
  this->ForceResidualMm = node->ForceResidualMm;
  this->ForceRestLengthMm = node->ForceRestLengthMm;
  this->ForceLoad = node->ForceLoad;
  this->ForceLandmarks = node->ForceLandmarks;
  this->StatedMovements = node->StatedMovements;
  this->OtherSettings = node->OtherSettings;
  this->Modified();
}

void vtkMRMLFaceToBoneOptionsNode::PrintSelf(ostream& os, vtkIndent indent)
{
  Superclass::PrintSelf(os, indent);
  os << indent;
  this->WriteOptions(os);
  this->WriteNumbersAndLists(os);
  os << "\n";
}

void vtkMRMLFaceToBoneOptionsNode::SetSkinThresholdHU(double hu)
{
  if (this->SkinThresholdHU.Set(&hu))
    this->Modified();
}

bool vtkMRMLFaceToBoneOptionsNode::GetSkinThresholdHU(double hu[1])
{
  return this->SkinThresholdHU.Get(hu);
}

void vtkMRMLFaceToBoneOptionsNode::RemoveSkinThresholdHU()
{
  if (this->SkinThresholdHU.Remove())
    this->Modified();
}

void vtkMRMLFaceToBoneOptionsNode::SetBoneThresholdHU(double hu)
{
  if (this->BoneThresholdHU.Set(&hu))
    this->Modified();
}

bool vtkMRMLFaceToBoneOptionsNode::GetBoneThresholdHU(double hu[1])
{
  return this->BoneThresholdHU.Get(hu);
}

void vtkMRMLFaceToBoneOptionsNode::RemoveBoneThresholdHU()
{
  if (this->BoneThresholdHU.Remove())
    this->Modified();
}

void vtkMRMLFaceToBoneOptionsNode::SetRegion(const double region_ras[6])
{
  if (this->Region.Set(region_ras))
    this->Modified();
}

bool vtkMRMLFaceToBoneOptionsNode::GetRegion(double region_ras[6])
{
  return this->Region.Get(region_ras);
}

void vtkMRMLFaceToBoneOptionsNode::RemoveRegion()
{
  if (this->Region.Remove())
    this->Modified();
}

void vtkMRMLFaceToBoneOptionsNode::SetForceLandmarks(const std::vector<std::string>& names)
{
  if (this->ForceLandmarks == names)
    return;
  this->ForceLandmarks = names;
  this->Modified();
}

void vtkMRMLFaceToBoneOptionsNode::SetStatedMovement(const std::string& fragment,
                                                     const double movement[6])
{
  if (this->StatedMovements.Set(fragment, movement))
    this->Modified();
}

bool vtkMRMLFaceToBoneOptionsNode::GetStatedMovement(const std::string& fragment,
                                                     double movement[6])
{
  return this->StatedMovements.Get(fragment, movement);
}

std::vector<std::string> vtkMRMLFaceToBoneOptionsNode::GetStatedMovementFragments()
{
  return this->StatedMovements.Fragments();
}

void vtkMRMLFaceToBoneOptionsNode::RemoveStatedMovements()
{
  if (this->StatedMovements.Remove())
    this->Modified();
}
