#pragma once

#include "vtkMRMLNode.h"

#include <vtkTimeStamp.h>

class vtkMRMLStorageNode;

/// A node whose data lie in a file, through a storage node.
class VTK_MRML_EXPORT vtkMRMLStorableNode : public vtkMRMLNode
{
  friend class vtkMRMLScene;

public:
  vtkTypeMacro(vtkMRMLStorableNode, vtkMRMLNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  vtkMRMLCopyContentMacro(vtkMRMLStorableNode);
  /// Reads the data.
  void UpdateScene(vtkMRMLScene* scene) override;

  void SetAndObserveStorageNodeID(const char* storageNodeID);
  void AddAndObserveStorageNodeID(const char* storageNodeID);
  void SetAndObserveNthStorageNodeID(int n, const char* storageNodeID);
  bool HasStorageNodeID(const char* storageNodeID);
  int GetNumberOfStorageNodes();
  const char* GetNthStorageNodeID(int n);
  const char* GetStorageNodeID();
  vtkMRMLStorageNode* GetNthStorageNode(int n);
  vtkMRMLStorageNode* GetStorageNode();

  /// A new storage node of the node's default class, not in the scene; for the caller to delete.
  virtual vtkMRMLStorageNode* CreateDefaultStorageNode();
  virtual std::string GetDefaultStorageNodeClassName(const char* filename = nullptr);
  /// Adds the default storage node to the scene where the node has none.
  virtual bool AddDefaultStorageNode(const char* filename = nullptr);

  /// Whether the data differ from what was last read or written.
  virtual bool GetModifiedSinceRead();
  virtual void StorableModified();

protected:
  vtkMRMLStorableNode();
  ~vtkMRMLStorableNode() override = default;
  vtkMRMLStorableNode(const vtkMRMLStorableNode&) = delete;
  void operator=(const vtkMRMLStorableNode&) = delete;

  virtual const char* GetStorageNodeReferenceRole() { return "storage"; }
  virtual const char* GetStorageNodeReferenceMRMLAttributeName() { return "storageNodeRef"; }
  virtual vtkTimeStamp GetStoredTime();

  vtkTimeStamp StorableModifiedTime;
};
