// vtkMRMLScene's undo: each level is the list of undoable nodes, with copies in place of those that
// were going to change.
#include "vtkMRMLNode.h"
#include "vtkMRMLScene.h"

#include <vtkCollection.h>

#include <algorithm>

vtkMRMLScene::SavedState vtkMRMLScene::UndoableNodes()
{
  SavedState nodes;
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    if (this->GetNthNode(n)->GetUndoEnabled())
    {
      nodes.push_back({this->GetNthNode(n), nullptr});
    }
  }
  return nodes;
}

void vtkMRMLScene::SaveCopy(SavedState& state, vtkMRMLNode* node)
{
  for (SavedNode& saved : state)
  {
    if (saved.Node == node && !saved.Copy)
    {
      saved.Copy = vtkSmartPointer<vtkMRMLNode>::Take(node->CreateNodeInstance());
      saved.Copy->CopyWithScene(node);
    }
  }
}

void vtkMRMLScene::SaveStateForUndo(std::vector<vtkMRMLNode*> nodes)
{
  if (!this->UndoFlag || this->IsUndoing() || this->IsRedoing() || this->IsBatchProcessing())
  {
    return;
  }
  this->ClearRedoStack();
  SavedState state = this->UndoableNodes();
  for (vtkMRMLNode* node : nodes)
  {
    SaveCopy(state, node);
  }
  this->UndoStack.push_back(std::move(state));
  this->SetMaximumNumberOfSavedUndoStates(this->MaximumNumberOfSavedUndoStates);
}

void vtkMRMLScene::SaveStateForUndo(vtkMRMLNode* node)
{
  if (!node || node->GetUndoEnabled())
  {
    this->SaveStateForUndo(node ? std::vector<vtkMRMLNode*>{node} : std::vector<vtkMRMLNode*>());
  }
}

void vtkMRMLScene::SaveStateForUndo(vtkCollection* nodes)
{
  std::vector<vtkMRMLNode*> list;
  for (int n = 0; nodes && n < nodes->GetNumberOfItems(); ++n)
  {
    list.push_back(vtkMRMLNode::SafeDownCast(nodes->GetItemAsObject(n)));
  }
  this->SaveStateForUndo(list);
}

void vtkMRMLScene::SaveStateForUndo()
{
  this->SaveStateForUndo(this->Nodes.Get());
}

void vtkMRMLScene::SetMaximumNumberOfSavedUndoStates(int stackSize)
{
  this->MaximumNumberOfSavedUndoStates = std::max(stackSize, 0);
  while (this->GetNumberOfUndoLevels() > this->MaximumNumberOfSavedUndoStates)
  {
    this->UndoStack.pop_front();
  }
}

void vtkMRMLScene::Undo()
{
  if (!this->UndoFlag || this->UndoStack.empty())
  {
    return;
  }
  this->StartState(UndoState);
  SavedState current = this->UndoableNodes();
  const SavedState target = std::move(this->UndoStack.back());
  this->UndoStack.pop_back();
  this->RestoreNodes(target, current);
  this->RedoStack.push_back(std::move(current));
  this->Modified();
  this->EndState(UndoState);
  this->RemoveUnusedNodeReferences();
}

void vtkMRMLScene::Redo()
{
  if (!this->UndoFlag || this->RedoStack.empty())
  {
    return;
  }
  this->StartState(RedoState);
  SavedState current = this->UndoableNodes();
  const SavedState target = std::move(this->RedoStack.back());
  this->RedoStack.pop_back();
  this->RestoreNodes(target, current);
  this->UndoStack.push_back(std::move(current));
  this->Modified();
  this->EndState(RedoState);
  this->RemoveUnusedNodeReferences();
}

void vtkMRMLScene::RestoreNodes(const SavedState& target, SavedState& current)
{
  std::map<std::string, const SavedNode*> wanted;
  for (const SavedNode& saved : target)
  {
    wanted[saved.Node->GetID()] = &saved;
  }
  std::map<std::string, vtkMRMLNode*> live;
  for (const SavedNode& saved : SavedState(current))
  {
    const std::string id = saved.Node->GetID();
    live[id] = saved.Node;
    // Before anything changes: a node that goes takes the references to it along.
    if (wanted.count(id) == 0 || wanted[id]->Copy)
    {
      SaveCopy(current, saved.Node);
    }
  }
  for (const auto& [node, copy] : target)
  {
    if (copy)
    {
      node->CopyWithScene(copy);
    }
    if (live.count(node->GetID()) == 0)
    {
      node->SetScene(nullptr);
      this->AddNode(node);
    }
  }
  for (const auto& [node, copy] : target)
  {
    node->SetSceneReferences();
    node->UpdateNodeReferences();
  }
  for (const auto& [id, node] : live)
  {
    if (wanted.count(id) == 0 && node->GetScene() == this)
    {
      this->RemoveNode(node);
    }
  }
}

void vtkMRMLScene::ClearUndoStack()
{
  this->UndoStack.clear();
}

void vtkMRMLScene::ClearRedoStack()
{
  this->RedoStack.clear();
}
