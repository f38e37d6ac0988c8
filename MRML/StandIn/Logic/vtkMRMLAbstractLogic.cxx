#include "vtkMRMLAbstractLogic.h"

#include "vtkMRMLApplicationLogic.h"
#include "vtkMRMLScene.h"

#include "vtkMRMLNode.h"

#include <vtkCallbackCommand.h>
#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkWeakPointer.h>

vtkStandardNewMacro(vtkMRMLAbstractLogic);

struct vtkMRMLAbstractLogic::vtkInternal
{
  vtkMRMLScene* Scene = nullptr; ///< counted by SceneObserverManager
  vtkWeakPointer<vtkMRMLApplicationLogic> ApplicationLogic;
  vtkNew<vtkObserverManager> SceneObserverManager;
  vtkNew<vtkObserverManager> NodesObserverManager;
};

vtkMRMLAbstractLogic::vtkMRMLAbstractLogic() : Internal(new vtkInternal)
{
  this->Internal->SceneObserverManager->AssignOwner(this);
  vtkCallbackCommand* scene = this->Internal->SceneObserverManager->GetCallbackCommand();
  scene->SetClientData(this);
  scene->SetCallback(
      [](vtkObject* caller, unsigned long event, void* self, void* data)
      { static_cast<vtkMRMLAbstractLogic*>(self)->ProcessMRMLSceneEvents(caller, event, data); });

  this->Internal->NodesObserverManager->AssignOwner(this);
  vtkCallbackCommand* nodes = this->Internal->NodesObserverManager->GetCallbackCommand();
  nodes->SetClientData(this);
  nodes->SetCallback(
      [](vtkObject* caller, unsigned long event, void* self, void* data)
      {
        if (vtkMRMLNode::SafeDownCast(caller))
        {
          static_cast<vtkMRMLAbstractLogic*>(self)->ProcessMRMLNodesEvents(caller, event, data);
        }
      });
}

vtkMRMLAbstractLogic::~vtkMRMLAbstractLogic()
{
  this->SetMRMLScene(nullptr);
}

void vtkMRMLAbstractLogic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MRMLScene: " << this->Internal->Scene << "\n";
}

vtkMRMLApplicationLogic* vtkMRMLAbstractLogic::GetMRMLApplicationLogic() const
{
  return this->Internal->ApplicationLogic;
}

void vtkMRMLAbstractLogic::SetMRMLApplicationLogic(vtkMRMLApplicationLogic* logic)
{
  if (this->Internal->ApplicationLogic != logic)
  {
    this->Internal->ApplicationLogic = logic;
    this->Modified();
  }
}

vtkObserverManager* vtkMRMLAbstractLogic::GetMRMLSceneObserverManager() const
{
  return this->Internal->SceneObserverManager;
}

vtkObserverManager* vtkMRMLAbstractLogic::GetMRMLNodesObserverManager() const
{
  return this->Internal->NodesObserverManager;
}

vtkMRMLScene* vtkMRMLAbstractLogic::GetMRMLScene() const
{
  return this->Internal->Scene;
}

void vtkMRMLAbstractLogic::SetMRMLScene(vtkMRMLScene* newScene)
{
  if (this->Internal->Scene == newScene)
  {
    return;
  }
  if (this->Internal->Scene)
  {
    this->UnobserveMRMLScene();
  }
  this->SetMRMLSceneInternal(newScene);
  if (newScene)
  {
    this->RegisterNodes();
    this->ObserveMRMLScene();
  }
  this->Modified();
}

void vtkMRMLAbstractLogic::SetMRMLSceneInternal(vtkMRMLScene* newScene)
{
  this->GetMRMLSceneObserverManager()->SetObject(vtkObjectPointer(&this->Internal->Scene),
                                                 newScene);
}

void vtkMRMLAbstractLogic::SetAndObserveMRMLSceneInternal(vtkMRMLScene* newScene)
{
  this->GetMRMLSceneObserverManager()->SetAndObserveObject(vtkObjectPointer(&this->Internal->Scene),
                                                           newScene);
}

void vtkMRMLAbstractLogic::SetAndObserveMRMLSceneEventsInternal(vtkMRMLScene* newScene,
                                                                vtkIntArray* events,
                                                                vtkFloatArray* priorities)
{
  this->GetMRMLSceneObserverManager()->SetAndObserveObjectEvents(
      vtkObjectPointer(&this->Internal->Scene), newScene, events, priorities);
}

void vtkMRMLAbstractLogic::ProcessMRMLSceneEvents(vtkObject*, unsigned long event, void* callData)
{
  auto* node = static_cast<vtkMRMLNode*>(callData);
  switch (event)
  {
  case vtkMRMLScene::StartBatchProcessEvent:
    return this->OnMRMLSceneStartBatchProcess();
  case vtkMRMLScene::EndBatchProcessEvent:
    return this->OnMRMLSceneEndBatchProcess();
  case vtkMRMLScene::StartCloseEvent:
    return this->OnMRMLSceneStartClose();
  case vtkMRMLScene::EndCloseEvent:
    return this->OnMRMLSceneEndClose();
  case vtkMRMLScene::StartImportEvent:
    return this->OnMRMLSceneStartImport();
  case vtkMRMLScene::EndImportEvent:
    return this->OnMRMLSceneEndImport();
  case vtkMRMLScene::StartRestoreEvent:
    return this->OnMRMLSceneStartRestore();
  case vtkMRMLScene::EndRestoreEvent:
    return this->OnMRMLSceneEndRestore();
  case vtkMRMLScene::NewSceneEvent:
    return this->OnMRMLSceneNew();
  case vtkMRMLScene::NodeAddedEvent:
    return this->OnMRMLSceneNodeAdded(node);
  case vtkMRMLScene::NodeRemovedEvent:
    return this->OnMRMLSceneNodeRemoved(node);
  default:
    return;
  }
}

void vtkMRMLAbstractLogic::ProcessMRMLNodesEvents(vtkObject* caller, unsigned long event, void*)
{
  if (event == vtkCommand::ModifiedEvent)
  {
    this->OnMRMLNodeModified(vtkMRMLNode::SafeDownCast(caller));
  }
}
