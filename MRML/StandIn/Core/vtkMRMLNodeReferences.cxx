// vtkMRMLNode's references to other nodes.
#include "vtkMRMLNode.h"
#include "vtkMRMLScene.h"

#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkMRMLNode::vtkMRMLNodeReference);

vtkMRMLNode::vtkMRMLNodeReference::~vtkMRMLNodeReference()
{
  delete[] this->ReferenceRole;
  delete[] this->ReferencedNodeID;
}

void vtkMRMLNode::AddNodeReferenceRole(const char* referenceRole, const char* mrmlAttributeName,
                                       vtkIntArray* events)
{
  if (!referenceRole || !*referenceRole)
  {
    return;
  }
  this->NodeReferenceMRMLAttributeNames[referenceRole] =
      mrmlAttributeName ? mrmlAttributeName : referenceRole;
  if (!this->IsReferenceRoleGeneric(referenceRole))
  {
    this->NodeReferences[referenceRole];
  }
  std::vector<int>& observed = this->NodeReferenceEvents[referenceRole];
  observed.clear();
  for (vtkIdType i = 0; events && i < events->GetNumberOfTuples(); ++i)
  {
    observed.push_back(events->GetValue(i));
  }
}

bool vtkMRMLNode::IsReferenceRoleGeneric(const char* refRole)
{
  return refRole && *refRole && std::string(refRole).back() == '/';
}

const char* vtkMRMLNode::GetReferenceRoleFromMRMLAttributeName(const char* attName)
{
  const std::string name = attName ? attName : "";
  for (const auto& [role, roleAttribute] : this->NodeReferenceMRMLAttributeNames)
  {
    if (roleAttribute == name)
    {
      return role.c_str();
    }
    // "lengthUnitRef" of the group "unit/" with the attribute "UnitRef" is "unit/length".
    if (this->IsReferenceRoleGeneric(role.c_str()) &&
        vtksys::SystemTools::StringEndsWith(name, roleAttribute.c_str()))
    {
      this->EncodedText = role + name.substr(0, name.size() - roleAttribute.size());
      return this->EncodedText.c_str();
    }
  }
  return nullptr;
}

const char* vtkMRMLNode::GetMRMLAttributeNameFromReferenceRole(const char* refRole)
{
  const std::string role = refRole ? refRole : "";
  const auto found = this->NodeReferenceMRMLAttributeNames.find(role);
  if (found != this->NodeReferenceMRMLAttributeNames.end())
  {
    return found->second.c_str();
  }
  for (const auto& [group, attribute] : this->NodeReferenceMRMLAttributeNames)
  {
    if (this->IsReferenceRoleGeneric(group.c_str()) &&
        vtksys::SystemTools::StringStartsWith(role, group.c_str()))
    {
      this->EncodedText = role.substr(group.size()) + attribute;
      return this->EncodedText.c_str();
    }
  }
  return nullptr;
}

// --- Setting -----------------------------------------------------------------------------------

vtkMRMLNode* vtkMRMLNode::SetNodeReferenceID(const char* referenceRole,
                                             const char* referencedNodeID)
{
  return this->SetAndObserveNthNodeReferenceID(referenceRole, 0, referencedNodeID);
}

vtkMRMLNode* vtkMRMLNode::AddNodeReferenceID(const char* referenceRole,
                                             const char* referencedNodeID)
{
  return this->AddAndObserveNodeReferenceID(referenceRole, referencedNodeID);
}

vtkMRMLNode* vtkMRMLNode::SetNthNodeReferenceID(const char* referenceRole, int n,
                                                const char* referencedNodeID)
{
  return this->SetAndObserveNthNodeReferenceID(referenceRole, n, referencedNodeID);
}

vtkMRMLNode* vtkMRMLNode::SetAndObserveNodeReferenceID(const char* referenceRole,
                                                       const char* referencedNodeID,
                                                       vtkIntArray* events)
{
  return this->SetAndObserveNthNodeReferenceID(referenceRole, 0, referencedNodeID, events);
}

