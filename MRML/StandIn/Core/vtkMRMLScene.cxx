#include "vtkMRMLScene.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLNode.h"
#include "vtkMRMLSavedFiles.h"
#include "vtkMRMLStorableNode.h"

#include <vtkCallbackCommand.h>
#include <vtkCollection.h>
#include <vtkObjectFactory.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <numeric>

vtkStandardNewMacro(vtkMRMLScene);

vtkMRMLScene::vtkMRMLScene()
{
  this->SetVersion("FaceToBone 0.1.0 0");
  // First of all observers of the deletion: they still see the nodes go.
  this->DeleteEventCallback->SetClientData(this);
  this->DeleteEventCallback->SetCallback([](vtkObject*, unsigned long, void* scene, void*)
                                         { static_cast<vtkMRMLScene*>(scene)->Clear(1); });
  this->AddObserver(vtkCommand::DeleteEvent, this->DeleteEventCallback, 1000.0F);
  this->RegisterOwnNodeClasses();
}

vtkMRMLScene::~vtkMRMLScene()
{
  this->ClearUndoStack();
  this->ClearRedoStack();
  delete[] this->Version;
  delete[] this->Extensions;
  delete[] this->LastLoadedVersion;
  delete[] this->LastLoadedExtensions;
}

void vtkMRMLScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "URL: " << this->URL << "\n";
  os << indent << "RootDirectory: " << this->RootDirectory << "\n";
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    const char* name = this->GetNthNode(n)->GetName();
    os << indent << this->GetNthNode(n)->GetID() << ": " << (name ? name : "(none)") << "\n";
  }
}

// --- States ------------------------------------------------------------------------------------

int vtkMRMLScene::GetStates() const
{
  return std::accumulate(this->States.begin(), this->States.end(), 0,
                         [](int all, unsigned long one) { return all | static_cast<int>(one); });
}

void vtkMRMLScene::StartState(unsigned long state, int anticipatedMaxProgress)
{
  const bool batch = this->IsBatchProcessing();
  const bool within = this->IsInState(static_cast<int>(state));
  this->States.push_back(state);
  if (!batch && this->IsBatchProcessing())
  {
    this->InvokeEvent(StartBatchProcessEvent);
  }
  if (state != BatchProcessState && !within)
  {
    this->InvokeEvent(StateEvent | StartEvent | state,
                      reinterpret_cast<void*>(static_cast<intptr_t>(anticipatedMaxProgress)));
  }
}

void vtkMRMLScene::EndState(unsigned long state)
{
  if (this->States.empty() || this->States.back() != state)
  {
    vtkErrorMacro("EndState: the state " << state << " is not the one that was started last");
    return;
  }
  this->States.pop_back();
  if ((state & SaveState) && !this->IsInState(SaveState))
  {
    // No scene file took them along.
    for (const std::string& path : this->StagedFiles)
    {
      vtkMRMLSavedFiles::Publish(path);
    }
    this->StagedFiles.clear();
  }
  if (state != BatchProcessState && !this->IsInState(static_cast<int>(state)))
  {
    this->InvokeEvent(StateEvent | EndEvent | state);
  }
  if ((state & BatchProcessState) && !this->IsBatchProcessing())
  {
    this->InvokeEvent(EndBatchProcessEvent);
  }
}

void vtkMRMLScene::ProgressState(unsigned long state, int progress)
{
  void* data = reinterpret_cast<void*>(static_cast<intptr_t>(progress));
  if (state & BatchProcessState)
  {
    this->InvokeEvent(ProgressBatchProcessEvent, data);
  }
  if (state != BatchProcessState)
  {
    this->InvokeEvent(StateEvent | ProgressEvent | state, data);
  }
}

// --- Adding and removing -----------------------------------------------------------------------

void vtkMRMLScene::Clear(int removeSingletons)
{
  const bool undo = this->GetUndoFlag();
  this->SetUndoOff();
  this->StartState(CloseState);
  std::vector<vtkWeakPointer<vtkMRMLNode>> nodes;
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    nodes.emplace_back(this->GetNthNode(n));
  }
  for (const auto& node : nodes)
  {
    // Removing one may have removed others.
    if (node && node->GetScene() == this && (removeSingletons || !node->IsSingleton()))
    {
      this->RemoveNode(node);
    }
  }
  this->NodeReferences.clear();
  this->ReferencedIDChanges.clear();
  this->KeptSceneAttributes.clear();
  this->HeldFiles.clear();
  this->ResetNodes();
  this->ClearUndoStack();
  this->ClearRedoStack();
  this->UniqueIDs.clear();
  this->UniqueNames.clear();
  this->Modified();
  this->SetUndoFlag(undo);
  this->EndState(CloseState);
}

