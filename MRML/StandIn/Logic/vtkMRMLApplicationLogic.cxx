#include "vtkMRMLApplicationLogic.h"

#include "vtkMRMLNode.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkMRMLApplicationLogic);

void vtkMRMLApplicationLogic::InvokeEventWithDelay(unsigned int delayInMs, vtkObject* caller,
                                                   unsigned long eventID, void* callData)
{
  InvokeRequest request{delayInMs, caller, eventID, callData};
  this->InvokeEvent(RequestInvokeEvent, &request);
}

void vtkMRMLApplicationLogic::PauseRender()
{
  this->InvokeEvent(PauseRenderEvent);
}

void vtkMRMLApplicationLogic::ResumeRender()
{
  this->InvokeEvent(ResumeRenderEvent);
}

void vtkMRMLApplicationLogic::EditNode(vtkMRMLNode* node)
{
  this->InvokeEvent(EditNodeEvent, node);
}

void vtkMRMLApplicationLogic::SetModuleLogic(const char* moduleName,
                                             vtkMRMLAbstractLogic* moduleLogic)
{
  if (!moduleName)
  {
    return;
  }
  if (moduleLogic)
  {
    this->ModuleLogics[moduleName] = moduleLogic;
  }
  else
  {
    this->ModuleLogics.erase(moduleName);
  }
}

vtkMRMLAbstractLogic* vtkMRMLApplicationLogic::GetModuleLogic(const char* moduleName) const
{
  const auto found = this->ModuleLogics.find(moduleName ? moduleName : "");
  return found == this->ModuleLogics.end() ? nullptr : found->second;
}
