#include "vtkMRMLFaceToBonePlanNode.h"

#include "vtkMRMLFaceToBonePlannedMovement.h"

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
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(selectedMethod, SelectedMethod);
  vtkMRMLReadXMLStdStringMacro(provenance, Provenance);
  vtkMRMLReadXMLIntMacro(statusCode, StatusCode);
  vtkMRMLReadXMLStdStringMacro(statusText, StatusText);
  this->ReadResult(xmlReadAttName, xmlReadAttValue);
  vtkMRMLReadXMLEndMacro();
  this->Modified();
}

void vtkMRMLFaceToBonePlanNode::ReadResult(const char* name, const std::string& value)
{
  using namespace vtkMRMLFaceToBoneText;
  if (!strcmp(name, "figures"))
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
  this->WriteResults(of);
}

void vtkMRMLFaceToBonePlanNode::WriteResults(ostream& of)
{
  using namespace vtkMRMLFaceToBoneText;
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLEnumMacro(selectedMethod, SelectedMethod);
  vtkMRMLWriteXMLStdStringMacro(provenance, Provenance);
  vtkMRMLWriteXMLIntMacro(statusCode, StatusCode);
  vtkMRMLWriteXMLStdStringMacro(statusText, StatusText);
  vtkMRMLWriteXMLEndMacro();
  std::vector<std::string> figures;
  for (const auto& figure : this->Figures)
    figures.push_back(figure.first + "=" + FromNumber(figure.second));
  std::vector<std::pair<std::string, std::string>> texts = {
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
  this->WriteResults(mine);
  auto* source = vtkMRMLFaceToBonePlanNode::SafeDownCast(anode);
  source->WriteResults(other);
  if (mine.str() == other.str())
    return;
  this->SelectedMethod = node->SelectedMethod;
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
  this->WriteResults(os);
  os << "\n" << indent << "RunningStep: " << this->RunningStep << "\n";
  os << indent << "Progress: " << this->Progress << " " << this->ProgressText << "\n";
}
