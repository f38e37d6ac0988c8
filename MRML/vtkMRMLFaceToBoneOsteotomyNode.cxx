#include "vtkMRMLFaceToBoneOsteotomyNode.h"

#include "vtkMRMLFaceToBoneFragment.h"

#include <vtkMRMLModelNode.h>

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>

vtkMRMLNodeNewMacro(vtkMRMLFaceToBoneOsteotomyNode);

vtkMRMLFaceToBoneOsteotomyNode::vtkMRMLFaceToBoneOsteotomyNode()
{
  this->HideFromEditors = 0;
  for (const char* role : {BoneRole, UncutBoneRole, LandmarksRole})
    this->AddNodeReferenceRole(role);
  this->AddNodeReferenceRole(CutPlanesRole, "CutPlanesRef");
  this->AddNodeReferenceRole(CutCurvesRole, "CutCurvesRef");
  this->AddNodeReferenceRole(RestFragmentRole, "RestFragmentRef");
}

vtkMRMLFaceToBoneOsteotomyNode::~vtkMRMLFaceToBoneOsteotomyNode() = default;

void vtkMRMLFaceToBoneOsteotomyNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::ReadXMLAttributes(atts);
  std::map<int, vtkMRMLFaceToBoneFragment> fragments;
  vtkMRMLReadXMLBeginMacro(atts);
  char* end = nullptr;
  if (!strncmp(xmlReadAttName, "fragment", 8) && xmlReadAttName[8] != '\0')
  {
    const long index = std::strtol(xmlReadAttName + 8, &end, 10);
    if (*end == '\0')
      fragments[static_cast<int>(index)] = vtkMRMLFaceToBoneFragment::FromText(xmlReadAttValue);
  }
  vtkMRMLReadXMLEndMacro();
  this->Fragments.clear();
  for (const auto& fragment : fragments)
  {
    if (vtkMRMLFaceToBoneFragment::IsValidName(fragment.second.Name) &&
        this->GetFragmentIndex(fragment.second.Name) < 0)
      this->Fragments.push_back(fragment.second);
    else
      vtkErrorMacro("ReadXMLAttributes: '" << fragment.second.Name
                                           << "' cannot be the name of a fragment");
  }
  this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::WriteXML(ostream& of, int indent)
{
  Superclass::WriteXML(of, indent);
  for (std::size_t n = 0; n < this->Fragments.size(); ++n)
    of << " fragment" << n << "=\"" << this->XMLAttributeEncodeString(this->Fragments[n].ToText())
       << "\"";
}

void vtkMRMLFaceToBoneOsteotomyNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  Superclass::CopyContent(anode, deepCopy);
  const auto* node = vtkMRMLFaceToBoneOsteotomyNode::SafeDownCast(anode);
  if (!node)
  {
    vtkErrorMacro("Copy failed: invalid source node");
    return;
  }
  bool same = node->Fragments.size() == this->Fragments.size();
  for (std::size_t n = 0; same && n < this->Fragments.size(); ++n)
    same = node->Fragments[n].ToText() == this->Fragments[n].ToText();
  if (same)
    return;
  this->Fragments = node->Fragments;
  this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::PrintSelf(ostream& os, vtkIndent indent)
{
  Superclass::PrintSelf(os, indent);
  for (const vtkMRMLFaceToBoneFragment& fragment : this->Fragments)
    os << indent << "Fragment: " << fragment.ToText() << "\n";
}

const char* vtkMRMLFaceToBoneOsteotomyNode::GetCoordinateAsString(int coordinate)
{
  return coordinate >= 0 && coordinate < Coordinate_Last
             ? vtkMRMLFaceToBoneFragment::CoordinateNames[coordinate]
             : "";
}

int vtkMRMLFaceToBoneOsteotomyNode::GetCoordinateFromString(const char* coordinate)
{
  for (int c = 0; coordinate && c < Coordinate_Last; ++c)
    if (!strcmp(coordinate, vtkMRMLFaceToBoneFragment::CoordinateNames[c]))
      return c;
  return -1;
}

vtkMRMLFaceToBoneFragment* vtkMRMLFaceToBoneOsteotomyNode::GetNthFragment(int n)
{
  const bool known = n >= 0 && n < this->GetNumberOfFragments();
  if (!known)
    vtkErrorMacro("there is no fragment " << n);
  return known ? &this->Fragments[static_cast<std::size_t>(n)] : nullptr;
}

std::string vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentRole(int n, const char* role)
{
  return role + this->GetNthFragmentName(n);
}

int vtkMRMLFaceToBoneOsteotomyNode::GetNumberOfFragments()
{
  return static_cast<int>(this->Fragments.size());
}

int vtkMRMLFaceToBoneOsteotomyNode::GetFragmentIndex(const std::string& name)
{
  for (int n = 0; n < this->GetNumberOfFragments(); ++n)
    if (this->Fragments[static_cast<std::size_t>(n)].Name == name)
      return n;
  return -1;
}