vtkMRMLNode* vtkMRMLNode::AddAndObserveNodeReferenceID(const char* referenceRole,
                                                       const char* referencedNodeID,
                                                       vtkIntArray* events)
{
  return this->SetAndObserveNthNodeReferenceID(
      referenceRole, this->GetNumberOfNodeReferences(referenceRole), referencedNodeID, events);
}

vtkMRMLNode* vtkMRMLNode::SetAndObserveNthNodeReferenceID(const char* referenceRole, int n,
                                                          const char* referencedNodeID,
                                                          vtkIntArray* events)
{
  if (!referenceRole || n < 0)
  {
    vtkErrorMacro("SetAndObserveNthNodeReferenceID: needs a role and an index from 0");
    return nullptr;
  }
  const std::string role = referenceRole;
  const std::string id = referencedNodeID ? referencedNodeID : "";
  return id.empty() ? this->RemoveReference(role, n)
                    : this->SetReference(role, n, id, this->EventsOfRole(role, events));
}

std::vector<int> vtkMRMLNode::EventsOfRole(const std::string& role, vtkIntArray* events)
{
  std::vector<int> observed;
  for (vtkIdType i = 0; events && i < events->GetNumberOfTuples(); ++i)
  {
    observed.push_back(events->GetValue(i));
  }
  if (!events)
  {
    const std::string group = role.substr(0, role.find('/') + 1);
    for (const std::string& key : {role, group})
    {
      const auto found = this->NodeReferenceEvents.find(key);
      if (observed.empty() && found != this->NodeReferenceEvents.end())
      {
        observed = found->second;
      }
    }
  }
  return observed;
}

vtkMRMLNode* vtkMRMLNode::SetReference(const std::string& role, int n,
                                       const std::string& referencedID,
                                       const std::vector<int>& events)
{
  NodeReferenceListType& references = this->NodeReferences[role];
  if (n >= static_cast<int>(references.size()))
  {
    vtkNew<vtkMRMLNodeReference> created;
    created->SetReferencingNode(this);
    created->SetReferenceRole(role.c_str());
    references.emplace_back(created);
    n = static_cast<int>(references.size()) - 1;
  }
  // Held here: observers of what follows may remove the reference or its node.
  const vtkSmartPointer<vtkMRMLNodeReference> reference = references[n];
  const vtkSmartPointer<vtkMRMLNode> before = reference->GetReferencedNode();
  const std::string oldID =
      reference->GetReferencedNodeID() ? reference->GetReferencedNodeID() : "";
  const vtkSmartPointer<vtkMRMLNode> after =
      this->Scene ? this->Scene->GetNodeByID(referencedID) : nullptr;

  reference->SetReferencedNodeID(referencedID.c_str());
  reference->SetReferencedNode(after);
  reference->ObservedEvents = events;
  this->ObserveReferencedNode(before);
  this->ObserveReferencedNode(after);
  this->NotifyReference(reference, before);
  this->TellSceneOfReference(oldID, referencedID);
  return after;
}

vtkMRMLNode* vtkMRMLNode::RemoveReference(const std::string& role, int n)
{
  NodeReferenceListType& references = this->NodeReferences[role];
  if (n >= static_cast<int>(references.size()))
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkMRMLNodeReference> reference = references[n];
  const vtkSmartPointer<vtkMRMLNode> before = reference->GetReferencedNode();
  const std::string oldID =
      reference->GetReferencedNodeID() ? reference->GetReferencedNodeID() : "";
  references.erase(references.begin() + n);
  this->ObserveReferencedNode(before);
  if (before)
  {
    this->OnNodeReferenceRemoved(reference);
  }
  reference->SetReferencedNode(nullptr);
  this->TellSceneOfReference(oldID, "");
  return nullptr;
}

void vtkMRMLNode::NotifyReference(vtkMRMLNodeReference* reference, vtkMRMLNode* before)
{
  vtkMRMLNode* after = reference->GetReferencedNode();
  if (before == after)
  {
    return;
  }
  if (!before)
  {
    this->OnNodeReferenceAdded(reference);
  }
  else if (!after)
  {
    this->OnNodeReferenceRemoved(reference);
  }
  else
  {
    this->OnNodeReferenceModified(reference);
  }
}