void vtkMRMLScene::ResetNodes()
{
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    vtkMRMLNode* node = this->GetNthNode(n);
    node->Reset(this->GetDefaultNodeByClass(node->GetClassName()));
  }
}

vtkMRMLNode* vtkMRMLScene::AddNode(vtkMRMLNode* nodeToAdd)
{
  if (!nodeToAdd || !nodeToAdd->GetAddToScene())
  {
    return nullptr;
  }
  if (nodeToAdd->GetScene() == this && this->IsNodePresent(nodeToAdd))
  {
    vtkErrorMacro("AddNode: " << nodeToAdd->GetID() << " is in the scene already");
    return nodeToAdd;
  }
  const vtkSmartPointer<vtkMRMLNode> held = nodeToAdd;
  vtkMRMLNode* added = nodeToAdd->IsSingleton() ? this->GetSingletonNode(nodeToAdd) : nullptr;
  if (added)
  {
    this->OverwriteSingleton(added, nodeToAdd);
  }
  else
  {
    this->InvokeEvent(NodeAboutToBeAddedEvent, nodeToAdd);
    added = this->AddNodeNoNotify(nodeToAdd);
    this->InvokeEvent(NodeAddedEvent, nodeToAdd);
  }
  if (!this->IsImporting() && !this->IsRestoring())
  {
    added->UpdateNodeReferences();
  }
  this->Modified();
  return added;
}

vtkMRMLNode* vtkMRMLScene::OverwriteSingleton(vtkMRMLNode* existing, vtkMRMLNode* n)
{
  const std::string newID = existing->GetID();
  const std::string oldID = n->GetID() ? n->GetID() : newID;
  if ((this->IsImporting() || this->IsRestoring()) && oldID != newID)
  {
    this->ReferencedIDChanges[oldID] = newID;
  }
  existing->Copy(n);
  existing->SetSceneReferences();
  return existing;
}

vtkMRMLNode* vtkMRMLScene::AddNodeNoNotify(vtkMRMLNode* n)
{
  MRMLNodeModifyBlocker blocker(n);
  const std::string oldID = n->GetID() ? n->GetID() : "";
  if (oldID.empty() || this->GetNodeByID(oldID))
  {
    const std::string newID = this->GenerateUniqueID(n);
    n->SetID(newID.c_str());
    if ((this->IsImporting() || this->IsRestoring()) && !oldID.empty())
    {
      this->ReferencedIDChanges[oldID] = newID;
    }
  }
  if (!n->GetName() || !n->GetName()[0])
  {
    n->SetName(this->GenerateUniqueName(n->GetNodeTagName()).c_str());
  }
  if (n->GetScene() == this)
  {
    n->SetSceneReferences();
  }
  else
  {
    n->SetScene(this);
  }
  this->Nodes->AddItem(n);
  this->NodeIDs[n->GetID()] = n;
  return n;
}

vtkMRMLNode* vtkMRMLScene::AddNewNodeByClass(std::string className, std::string nodeBaseName)
{
  const auto node = vtkSmartPointer<vtkMRMLNode>::Take(this->CreateNodeByClass(className.c_str()));
  if (!node)
  {
    vtkErrorMacro("AddNewNodeByClass: unknown class '" << className << "'");
    return nullptr;
  }
  if (!nodeBaseName.empty())
  {
    node->SetName(nodeBaseName.c_str());
  }
  return this->AddNode(node);
}

vtkMRMLNode* vtkMRMLScene::AddNewNodeByClassWithID(std::string className, std::string nodeBaseName,
                                                   std::string nodeID)
{
  if (nodeID.empty() || this->GetNodeByID(nodeID) || this->IsReservedID(nodeID))
  {
    vtkErrorMacro("AddNewNodeByClassWithID: the id '" << nodeID << "' is not free");
    return nullptr;
  }
  const auto node = vtkSmartPointer<vtkMRMLNode>::Take(this->CreateNodeByClass(className.c_str()));
  if (!node)
  {
    vtkErrorMacro("AddNewNodeByClassWithID: unknown class '" << className << "'");
    return nullptr;
  }
  node->SetID(nodeID.c_str());
  if (!nodeBaseName.empty())
  {
    node->SetName(nodeBaseName.c_str());
  }
  return this->AddNode(node);
}