int vtkMRMLFaceToBoneOsteotomyNode::AddFragment(const std::string& name)
{
  if (!vtkMRMLFaceToBoneFragment::IsValidName(name) || this->GetFragmentIndex(name) >= 0)
    return -1;
  vtkMRMLFaceToBoneFragment fragment;
  fragment.Name = name;
  this->Fragments.push_back(fragment);
  this->Modified();
  return this->GetNumberOfFragments() - 1;
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveNthFragment(int n)
{
  if (!this->GetNthFragment(n))
    return;
  MRMLNodeModifyBlocker blocker(this);
  for (const char* role : {CutPlanesRole, CutCurvesRole, RestFragmentRole})
    this->RemoveNodeReferenceIDs(this->GetNthFragmentRole(n, role).c_str());
  this->Fragments.erase(this->Fragments.begin() + n);
  this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveAllFragments()
{
  MRMLNodeModifyBlocker blocker(this);
  while (!this->Fragments.empty())
    this->RemoveNthFragment(this->GetNumberOfFragments() - 1);
}

std::string vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentName(int n)
{
  const vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  return fragment ? fragment->Name : std::string();
}

bool vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentName(int n, const std::string& name)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  if (!fragment || !vtkMRMLFaceToBoneFragment::IsValidName(name))
    return false;
  if (fragment->Name == name)
    return true;
  if (this->GetFragmentIndex(name) >= 0)
    return false;
  MRMLNodeModifyBlocker blocker(this);
  this->MoveReferences(fragment->Name, name);
  fragment->Name = name;
  this->Modified();
  return true;
}

void vtkMRMLFaceToBoneOsteotomyNode::SortFragments(const std::vector<std::string>& names)
{
  auto rank = [&](const vtkMRMLFaceToBoneFragment& fragment)
  { return std::find(names.begin(), names.end(), fragment.Name) - names.begin(); };
  auto before = [&](const vtkMRMLFaceToBoneFragment& a, const vtkMRMLFaceToBoneFragment& b)
  { return rank(a) < rank(b); };
  if (std::is_sorted(this->Fragments.begin(), this->Fragments.end(), before))
    return;
  std::stable_sort(this->Fragments.begin(), this->Fragments.end(), before);
  this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::MoveReferences(const std::string& from, const std::string& to)
{
  for (const char* role : {CutPlanesRole, CutCurvesRole, RestFragmentRole})
  {
    const std::string old_role = role + from, new_role = role + to;
    this->RemoveNodeReferenceIDs(new_role.c_str());
    for (int i = 0; i < this->GetNumberOfNodeReferences(old_role.c_str()); ++i)
      this->AddNodeReferenceID(new_role.c_str(), this->GetNthNodeReferenceID(old_role.c_str(), i));
    this->RemoveNodeReferenceIDs(old_role.c_str());
  }
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentTemplate(int n, const std::string& name)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  if (!fragment || fragment->Template == name)
    return;
  fragment->Template = name;
  this->Modified();
}

std::string vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentTemplate(int n)
{
  const vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  return fragment ? fragment->Template : std::string();
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentPoint(int n, const double point_ras[3])
{
  auto* fragment = this->GetNthFragment(n);
  if (fragment && fragment->Point.Set(point_ras))
    this->Modified();
}

bool vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentPoint(int n, double point_ras[3])
{
  const auto* fragment = this->GetNthFragment(n);
  return fragment && fragment->Point.Get(point_ras);
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveNthFragmentPoint(int n)
{
  auto* fragment = this->GetNthFragment(n);
  if (fragment && fragment->Point.Remove())
    this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentKerfMm(int n, double kerf)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  if (!fragment || fragment->KerfMm == kerf)
    return;
  fragment->KerfMm = kerf;
  this->Modified();
}

double vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentKerfMm(int n)
{
  const vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  return fragment ? fragment->KerfMm : 0;
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentPlaneFileNames(
    int n, const std::vector<std::string>& names)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  if (!fragment || fragment->PlaneFileNames == names)
    return;
  fragment->PlaneFileNames = names;
  this->Modified();
}

std::vector<std::string> vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentPlaneFileNames(int n)
{
  const vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  return fragment ? fragment->PlaneFileNames : std::vector<std::string>();
}

int vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentNumberOfPlanes(int n)
{
  return this->GetNumberOfNodeReferences(this->GetNthFragmentRole(n, CutPlanesRole).c_str());
}

vtkMRMLNode* vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentPlaneNode(int n, int plane)
{
  return this->GetNthNodeReference(this->GetNthFragmentRole(n, CutPlanesRole).c_str(), plane);
}

void vtkMRMLFaceToBoneOsteotomyNode::AddNthFragmentPlaneNodeID(int n, const char* id)
{
  if (this->GetNthFragment(n))
    this->AddNodeReferenceID(this->GetNthFragmentRole(n, CutPlanesRole).c_str(), id);
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveNthFragmentPlaneNodeIDs(int n)
{
  if (this->GetNthFragment(n))
    this->RemoveNodeReferenceIDs(this->GetNthFragmentRole(n, CutPlanesRole).c_str());
}

int vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentNumberOfCurves(int n)
{
  return this->GetNumberOfNodeReferences(this->GetNthFragmentRole(n, CutCurvesRole).c_str());
}

vtkMRMLNode* vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentCurveNode(int n, int curve)
{
  return this->GetNthNodeReference(this->GetNthFragmentRole(n, CutCurvesRole).c_str(), curve);
}

void vtkMRMLFaceToBoneOsteotomyNode::AddNthFragmentCurveNodeID(int n, const char* id)
{
  if (this->GetNthFragment(n))
    this->AddNodeReferenceID(this->GetNthFragmentRole(n, CutCurvesRole).c_str(), id);
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveNthFragmentCurveNodeIDs(int n)
{
  if (this->GetNthFragment(n))
    this->RemoveNodeReferenceIDs(this->GetNthFragmentRole(n, CutCurvesRole).c_str());
}

vtkMRMLModelNode* vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentRestNode(int n)
{
  return vtkMRMLModelNode::SafeDownCast(
      this->GetNodeReference(this->GetNthFragmentRole(n, RestFragmentRole).c_str()));
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentRestNodeID(int n, const char* id)
{
  if (this->GetNthFragment(n))
    this->SetNodeReferenceID(this->GetNthFragmentRole(n, RestFragmentRole).c_str(), id);
}

vtkMRMLFaceToBoneRule* vtkMRMLFaceToBoneOsteotomyNode::GetNthRule(int n, int coordinate)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  const bool known = coordinate >= 0 && coordinate < Coordinate_Last;
  if (!known)
    vtkErrorMacro("there is no coordinate " << coordinate);
  return fragment && known ? &fragment->Rules[coordinate] : nullptr;
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentLocked(int n, int coordinate, bool locked)
{
  auto* rule = this->GetNthRule(n, coordinate);
  if (!rule || rule->Locked == locked)
    return;
  rule->Locked = locked;
  this->Modified();
}

bool vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentLocked(int n, int coordinate)
{
  const auto* rule = this->GetNthRule(n, coordinate);
  return rule && rule->Locked;
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentBounds(int n, int coordinate,
                                                          const double bounds[2])
{
  if (auto* rule = this->GetNthRule(n, coordinate); rule && rule->Bounds.Set(bounds))
    this->Modified();
}

bool vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentBounds(int n, int coordinate, double bounds[2])
{
  const auto* rule = this->GetNthRule(n, coordinate);
  return rule && rule->Bounds.Get(bounds);
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveNthFragmentBounds(int n, int coordinate)
{
  if (auto* rule = this->GetNthRule(n, coordinate); rule && rule->Bounds.Remove())
    this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentPrior(int n, int coordinate,
                                                         const double expected_sd[2])
{
  if (auto* rule = this->GetNthRule(n, coordinate); rule && rule->Prior.Set(expected_sd))
    this->Modified();
}

bool vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentPrior(int n, int coordinate,
                                                         double expected_sd[2])
{
  const auto* rule = this->GetNthRule(n, coordinate);
  return rule && rule->Prior.Get(expected_sd);
}

void vtkMRMLFaceToBoneOsteotomyNode::RemoveNthFragmentPrior(int n, int coordinate)
{
  if (auto* rule = this->GetNthRule(n, coordinate); rule && rule->Prior.Remove())
    this->Modified();
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentOtherRules(int n, const std::string& rules)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  if (!fragment || fragment->OtherRules == rules)
    return;
  fragment->OtherRules = rules;
  this->Modified();
}

std::string vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentOtherRules(int n)
{
  const vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  return fragment ? fragment->OtherRules : std::string();
}

void vtkMRMLFaceToBoneOsteotomyNode::SetNthFragmentOtherSettings(int n, const std::string& settings)
{
  vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  if (!fragment || fragment->OtherSettings == settings)
    return;
  fragment->OtherSettings = settings;
  this->Modified();
}

std::string vtkMRMLFaceToBoneOsteotomyNode::GetNthFragmentOtherSettings(int n)
{
  const vtkMRMLFaceToBoneFragment* fragment = this->GetNthFragment(n);
  return fragment ? fragment->OtherSettings : std::string();
}

vtkMRMLModelNode* vtkMRMLFaceToBoneOsteotomyNode::GetBoneNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(BoneRole));
}

vtkMRMLModelNode* vtkMRMLFaceToBoneOsteotomyNode::GetUncutBoneNode()
{
  return vtkMRMLModelNode::SafeDownCast(this->GetNodeReference(UncutBoneRole));
}

vtkMRMLNode* vtkMRMLFaceToBoneOsteotomyNode::GetLandmarksNode()
{
  return this->GetNodeReference(LandmarksRole);
}

void vtkMRMLFaceToBoneOsteotomyNode::SetBoneNodeID(const char* id)
{
  this->SetNodeReferenceID(BoneRole, id);
}

void vtkMRMLFaceToBoneOsteotomyNode::SetUncutBoneNodeID(const char* id)
{
  this->SetNodeReferenceID(UncutBoneRole, id);
}

void vtkMRMLFaceToBoneOsteotomyNode::SetLandmarksNodeID(const char* id)
{
  this->SetNodeReferenceID(LandmarksRole, id);
}
