#pragma once

#include "vtkMRMLLogicExport.h"
#include "vtkObserverManager.h"

#include <vtkObject.h>

#include <memory>

class vtkFloatArray;
class vtkIntArray;
class vtkMRMLApplicationLogic;
class vtkMRMLNode;
class vtkMRMLScene;

#ifndef vtkSetMRMLNodeMacro
#define vtkSetMRMLNodeMacro(node, value)                                                           \
  {                                                                                                \
    const vtkObject* nodeBefore = (node);                                                          \
    this->GetMRMLNodesObserverManager()->SetObject(vtkObjectPointer(&(node)), (value));            \
    if (nodeBefore != (node))                                                                      \
    {                                                                                              \
      this->Modified();                                                                            \
    }                                                                                              \
  };
#endif

#ifndef vtkSetAndObserveMRMLNodeMacro
#define vtkSetAndObserveMRMLNodeMacro(node, value)                                                 \
  {                                                                                                \
    const vtkObject* nodeBefore = (node);                                                          \
    this->GetMRMLNodesObserverManager()->SetAndObserveObject(vtkObjectPointer(&(node)), (value));  \
    if (nodeBefore != (node))                                                                      \
    {                                                                                              \
      this->Modified();                                                                            \
    }                                                                                              \
  };
#endif

#ifndef vtkSetAndObserveMRMLNodeEventsMacro
#define vtkSetAndObserveMRMLNodeEventsMacro(node, value, events)                                   \
  {                                                                                                \
    const vtkObject* nodeBefore = (node);                                                          \
    this->GetMRMLNodesObserverManager()->SetAndObserveObjectEvents(vtkObjectPointer(&(node)),      \
                                                                   (value), (events));             \
    if (nodeBefore != (node))                                                                      \
    {                                                                                              \
      this->Modified();                                                                            \
    }                                                                                              \
  };
#endif

#ifndef vtkObserveMRMLNodeMacro
#define vtkObserveMRMLNodeMacro(node)                                                              \
  {                                                                                                \
    this->GetMRMLNodesObserverManager()->ObserveObject((node));                                    \
  };
#endif

#ifndef vtkObserveMRMLNodeEventsMacro
#define vtkObserveMRMLNodeEventsMacro(node, events)                                                \
  {                                                                                                \
    this->GetMRMLNodesObserverManager()->AddObjectEvents((node), (events));                        \
  };
#endif

#ifndef vtkUnObserveMRMLNodeMacro
#define vtkUnObserveMRMLNodeMacro(node)                                                            \
  {                                                                                                \
    this->GetMRMLNodesObserverManager()->RemoveObjectEvents((node));                               \
  };
#endif

/// What follows a scene and does things with its nodes: override the On... methods.
class VTK_MRML_LOGIC_EXPORT vtkMRMLAbstractLogic : public vtkObject
{
public:
  static vtkMRMLAbstractLogic* New();
  vtkTypeMacro(vtkMRMLAbstractLogic, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  virtual vtkMRMLApplicationLogic* GetMRMLApplicationLogic() const;
  virtual void SetMRMLApplicationLogic(vtkMRMLApplicationLogic* logic);
  vtkMRMLScene* GetMRMLScene() const;
  /// Calls SetMRMLSceneInternal, RegisterNodes and UpdateFromMRMLScene.
  void SetMRMLScene(vtkMRMLScene* newScene);

protected:
  vtkMRMLAbstractLogic();
  ~vtkMRMLAbstractLogic() override;
  vtkMRMLAbstractLogic(const vtkMRMLAbstractLogic&) = delete;
  void operator=(const vtkMRMLAbstractLogic&) = delete;

  virtual void ProcessMRMLSceneEvents(vtkObject* caller, unsigned long event, void* callData);
  virtual void ProcessMRMLNodesEvents(vtkObject* caller, unsigned long event, void* callData);
  vtkObserverManager* GetMRMLSceneObserverManager() const;
  vtkObserverManager* GetMRMLNodesObserverManager() const;

  /// Sets the scene; override to observe more of its events (SetAndObserveMRMLSceneEventsInternal).
  virtual void SetMRMLSceneInternal(vtkMRMLScene* newScene);
  void SetAndObserveMRMLSceneInternal(vtkMRMLScene* newScene);
  void SetAndObserveMRMLSceneEventsInternal(vtkMRMLScene* newScene, vtkIntArray* events,
                                            vtkFloatArray* priorities = nullptr);
  virtual void RegisterNodes() {}
  virtual void UnobserveMRMLScene() {}
  virtual void ObserveMRMLScene() { this->UpdateFromMRMLScene(); }
  virtual void UpdateFromMRMLScene() {}

  virtual void OnMRMLSceneStartBatchProcess() {}
  virtual void OnMRMLSceneEndBatchProcess() { this->UpdateFromMRMLScene(); }
  virtual void OnMRMLSceneStartClose() {}
  virtual void OnMRMLSceneEndClose() {}
  virtual void OnMRMLSceneStartImport() {}
  virtual void OnMRMLSceneEndImport() {}
  virtual void OnMRMLSceneStartRestore() {}
  virtual void OnMRMLSceneEndRestore() {}
  virtual void OnMRMLSceneNew() {}
  virtual void OnMRMLSceneNodeAdded(vtkMRMLNode*) {}
  virtual void OnMRMLSceneNodeRemoved(vtkMRMLNode*) {}
  virtual void OnMRMLNodeModified(vtkMRMLNode*) {}

private:
  struct vtkInternal;
  std::unique_ptr<vtkInternal> Internal;
};