void vtkMRMLNode::TellSceneOfReference(const std::string& oldID, const std::string& newID)
{
  if (oldID == newID)
  {
    return;
  }
  this->Modified();
  if (!this->Scene)
  {
    return;
  }
  if (!oldID.empty() && !this->HasNodeReferenceID(nullptr, oldID.c_str()))
  {
    this->Scene->RemoveReferencedNodeID(oldID.c_str(), this);
  }
  if (!newID.empty())
  {
    this->Scene->AddReferencedNodeID(newID.c_str(), this);
  }
}

/// Observes the union of the events of all references to this node; none where there is none left.
void vtkMRMLNode::ObserveReferencedNode(vtkMRMLNode* referenced)
{
  if (!referenced)
  {
    return;
  }
  std::set<int> events;
  for (const auto& [role, references] : this->NodeReferences)
  {
    for (const auto& reference : references)
    {
      if (reference->GetReferencedNode() == referenced)
      {
        events.insert(reference->ObservedEvents.begin(), reference->ObservedEvents.end());
      }
    }
  }
  std::vector<unsigned long>& tags = this->ReferenceObservations[referenced];
  for (const unsigned long tag : tags)
  {
    referenced->RemoveObserver(tag);
  }
  tags.clear();
  for (const int event : events)
  {
    tags.push_back(referenced->AddObserver(event, this->MRMLCallbackCommand));
  }
  if (tags.empty())
  {
    this->ReferenceObservations.erase(referenced);
  }
}

void vtkMRMLNode::OnNodeReferenceAdded(vtkMRMLNodeReference* reference)
{
  this->InvokeEvent(vtkMRMLNode::ReferenceAddedEvent, reference);
}

void vtkMRMLNode::OnNodeReferenceModified(vtkMRMLNodeReference* reference)
{
  this->InvokeEvent(vtkMRMLNode::ReferenceModifiedEvent, reference);
}

void vtkMRMLNode::OnNodeReferenceRemoved(vtkMRMLNodeReference* reference)
{
  this->InvokeEvent(vtkMRMLNode::ReferenceRemovedEvent, reference);
}

void vtkMRMLNode::RemoveNthNodeReferenceID(const char* referenceRole, int n)
{
  this->SetAndObserveNthNodeReferenceID(referenceRole, n, nullptr);
}

void vtkMRMLNode::RemoveNodeReferenceIDs(const char* referenceRole)
{
  MRMLNodeModifyBlocker blocker(this);
  if (referenceRole)
  {
    while (this->GetNumberOfNodeReferences(referenceRole) > 0)
    {
      this->RemoveNthNodeReferenceID(referenceRole, 0);
    }
    return;
  }
  std::vector<std::string> roles;
  this->GetNodeReferenceRoles(roles);
  for (const std::string& role : roles)
  {
    this->RemoveNodeReferenceIDs(role.c_str());
  }
}

// --- Getting -----------------------------------------------------------------------------------

bool vtkMRMLNode::HasNodeReferenceID(const char* referenceRole, const char* referencedNodeID)
{
  if (!referencedNodeID)
  {
    return false;
  }
  const std::string id = referencedNodeID;
  for (const auto& [role, references] : this->NodeReferences)
  {
    if ((!referenceRole || role == referenceRole) &&
        std::any_of(references.begin(), references.end(),
                    [&id](const auto& reference)
                    { return id == reference->GetReferencedNodeID(); }))
    {
      return true;
    }
  }
  return false;
}

int vtkMRMLNode::GetNumberOfNodeReferences(const char* referenceRole)
{
  const auto found = this->NodeReferences.find(referenceRole ? referenceRole : "");
  return found == this->NodeReferences.end() ? 0 : static_cast<int>(found->second.size());
}

