#include "vtkMRMLFaceToBonePlanNode.h"

#include "vtkMRMLFaceToBoneOsteotomyNode.h"
#include "vtkMRMLFaceToBonePlannedMovement.h"
#include "vtkMRMLFaceToBoneTargetNode.h"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLVolumeNode.h>

#include <cmath>
#include <cstring>

namespace
{

const char* const MethodNames[] = {"rigid-fit", "virtual-force"};
const char* const MethodPrefixes[] = {"rigidFit", "virtualForce"};
const char* const StepNames[] = {"segment", "cut",  "mesh",    "target",
                                 "suggest", "plan", "predict", "report"};
const char* const StepStatusNames[] = {"not-done", "current", "stale"};

/// The index of a word, -1 if it is none.
template <std::size_t Count>
int IndexOf(const char* word, const char* const (&words)[Count])
{
  for (std::size_t i = 0; word && i < Count; ++i)
    if (!strcmp(word, words[i]))
      return static_cast<int>(i);
  return -1;
}

template <std::size_t Count>
const char* NameOf(int index, const char* const (&words)[Count])
{
  return index >= 0 && index < static_cast<int>(Count) ? words[index] : "";
}

} // namespace

// --- Names

const char* vtkMRMLFaceToBonePlanNode::GetSelectedMethodAsString(int method)
{
  return NameOf(method, MethodNames);
}

int vtkMRMLFaceToBonePlanNode::GetSelectedMethodFromString(const char* method)
{
  return IndexOf(method, MethodNames);
}

const char* vtkMRMLFaceToBonePlanNode::GetStepAsString(int step)
{
  return NameOf(step, StepNames);
}

int vtkMRMLFaceToBonePlanNode::GetStepFromString(const char* step)
{
  return IndexOf(step, StepNames);
}

std::string vtkMRMLFaceToBonePlanNode::GetTransformRole(int method, const std::string& fragment)
{
  return std::string(NameOf(method, MethodPrefixes)) + "Transform/" + fragment;
}

std::string vtkMRMLFaceToBonePlanNode::GetFragmentRole(int method, const std::string& fragment)
{
  return std::string(NameOf(method, MethodPrefixes)) + "Fragment/" + fragment;
}

std::string vtkMRMLFaceToBonePlanNode::GetPredictionRole(int method)
{
  return std::string(NameOf(method, MethodPrefixes)) + "Prediction";
}

// --- References