vtkMRMLNode* vtkMRMLScene::CopyNode(vtkMRMLNode* n)
{
  if (!n || !n->GetAddToScene())
  {
    return nullptr;
  }
  const auto node = vtkSmartPointer<vtkMRMLNode>::Take(n->CreateNodeInstance());
  node->Copy(n);
  return this->AddNode(node);
}

void vtkMRMLScene::RemoveNode(vtkMRMLNode* n)
{
  if (!n || n->GetScene() != this || !n->GetID())
  {
    return;
  }
  const vtkSmartPointer<vtkMRMLNode> held = n;
  const std::string id = n->GetID();
  this->InvokeEvent(NodeAboutToBeRemovedEvent, n);
  n->SetScene(nullptr);
  this->Nodes->RemoveItem(n);
  this->NodeIDs.erase(id);
  this->InvokeEvent(NodeRemovedEvent, n);
  if (!this->IsClosing())
  {
    this->RemoveNodeReferences(n);
    const std::set<std::string> referencing = this->NodeReferences[id];
    for (const std::string& referencingID : referencing)
    {
      if (vtkMRMLNode* node = this->GetNodeByID(referencingID))
      {
        node->UpdateReferences();
      }
    }
    this->RemoveReferencesToNode(n);
  }
  this->Modified();
}

int vtkMRMLScene::IsNodePresent(vtkMRMLNode* n)
{
  return n ? this->Nodes->IsItemPresent(n) : 0;
}

// --- Finding -----------------------------------------------------------------------------------

vtkCollection* vtkMRMLScene::GetNodes()
{
  return this->Nodes;
}

int vtkMRMLScene::GetNumberOfNodes()
{
  return this->Nodes->GetNumberOfItems();
}

vtkMRMLNode* vtkMRMLScene::GetNthNode(int n)
{
  return n < 0 || n >= this->GetNumberOfNodes()
             ? nullptr
             : static_cast<vtkMRMLNode*>(this->Nodes->GetItemAsObject(n));
}

vtkMRMLNode* vtkMRMLScene::GetNodeByID(const char* name)
{
  return name ? this->GetNodeByID(std::string(name)) : nullptr;
}

vtkMRMLNode* vtkMRMLScene::GetNodeByID(std::string name)
{
  const auto found = this->NodeIDs.find(name);
  return found == this->NodeIDs.end() ? nullptr : found->second;
}

int vtkMRMLScene::GetNodesByClass(const char* className, std::vector<vtkMRMLNode*>& nodes)
{
  vtkCollectionSimpleIterator iterator;
  this->Nodes->InitTraversal(iterator);
  while (auto* node = static_cast<vtkMRMLNode*>(this->Nodes->GetNextItemAsObject(iterator)))
  {
    if (!className || node->IsA(className))
    {
      nodes.push_back(node);
    }
  }
  return static_cast<int>(nodes.size());
}

vtkCollection* vtkMRMLScene::GetNodesByClass(const char* className)
{
  return this->GetNodesByClassByName(className, nullptr);
}

vtkCollection* vtkMRMLScene::GetNodesByClassByName(const char* className, const char* name)
{
  std::vector<vtkMRMLNode*> nodes;
  this->GetNodesByClass(className, nodes);
  vtkCollection* found = vtkCollection::New();
  for (vtkMRMLNode* node : nodes)
  {
    if (!name || (node->GetName() && std::string(node->GetName()) == name))
    {
      found->AddItem(node);
    }
  }
  return found;
}

vtkCollection* vtkMRMLScene::GetNodesByName(const char* name)
{
  return this->GetNodesByClassByName(nullptr, name ? name : "");
}

vtkMRMLNode* vtkMRMLScene::GetNthNodeByClass(int n, const char* className)
{
  std::vector<vtkMRMLNode*> nodes;
  this->GetNodesByClass(className, nodes);
  return n < 0 || n >= static_cast<int>(nodes.size()) ? nullptr : nodes[n];
}

vtkMRMLNode* vtkMRMLScene::GetFirstNodeByClass(const char* className)
{
  return this->GetFirstNode(nullptr, className);
}

