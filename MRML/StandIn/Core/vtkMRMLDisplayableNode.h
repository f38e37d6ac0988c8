#pragma once

#include "vtkMRMLTransformableNode.h"

class vtkMRMLDisplayNode;

/// A node that is seen, as its display nodes say.
class VTK_MRML_EXPORT vtkMRMLDisplayableNode : public vtkMRMLTransformableNode
{
public:
  vtkTypeMacro(vtkMRMLDisplayableNode, vtkMRMLTransformableNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  void ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData) override;

  void SetAndObserveDisplayNodeID(const char* displayNodeID);
  void AddAndObserveDisplayNodeID(const char* displayNodeID);
  void SetAndObserveNthDisplayNodeID(int n, const char* displayNodeID);
  void RemoveNthDisplayNodeID(int n);
  void RemoveAllDisplayNodeIDs();
  bool HasDisplayNodeID(const char* displayNodeID);
  int GetNumberOfDisplayNodes();
  const char* GetNthDisplayNodeID(int n);
  const char* GetDisplayNodeID();
  vtkMRMLDisplayNode* GetNthDisplayNode(int n);
  vtkMRMLDisplayNode* GetDisplayNode();
  virtual const char* GetDisplayNodeReferenceRole() { return "display"; }
  /// Adds a display node to the scene where there is none.
  virtual void CreateDefaultDisplayNodes() {}

  enum
  {
    DisplayModifiedEvent = 17000,
  };

  /// 0 hidden, 1 seen, 2 where the display nodes differ.
  virtual int GetDisplayVisibility();
  virtual void SetDisplayVisibility(int visible);
  /// World bounds, and bounds in the node's own frame [mm]; uninitialised bounds (1, -1, ...) if empty.
  virtual void GetRASBounds(double bounds[6]);
  virtual void GetBounds(double bounds[6]);

protected:
  vtkMRMLDisplayableNode();
  ~vtkMRMLDisplayableNode() override = default;
  vtkMRMLDisplayableNode(const vtkMRMLDisplayableNode&) = delete;
  void operator=(const vtkMRMLDisplayableNode&) = delete;

  virtual const char* GetDisplayNodeReferenceMRMLAttributeName() { return "displayNodeRef"; }
  void OnNodeReferenceAdded(vtkMRMLNodeReference* reference) override;
  void OnNodeReferenceModified(vtkMRMLNodeReference* reference) override;
  void OnNodeReferenceRemoved(vtkMRMLNodeReference* reference) override;

private:
  void NoticeDisplay(vtkMRMLNodeReference* reference);
};
