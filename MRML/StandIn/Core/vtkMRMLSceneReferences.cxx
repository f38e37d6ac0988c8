// vtkMRMLScene's index of who refers to whom.
#include "vtkMRMLNode.h"
#include "vtkMRMLScene.h"

#include <vtkCollection.h>

#include <algorithm>

void vtkMRMLScene::AddReferencedNodeID(const char* id, vtkMRMLNode* refrencingNode)
{
  if (id && *id && refrencingNode && refrencingNode->GetID())
  {
    this->NodeReferences[id].insert(refrencingNode->GetID());
  }
}

void vtkMRMLScene::RemoveReferencedNodeID(const char* id, vtkMRMLNode* refrencingNode)
{
  const auto found = this->NodeReferences.find(id ? id : "");
  if (found != this->NodeReferences.end() && refrencingNode && refrencingNode->GetID())
  {
    found->second.erase(refrencingNode->GetID());
  }
}

bool vtkMRMLScene::IsNodeReferencingNodeID(vtkMRMLNode* referencingNode, const char* id)
{
  const auto found = this->NodeReferences.find(id ? id : "");
  return found != this->NodeReferences.end() && referencingNode && referencingNode->GetID() &&
         found->second.count(referencingNode->GetID()) > 0;
}

int vtkMRMLScene::GetNumberOfNodeReferences()
{
  std::size_t count = 0;
  for (const auto& [id, referencing] : this->NodeReferences)
  {
    count += referencing.size();
  }
  return static_cast<int>(count);
}

void vtkMRMLScene::RemoveNodeReferences(vtkMRMLNode* node)
{
  if (!node || !node->GetID())
  {
    return;
  }
  for (auto& [id, referencing] : this->NodeReferences)
  {
    referencing.erase(node->GetID());
  }
}

void vtkMRMLScene::RemoveReferencesToNode(vtkMRMLNode* node)
{
  if (node && node->GetID())
  {
    this->NodeReferences.erase(node->GetID());
  }
}

void vtkMRMLScene::RemoveUnusedNodeReferences()
{
  for (auto entry = this->NodeReferences.begin(); entry != this->NodeReferences.end();)
  {
    std::set<std::string>& referencing = entry->second;
    for (auto id = referencing.begin(); id != referencing.end();)
    {
      id = this->GetNodeByID(*id) ? std::next(id) : referencing.erase(id);
    }
    entry = referencing.empty() || !this->GetNodeByID(entry->first)
                ? this->NodeReferences.erase(entry)
                : std::next(entry);
  }
}

void vtkMRMLScene::UpdateNodeReferences(vtkCollection* checkNodes)
{
  for (const auto& [oldID, newID] : this->ReferencedIDChanges)
  {
    // A copy: telling a node changes the index.
    const std::set<std::string> referencing = this->NodeReferences[oldID];
    for (const std::string& id : referencing)
    {
      vtkMRMLNode* node = this->GetNodeByID(id);
      if (node && (!checkNodes || checkNodes->IsItemPresent(node)))
      {
        node->UpdateReferenceID(oldID.c_str(), newID.c_str());
        this->RemoveReferencedNodeID(oldID.c_str(), node);
        this->AddReferencedNodeID(newID.c_str(), node);
      }
    }
  }
}

const char* vtkMRMLScene::GetChangedID(const char* id)
{
  const auto found = this->ReferencedIDChanges.find(id ? id : "");
  return found == this->ReferencedIDChanges.end() ? nullptr : found->second.c_str();
}

vtkCollection* vtkMRMLScene::GetReferencedNodes(vtkMRMLNode* node, bool recursive)
{
  vtkCollection* found = vtkCollection::New();
  if (!node)
  {
    return found;
  }
  found->AddItem(node);
  for (int next = 0; next < (recursive ? found->GetNumberOfItems() : 1); ++next)
  {
    auto* from = static_cast<vtkMRMLNode*>(found->GetItemAsObject(next));
    for (const auto& [id, referencing] : this->NodeReferences)
    {
      vtkMRMLNode* referenced = this->GetNodeByID(id);
      if (referenced && from->GetID() && referencing.count(from->GetID()) > 0 &&
          !found->IsItemPresent(referenced))
      {
        found->AddItem(referenced);
      }
    }
  }
  return found;
}

void vtkMRMLScene::GetReferencingNodes(vtkMRMLNode* referencedNode,
                                       std::vector<vtkMRMLNode*>& referencingNodes)
{
  referencingNodes.clear();
  const auto found = this->NodeReferences.find(
      referencedNode && referencedNode->GetID() ? referencedNode->GetID() : "");
  if (found == this->NodeReferences.end())
  {
    return;
  }
  for (const std::string& id : found->second)
  {
    if (vtkMRMLNode* node = this->GetNodeByID(id))
    {
      referencingNodes.push_back(node);
    }
  }
}