vtkMRMLVolumeNode* vtkMRMLFaceToBonePlanNode::GetInputVolumeNode()
{
  return vtkMRMLVolumeNode::SafeDownCast(this->GetNodeReference(InputVolumeRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBonePlanNode::GetSkinNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(SkinRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBonePlanNode::GetBoneNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(BoneRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBonePlanNode::GetMeshNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(MeshRole));
}

vtkMRMLNode* vtkMRMLFaceToBonePlanNode::GetLandmarksNode()
{
  return this->GetNodeReference(LandmarksRole);
}

vtkMRMLFaceToBoneTargetNode* vtkMRMLFaceToBonePlanNode::GetTargetNode()
{
  return vtkMRMLFaceToBoneTargetNode::SafeDownCast(this->GetNodeReference(TargetRole));
}

vtkMRMLFaceToBoneOsteotomyNode* vtkMRMLFaceToBonePlanNode::GetOsteotomyNode()
{
  return vtkMRMLFaceToBoneOsteotomyNode::SafeDownCast(this->GetNodeReference(OsteotomyRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBonePlanNode::GetStatedPredictionNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(StatedPredictionRole));
}

void vtkMRMLFaceToBonePlanNode::SetInputVolumeNodeID(const char* id)
{
  this->SetNodeReferenceID(InputVolumeRole, id);
}

void vtkMRMLFaceToBonePlanNode::SetSkinNodeID(const char* id)
{
  this->SetNodeReferenceID(SkinRole, id);
}

void vtkMRMLFaceToBonePlanNode::SetBoneNodeID(const char* id)
{
  this->SetNodeReferenceID(BoneRole, id);
}

void vtkMRMLFaceToBonePlanNode::SetMeshNodeID(const char* id)
{
  this->SetNodeReferenceID(MeshRole, id);
}

void vtkMRMLFaceToBonePlanNode::SetLandmarksNodeID(const char* id)
{
  this->SetNodeReferenceID(LandmarksRole, id);
}

void vtkMRMLFaceToBonePlanNode::SetTargetNodeID(const char* id)
{
  this->SetNodeReferenceID(TargetRole, id);
}

void vtkMRMLFaceToBonePlanNode::SetOsteotomyNodeID(const char* id)
{
  this->SetNodeReferenceID(OsteotomyRole, id);
}

vtkMRMLLinearTransformNode* vtkMRMLFaceToBonePlanNode::GetTransformNode(int method,
                                                                        const std::string& fragment)
{
  return vtkMRMLLinearTransformNode::SafeDownCast(
      this->GetNodeReference(GetTransformRole(method, fragment).c_str()));
}

vtkMRMLModelNode* vtkMRMLFaceToBonePlanNode::GetFragmentNode(int method,
                                                             const std::string& fragment)
{
  return vtkMRMLModelNode::SafeDownCast(
      this->GetNodeReference(GetFragmentRole(method, fragment).c_str()));
}

vtkMRMLModelNode* vtkMRMLFaceToBonePlanNode::GetPredictionNode(int method)
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(GetPredictionRole(method).c_str()));
}

// --- Results

#define vtkMRMLFaceToBoneSetListMacro(name)                                                        \
  void vtkMRMLFaceToBonePlanNode::Set##name(const std::vector<std::string>& members)               \
  {                                                                                                \
    if (this->name == members)                                                                     \
      return;                                                                                      \
    this->name = members;                                                                          \
    this->Modified();                                                                              \
  }
vtkMRMLFaceToBoneSetListMacro(Warnings);
vtkMRMLFaceToBoneSetListMacro(Findings);
vtkMRMLFaceToBoneSetListMacro(Suggestions);
#undef vtkMRMLFaceToBoneSetListMacro

vtkMRMLFaceToBonePlannedMovement*
vtkMRMLFaceToBonePlanNode::FindMovement(int method, const std::string& fragment)
{
  if (method < 0 || method >= Method_Last)
  {
    vtkErrorMacro("there is no method " << method);
    return nullptr;
  }
  for (vtkMRMLFaceToBonePlannedMovement& movement : this->Movements[method])
    if (movement.Fragment == fragment)
      return &movement;
  return nullptr;
}

void vtkMRMLFaceToBonePlanNode::SetMovement(int method, const std::string& fragment,
                                            const double movement[6], const double reference_ras[3])
{
  vtkMRMLFaceToBonePlannedMovement* planned = this->FindMovement(method, fragment);
  if (!planned && method >= 0 && method < Method_Last)
  {
    this->Movements[method].emplace_back();
    planned = &this->Movements[method].back();
    planned->Fragment = fragment;
  }
  if (!planned)
    return;
  const bool moved = planned->Movement.Set(movement);
  if (planned->Reference.Set(reference_ras) || moved)
    this->Modified();
}

bool vtkMRMLFaceToBonePlanNode::GetMovement(int method, const std::string& fragment,
                                            double movement[6])
{
  const auto* planned = this->FindMovement(method, fragment);
  return planned && planned->Movement.Get(movement);
}

bool vtkMRMLFaceToBonePlanNode::GetReferencePoint(int method, const std::string& fragment,
                                                  double point_ras[3])
{
  const auto* planned = this->FindMovement(method, fragment);
  return planned && planned->Reference.Get(point_ras);
}

std::vector<std::string> vtkMRMLFaceToBonePlanNode::GetMovementFragments(int method)
{
  std::vector<std::string> fragments;
  if (method >= 0 && method < Method_Last)
    for (const vtkMRMLFaceToBonePlannedMovement& movement : this->Movements[method])
      fragments.push_back(movement.Fragment);
  return fragments;
}

void vtkMRMLFaceToBonePlanNode::SetMovementInterval(int method, const std::string& fragment,
                                                    int coordinate, const double interval[2])
{
  auto* planned = this->FindMovement(method, fragment);
  if (planned && coordinate >= 0 && coordinate < 6 && planned->Intervals[coordinate].Set(interval))
    this->Modified();
}

bool vtkMRMLFaceToBonePlanNode::GetMovementInterval(int method, const std::string& fragment,
                                                    int coordinate, double interval[2])
{
  const auto* planned = this->FindMovement(method, fragment);
  return planned && coordinate >= 0 && coordinate < 6 &&
         planned->Intervals[coordinate].Get(interval);
}

void vtkMRMLFaceToBonePlanNode::RemoveMovements()
{
  bool had = false;
  for (auto& movements : this->Movements)
  {
    had = had || !movements.empty();
    movements.clear();
  }
  if (had)
    this->Modified();
}

void vtkMRMLFaceToBonePlanNode::SetFigure(const std::string& name, double value)
{
  // a list of name=value keeps only numbers, and names without '='
  if (!std::isfinite(value) || name.empty() || name.find('=') != std::string::npos)
  {
    vtkErrorMacro("'" << name << "' = " << value << " is no figure");
    return;
  }
  const auto known = this->Figures.find(name);
  if (known != this->Figures.end() && known->second == value)
    return;
  this->Figures[name] = value;
  this->Modified();
}

double vtkMRMLFaceToBonePlanNode::GetFigure(const std::string& name)
{
  const auto known = this->Figures.find(name);
  return known == this->Figures.end() ? std::nan("") : known->second;
}

std::vector<std::string> vtkMRMLFaceToBonePlanNode::GetFigureNames()
{
  std::vector<std::string> names;
  for (const auto& figure : this->Figures)
    names.push_back(figure.first);
  return names;
}

void vtkMRMLFaceToBonePlanNode::RemoveFigures(const std::string& beginning)
{
  const std::size_t before = this->Figures.size();
  for (auto figure = this->Figures.begin(); figure != this->Figures.end();)
    figure = figure->first.compare(0, beginning.size(), beginning) == 0
                 ? this->Figures.erase(figure)
                 : std::next(figure);
  if (this->Figures.size() != before)
    this->Modified();
}

// --- How far it has come

void vtkMRMLFaceToBonePlanNode::SetStepStatus(int step, int status)
{
  if (step < 0 || step >= Step_Last || status < 0 || status >= StepStatus_Last)
    vtkErrorMacro("step " << step << " cannot have status " << status);
  else if (this->StepStatus[step] != status)
  {
    this->StepStatus[step] = status;
    this->Modified();
  }
}

int vtkMRMLFaceToBonePlanNode::GetStepStatus(int step)
{
  return step >= 0 && step < Step_Last ? this->StepStatus[step] : static_cast<int>(NotDone);
}

std::string vtkMRMLFaceToBonePlanNode::GetStepStatusesAsText()
{
  std::vector<std::string> statuses;
  for (int step = 0; step < Step_Last; ++step)
    if (this->StepStatus[step] != NotDone)
      statuses.push_back(std::string(StepNames[step]) + ":" +
                         StepStatusNames[this->StepStatus[step]]);
  return vtkMRMLFaceToBoneText::FromList(statuses);
}

void vtkMRMLFaceToBonePlanNode::SetStepStatusesFromText(const std::string& text)
{
  std::fill(std::begin(this->StepStatus), std::end(this->StepStatus), static_cast<int>(NotDone));
  for (const std::string& pair : vtkMRMLFaceToBoneText::ToList(text))
  {
    const std::size_t colon = pair.find(':');
    const int step = GetStepFromString(pair.substr(0, colon).c_str());
    const int status =
        colon == std::string::npos ? -1 : IndexOf(pair.substr(colon + 1).c_str(), StepStatusNames);
    if (step >= 0 && status >= 0)
      this->StepStatus[step] = status;
  }
}

void vtkMRMLFaceToBonePlanNode::SetProgress(double fraction, const std::string& text)
{
  if (this->Progress == fraction && this->ProgressText == text)
    return;
  this->Progress = fraction;
  this->ProgressText = text;
  this->InvokeEvent(ProgressEvent);
}