int vtkMRMLScene::GetNumberOfNodesByClass(const char* className)
{
  std::vector<vtkMRMLNode*> nodes;
  return this->GetNodesByClass(className, nodes);
}

vtkMRMLNode* vtkMRMLScene::GetFirstNodeByName(const char* name)
{
  return name ? this->GetFirstNode(name) : nullptr;
}

vtkMRMLNode* vtkMRMLScene::GetFirstNode(const char* byName, const char* byClass,
                                        const int* byHideFromEditors, bool exactNameMatch)
{
  vtkCollectionSimpleIterator iterator;
  this->Nodes->InitTraversal(iterator);
  while (auto* node = static_cast<vtkMRMLNode*>(this->Nodes->GetNextItemAsObject(iterator)))
  {
    const std::string name = node->GetName() ? node->GetName() : "";
    const bool named = !byName || (exactNameMatch ? name == byName : name.rfind(byName, 0) == 0);
    if (named && (!byClass || node->IsA(byClass)) &&
        (!byHideFromEditors || node->GetHideFromEditors() == *byHideFromEditors))
    {
      return node;
    }
  }
  return nullptr;
}

std::list<std::string> vtkMRMLScene::GetNodeClassesList()
{
  std::list<std::string> classes;
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    classes.emplace_back(this->GetNthNode(n)->GetClassName());
  }
  classes.sort();
  classes.unique();
  return classes;
}

vtkMRMLNode* vtkMRMLScene::GetSingletonNode(const char* singletonTag, const char* className)
{
  std::vector<vtkMRMLNode*> nodes;
  this->GetNodesByClass(className, nodes);
  for (vtkMRMLNode* node : nodes)
  {
    if (singletonTag && node->GetSingletonTag() &&
        std::string(singletonTag) == node->GetSingletonTag())
    {
      return node;
    }
  }
  return nullptr;
}

vtkMRMLNode* vtkMRMLScene::GetSingletonNode(vtkMRMLNode* n)
{
  if (!n || !n->IsSingleton())
  {
    return nullptr;
  }
  for (int i = 0; i < this->GetNumberOfNodes(); ++i)
  {
    vtkMRMLNode* node = this->GetNthNode(i);
    if (node->GetSingletonTag() && std::string(node->GetSingletonTag()) == n->GetSingletonTag() &&
        node->IsA(n->GetClassName()) && std::string(node->GetNodeTagName()) == n->GetNodeTagName())
    {
      return node;
    }
  }
  return nullptr;
}

// --- Ids and names -----------------------------------------------------------------------------

std::string vtkMRMLScene::GenerateUniqueID(vtkMRMLNode* node)
{
  std::string base = node->GetClassName();
  if (base == "vtkMRMLUnknownNode")
  {
    base = std::string("vtkMRML") + node->GetNodeTagName() +
           (vtksys::SystemTools::StringEndsWith(node->GetNodeTagName(), "Node") ? "" : "Node");
  }
  if (node->IsSingleton() && !this->GetNodeByID(base + node->GetSingletonTag()))
  {
    return base + node->GetSingletonTag();
  }
  int& last = this->UniqueIDs[base];
  std::string id;
  do
  {
    id = base + std::to_string(++last);
  } while (this->GetNodeByID(id) || this->IsReservedID(id));
  return id;
}

std::string vtkMRMLScene::GenerateUniqueName(const std::string& baseName)
{
  const auto found = this->UniqueNames.find(baseName);
  int index = found == this->UniqueNames.end() ? 0 : found->second + 1;
  const auto name = [&baseName](int i)
  { return i == 0 ? baseName : baseName + "_" + std::to_string(i); };
  while (this->GetFirstNodeByName(name(index).c_str()))
  {
    ++index;
  }
  this->UniqueNames[baseName] = index;
  return name(index);
}

const char* vtkMRMLScene::GetUniqueNameByString(const char* baseName)
{
  this->UniqueName = this->GenerateUniqueName(baseName ? baseName : "Node");
  return this->UniqueName.c_str();
}

bool vtkMRMLScene::IsReservedID(const std::string& id)
{
  return this->ReservedIDs.count(id) > 0;
}

void vtkMRMLScene::AddReservedID(const char* id)
{
  if (id)
  {
    this->ReservedIDs.insert(id);
  }
}

void vtkMRMLScene::RemoveReservedIDs()
{
  this->ReservedIDs.clear();
}