const char* vtkMRMLNode::GetNthNodeReferenceID(const char* referenceRole, int n)
{
  if (n < 0 || n >= this->GetNumberOfNodeReferences(referenceRole))
  {
    return nullptr;
  }
  return this->NodeReferences[referenceRole][n]->GetReferencedNodeID();
}

const char* vtkMRMLNode::GetNodeReferenceID(const char* referenceRole)
{
  return this->GetNthNodeReferenceID(referenceRole, 0);
}

vtkMRMLNode* vtkMRMLNode::GetNthNodeReference(const char* referenceRole, int n)
{
  if (n < 0 || n >= this->GetNumberOfNodeReferences(referenceRole))
  {
    return nullptr;
  }
  vtkMRMLNode* node = this->NodeReferences[referenceRole][n]->GetReferencedNode();
  if (!node || node->GetScene() != this->GetScene() || !this->GetScene())
  {
    this->UpdateNthNodeReference(referenceRole, n);
    node = n < this->GetNumberOfNodeReferences(referenceRole)
               ? this->NodeReferences[referenceRole][n]->GetReferencedNode()
               : nullptr;
  }
  return node;
}

vtkMRMLNode* vtkMRMLNode::GetNodeReference(const char* referenceRole)
{
  return this->GetNthNodeReference(referenceRole, 0);
}

void vtkMRMLNode::GetNodeReferences(const char* referenceRole, std::vector<vtkMRMLNode*>& nodes)
{
  for (int n = 0; n < this->GetNumberOfNodeReferences(referenceRole); ++n)
  {
    nodes.push_back(this->GetNthNodeReference(referenceRole, n));
  }
}

void vtkMRMLNode::GetNodeReferenceIDs(const char* referenceRole,
                                      std::vector<const char*>& referencedNodeIDs)
{
  for (int n = 0; n < this->GetNumberOfNodeReferences(referenceRole); ++n)
  {
    referencedNodeIDs.push_back(this->GetNthNodeReferenceID(referenceRole, n));
  }
}

void vtkMRMLNode::GetNodeReferenceRoles(std::vector<std::string>& roles)
{
  roles.clear();
  for (const auto& entry : this->NodeReferences)
  {
    roles.push_back(entry.first);
  }
}

int vtkMRMLNode::GetNumberOfNodeReferenceRoles()
{
  return static_cast<int>(this->NodeReferences.size());
}

const char* vtkMRMLNode::GetNthNodeReferenceRole(int n)
{
  return n < 0 || n >= this->GetNumberOfNodeReferenceRoles()
             ? nullptr
             : std::next(this->NodeReferences.begin(), n)->first.c_str();
}

// --- In a scene --------------------------------------------------------------------------------

vtkMRMLScene* vtkMRMLNode::GetScene()
{
  return this->Scene;
}

void vtkMRMLNode::SetScene(vtkMRMLScene* scene)
{
  if (this->Scene == scene)
  {
    return;
  }
  if (this->Scene)
  {
    this->InvalidateNodeReferences();
  }
  this->Scene = scene;
  if (scene)
  {
    this->SetSceneReferences();
  }
}

void vtkMRMLNode::SetSceneReferences()
{
  for (const auto& [role, references] : this->NodeReferences)
  {
    for (const auto& reference : references)
    {
      this->Scene->AddReferencedNodeID(reference->GetReferencedNodeID(), this);
    }
  }
}

void vtkMRMLNode::UpdateNodeReferences(const char* referenceRole)
{
  MRMLNodeModifyBlocker blocker(this);
  std::vector<std::string> roles{referenceRole ? referenceRole : ""};
  if (!referenceRole)
  {
    this->GetNodeReferenceRoles(roles);
  }
  for (const std::string& role : roles)
  {
    for (int n = 0; n < this->GetNumberOfNodeReferences(role.c_str()); ++n)
    {
      this->UpdateNthNodeReference(role.c_str(), n);
    }
  }
}

