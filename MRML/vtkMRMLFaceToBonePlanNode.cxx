#include "vtkMRMLFaceToBonePlanNode.h"

#include "vtkMRMLFaceToBonePlannedMovement.h"

#include <vtkMRMLScene.h>

#include <vtkObjectFactory.h>
#include <vtkVariant.h>

#include <cstring>

namespace
{

const char* const MethodPrefixes[] = {"rigidFit", "virtualForce"};

} // namespace

vtkMRMLNodeNewMacro(vtkMRMLFaceToBonePlanNode);

vtkMRMLFaceToBonePlanNode::vtkMRMLFaceToBonePlanNode()
{
  this->HideFromEditors = 0;
  for (const char* role :
       {InputVolumeRole, CaseVolumeRole, LabelsRole, SkinRole, BoneRole, MeshRole, LandmarksRole,
        TargetRole, OsteotomyRole, StatedPredictionRole})
    this->AddNodeReferenceRole(role);
  this->AddNodeReferenceRole(StatedFragmentRole, "StatedFragmentRef");
  for (const std::string prefix : MethodPrefixes)
  {
    this->AddNodeReferenceRole((prefix + "Prediction").c_str());
    this->AddNodeReferenceRole((prefix + "Transform/").c_str(), (prefix + "TransformRef").c_str());
    this->AddNodeReferenceRole((prefix + "Fragment/").c_str(), (prefix + "FragmentRef").c_str());
  }
}

vtkMRMLFaceToBonePlanNode::~vtkMRMLFaceToBonePlanNode() = default;

// --- XML

void vtkMRMLFaceToBonePlanNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::ReadXMLAttributes(atts);
  for (auto& movements : this->Movements)
    movements.clear();
  this->ReadOptions(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  this->ReadResults(xmlReadAttName, xmlReadAttValue);
  vtkMRMLReadXMLEndMacro();
  this->Modified();
}

void vtkMRMLFaceToBonePlanNode::ReadOptions(const char** atts)
{
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(selectedMethod, SelectedMethod);
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
  vtkMRMLReadXMLStdStringMacro(provenance, Provenance);
  vtkMRMLReadXMLIntMacro(statusCode, StatusCode);
  vtkMRMLReadXMLStdStringMacro(statusText, StatusText);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLFaceToBonePlanNode::ReadResults(const char* name, const std::string& value)
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
    this->StatedMovements = ToMovements(value);
  else if (!strcmp(name, "figures"))
  {
    this->Figures.clear();
    for (const std::string& figure : ToList(value))
    {
      const std::size_t equals = figure.rfind('=');
      double number = 0;
      if (equals != std::string::npos && ToNumbers(figure.substr(equals + 1), &number, 1))
        this->Figures[figure.substr(0, equals)] = number;
    }
  }
  else if (!strcmp(name, "warnings"))
    this->Warnings = ToList(value);
  else if (!strcmp(name, "findings"))
    this->Findings = ToList(value);
  else if (!strcmp(name, "suggestions"))
    this->Suggestions = ToList(value);
  else if (!strcmp(name, "stepStatuses"))
    this->SetStepStatusesFromText(value);
  else
    for (int method = 0; method < Method_Last; ++method)
      if (!strcmp(name, (std::string(MethodPrefixes[method]) + "Movements").c_str()))
        for (const std::string& movement : ToList(value))
          this->Movements[method].push_back(vtkMRMLFaceToBonePlannedMovement::FromText(movement));
}

void vtkMRMLFaceToBonePlanNode::WriteXML(ostream& of, int indent)
{
  Superclass::WriteXML(of, indent);
  this->WriteOptions(of);
  this->WriteResults(of);
}

