#include "vtkMRMLStorableNode.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLScene.h"
#include "vtkMRMLStorageNode.h"

vtkMRMLStorableNode::vtkMRMLStorableNode()
{
  this->AddNodeReferenceRole("storage", "storageNodeRef");
}

void vtkMRMLStorableNode::CopyContent(vtkMRMLNode* node, bool deepCopy)
{
  this->Superclass::CopyContent(node, deepCopy);
}

void vtkMRMLStorableNode::UpdateScene(vtkMRMLScene* scene)
{
  this->Superclass::UpdateScene(scene);
  if (!this->GetAddToScene() || !scene || !scene->GetReadDataOnLoad())
  {
    return;
  }
  for (int n = 0; n < this->GetNumberOfStorageNodes(); ++n)
  {
    vtkMRMLStorageNode* storage = this->GetNthStorageNode(n);
    const std::string name = this->GetName() ? this->GetName() : "";
    if (!storage)
    {
      vtkWarningMacro("The data of '" << name << "' are not read: nothing here knows the class of "
                                      << this->GetNthStorageNodeID(n));
      continue;
    }
    // A storage node without a file stands for data that have never been saved.
    if (!storage->GetFileName() && storage->GetNumberOfFileNames() == 0)
    {
      continue;
    }
    storage->GetUserMessages()->ClearMessages();
    if (storage->ReadData(this) == 0)
    {
      vtkErrorMacro("The data of '" << name << "' could not be read: "
                                    << storage->GetUserMessages()->GetAllMessagesAsString());
    }
  }
}

void vtkMRMLStorableNode::SetAndObserveStorageNodeID(const char* storageNodeID)
{
  this->SetAndObserveNodeReferenceID(this->GetStorageNodeReferenceRole(), storageNodeID);
}

void vtkMRMLStorableNode::AddAndObserveStorageNodeID(const char* storageNodeID)
{
  this->AddAndObserveNodeReferenceID(this->GetStorageNodeReferenceRole(), storageNodeID);
}

void vtkMRMLStorableNode::SetAndObserveNthStorageNodeID(int n, const char* storageNodeID)
{
  this->SetAndObserveNthNodeReferenceID(this->GetStorageNodeReferenceRole(), n, storageNodeID);
}

bool vtkMRMLStorableNode::HasStorageNodeID(const char* storageNodeID)
{
  return this->HasNodeReferenceID(this->GetStorageNodeReferenceRole(), storageNodeID);
}

int vtkMRMLStorableNode::GetNumberOfStorageNodes()
{
  return this->GetNumberOfNodeReferences(this->GetStorageNodeReferenceRole());
}

const char* vtkMRMLStorableNode::GetNthStorageNodeID(int n)
{
  return this->GetNthNodeReferenceID(this->GetStorageNodeReferenceRole(), n);
}

const char* vtkMRMLStorableNode::GetStorageNodeID()
{
  return this->GetNthStorageNodeID(0);
}

vtkMRMLStorageNode* vtkMRMLStorableNode::GetNthStorageNode(int n)
{
  return vtkMRMLStorageNode::SafeDownCast(
      this->GetNthNodeReference(this->GetStorageNodeReferenceRole(), n));
}

vtkMRMLStorageNode* vtkMRMLStorableNode::GetStorageNode()
{
  return this->GetNthStorageNode(0);
}

vtkMRMLStorageNode* vtkMRMLStorableNode::CreateDefaultStorageNode()
{
  return nullptr;
}

std::string vtkMRMLStorableNode::GetDefaultStorageNodeClassName(const char*)
{
  const auto storage = vtkSmartPointer<vtkMRMLStorageNode>::Take(this->CreateDefaultStorageNode());
  return storage ? storage->GetClassName() : "";
}

bool vtkMRMLStorableNode::AddDefaultStorageNode(const char* filename)
{
  if (this->GetStorageNode())
  {
    return true;
  }
  const std::string className = this->GetDefaultStorageNodeClassName(filename);
  if (!this->GetScene() || className.empty())
  {
    return className.empty();
  }
  auto* storage = vtkMRMLStorageNode::SafeDownCast(this->GetScene()->AddNewNodeByClass(className));
  if (!storage)
  {
    return false;
  }
  if (filename)
  {
    storage->SetFileName(filename);
  }
  this->SetAndObserveStorageNodeID(storage->GetID());
  return true;
}

vtkTimeStamp vtkMRMLStorableNode::GetStoredTime()
{
  vtkTimeStamp newest;
  for (int n = 0; n < this->GetNumberOfStorageNodes(); ++n)
  {
    vtkMRMLStorageNode* storage = this->GetNthStorageNode(n);
    if (storage && storage->GetStoredTime() > newest)
    {
      newest = storage->GetStoredTime();
    }
  }
  return newest;
}

bool vtkMRMLStorableNode::GetModifiedSinceRead()
{
  return this->StorableModifiedTime > this->GetStoredTime();
}

void vtkMRMLStorableNode::StorableModified()
{
  this->StorableModifiedTime.Modified();
}