void vtkMRMLNode::UpdateNthNodeReference(const char* referenceRole, int n)
{
  const vtkSmartPointer<vtkMRMLNodeReference> reference = this->NodeReferences[referenceRole][n];
  const std::vector<int> events = reference->ObservedEvents.empty()
                                      ? this->EventsOfRole(referenceRole, nullptr)
                                      : reference->ObservedEvents;
  this->SetReference(referenceRole, n, reference->GetReferencedNodeID(), events);
}

void vtkMRMLNode::InvalidateNodeReferences()
{
  for (const auto& [role, references] : this->NodeReferences)
  {
    for (const auto& reference : references)
    {
      const vtkSmartPointer<vtkMRMLNode> node = reference->GetReferencedNode();
      reference->SetReferencedNode(nullptr);
      this->ObserveReferencedNode(node);
    }
  }
}

void vtkMRMLNode::UpdateReferences()
{
  if (!this->Scene)
  {
    return;
  }
  std::vector<std::string> roles;
  this->GetNodeReferenceRoles(roles);
  for (const std::string& role : roles)
  {
    for (int n = this->GetNumberOfNodeReferences(role.c_str()) - 1; n >= 0; --n)
    {
      if (!this->Scene->GetNodeByID(this->GetNthNodeReferenceID(role.c_str(), n)))
      {
        this->RemoveNthNodeReferenceID(role.c_str(), n);
      }
    }
  }
}

void vtkMRMLNode::RemoveInvalidReferences(const std::set<std::string>& validNodeIDs)
{
  std::vector<std::string> roles;
  this->GetNodeReferenceRoles(roles);
  for (const std::string& role : roles)
  {
    for (int n = this->GetNumberOfNodeReferences(role.c_str()) - 1; n >= 0; --n)
    {
      const std::string id = this->GetNthNodeReferenceID(role.c_str(), n);
      vtkMRMLNode* node = this->Scene ? this->Scene->GetNodeByID(id) : nullptr;
      if (validNodeIDs.count(id) == 0 && !(node && node->IsSingleton()))
      {
        this->RemoveNthNodeReferenceID(role.c_str(), n);
      }
    }
  }
}

void vtkMRMLNode::UpdateReferenceID(const char* oldID, const char* newID)
{
  MRMLNodeModifyBlocker blocker(this);
  const std::string before = oldID;
  const std::string after = newID;
  std::vector<std::string> roles;
  this->GetNodeReferenceRoles(roles);
  for (const std::string& role : roles)
  {
    for (int n = 0; n < this->GetNumberOfNodeReferences(role.c_str()); ++n)
    {
      if (before == this->GetNthNodeReferenceID(role.c_str(), n))
      {
        const std::vector<int> events = this->NodeReferences[role][n]->ObservedEvents;
        this->SetReference(role, n, after, events);
      }
    }
  }
}

void vtkMRMLNode::CopyReferences(vtkMRMLNode* node)
{
  this->NodeReferenceMRMLAttributeNames = node->NodeReferenceMRMLAttributeNames;
  this->NodeReferenceEvents = node->NodeReferenceEvents;
  const auto ids = [](vtkMRMLNode* of)
  {
    std::map<std::string, std::vector<std::pair<std::string, std::vector<int>>>> all;
    for (const auto& [role, references] : of->NodeReferences)
    {
      for (const auto& reference : references)
      {
        all[role].emplace_back(reference->GetReferencedNodeID(), reference->ObservedEvents);
      }
    }
    return all;
  };
  const auto wanted = ids(node);
  if (ids(this) == wanted)
  {
    return;
  }
  this->RemoveNodeReferenceIDs(nullptr);
  // Only the ids: in an import they may still change before the nodes are looked up.
  for (const auto& [role, references] : wanted)
  {
    for (const auto& [id, events] : references)
    {
      vtkNew<vtkMRMLNodeReference> copied;
      copied->SetReferenceRole(role.c_str());
      copied->SetReferencedNodeID(id.c_str());
      copied->SetReferencingNode(this);
      copied->ObservedEvents = events;
      this->NodeReferences[role].emplace_back(copied);
    }
  }
}