void vtkMRMLFaceToBonePlanNode::WriteOptions(ostream& of)
{
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLEnumMacro(selectedMethod, SelectedMethod);
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
  vtkMRMLWriteXMLStdStringMacro(provenance, Provenance);
  vtkMRMLWriteXMLIntMacro(statusCode, StatusCode);
  vtkMRMLWriteXMLStdStringMacro(statusText, StatusText);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLFaceToBonePlanNode::WriteResults(ostream& of)
{
  using namespace vtkMRMLFaceToBoneText;
  std::vector<std::string> figures;
  for (const auto& figure : this->Figures)
    figures.push_back(figure.first + "=" + FromNumber(figure.second));
  std::vector<std::pair<std::string, std::string>> texts = {
      {"caseFolder", this->GetCaseFolderInScene()},
      {"skinThresholdHU", this->SkinThresholdHU.ToText()},
      {"boneThresholdHU", this->BoneThresholdHU.ToText()},
      {"region", this->Region.ToText()},
      {"forceLandmarks", FromList(this->ForceLandmarks)},
      {"statedMovements", FromMovements(this->StatedMovements)},
      {"figures", FromList(figures)},
      {"warnings", FromList(this->Warnings)},
      {"findings", FromList(this->Findings)},
      {"suggestions", FromList(this->Suggestions)},
      {"stepStatuses", this->GetStepStatusesAsText()}};
  for (int method = 0; method < Method_Last; ++method)
  {
    std::vector<std::string> movements;
    for (const vtkMRMLFaceToBonePlannedMovement& movement : this->Movements[method])
      movements.push_back(movement.ToText());
    texts.emplace_back(std::string(MethodPrefixes[method]) + "Movements", FromList(movements));
  }
  for (const auto& text : texts)
    if (!text.second.empty())
      of << " " << text.first << "=\"" << this->XMLAttributeEncodeString(text.second) << "\"";
}

/// Relative to the scene's own folder where it lies in it, so that both can be moved together.
std::string vtkMRMLFaceToBonePlanNode::GetCaseFolderInScene()
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
void vtkMRMLFaceToBonePlanNode::UpdateScene(vtkMRMLScene* scene)
{
  Superclass::UpdateScene(scene);
  const char* root = scene ? scene->GetRootDirectory() : nullptr;
  if (root && *root && !this->CaseFolder.empty() &&
      !vtksys::SystemTools::FileIsFullPath(this->CaseFolder))
    this->SetCaseFolder(vtksys::SystemTools::CollapseFullPath(
        this->CaseFolder, vtksys::SystemTools::CollapseFullPath(root)));
}

void vtkMRMLFaceToBonePlanNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::CopyContent(anode, deepCopy);
  const auto* node = vtkMRMLFaceToBonePlanNode::SafeDownCast(anode);
  if (!node)
  {
    vtkErrorMacro("Copy failed: invalid source node");
    return;
  }
  // what is saved is what there is: equal texts are equal contents
  std::ostringstream mine, other;
  this->WriteOptions(mine);
  this->WriteResults(mine);
  auto* source = vtkMRMLFaceToBonePlanNode::SafeDownCast(anode);
  source->WriteOptions(other);
  source->WriteResults(other);
  if (mine.str() == other.str())
    return;
  this->SelectedMethod = node->SelectedMethod;
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
  std::copy(std::begin(node->Movements), std::end(node->Movements), std::begin(this->Movements));
  this->Figures = node->Figures;
  this->Warnings = node->Warnings;
  this->Findings = node->Findings;
  this->Suggestions = node->Suggestions;
  this->Provenance = node->Provenance;
  std::copy(std::begin(node->StepStatus), std::end(node->StepStatus), std::begin(this->StepStatus));
  this->StatusCode = node->StatusCode;
  this->StatusText = node->StatusText;
  this->Modified();
}

void vtkMRMLFaceToBonePlanNode::PrintSelf(ostream& os, vtkIndent indent)
{
  Superclass::PrintSelf(os, indent);
  os << indent;
  this->WriteOptions(os);
  this->WriteResults(os);
  os << "\n" << indent << "RunningStep: " << this->RunningStep << "\n";
  os << indent << "Progress: " << this->Progress << " " << this->ProgressText << "\n";
}
