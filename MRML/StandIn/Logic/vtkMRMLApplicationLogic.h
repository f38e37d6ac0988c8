#pragma once

#include "vtkMRMLAbstractLogic.h"

#include <vtkCommand.h>

#include <map>
#include <string>

/// The application's own logic: knows the modules' logics, and tells when rendering should wait.
class VTK_MRML_LOGIC_EXPORT vtkMRMLApplicationLogic : public vtkMRMLAbstractLogic
{
public:
  static vtkMRMLApplicationLogic* New();
  vtkTypeMacro(vtkMRMLApplicationLogic, vtkMRMLAbstractLogic);

  enum Events
  {
    RequestInvokeEvent = vtkCommand::UserEvent + 1,
    PauseRenderEvent = vtkCommand::UserEvent + 101,
    ResumeRenderEvent,
    EditNodeEvent,
    ShowViewContextMenuEvent,
  };
  /// What RequestInvokeEvent asks the host's event loop for: this event, after this delay [ms].
  struct InvokeRequest
  {
    unsigned int Delay = 100;
    vtkObject* Caller = nullptr;
    unsigned long EventID = vtkCommand::ModifiedEvent;
    void* CallData = nullptr;
  };
  void InvokeEventWithDelay(unsigned int delayInMs, vtkObject* caller,
                            unsigned long eventID = vtkCommand::ModifiedEvent,
                            void* callData = nullptr);
  virtual void PauseRender();
  virtual void ResumeRender();
  virtual void EditNode(vtkMRMLNode* node);
  void SetModuleLogic(const char* moduleName, vtkMRMLAbstractLogic* moduleLogic);
  vtkMRMLAbstractLogic* GetModuleLogic(const char* moduleName) const;
  const char* GetTemporaryPath() { return this->TemporaryPath.c_str(); }
  void SetTemporaryPath(const char* path) { this->TemporaryPath = path ? path : ""; }

protected:
  vtkMRMLApplicationLogic() = default;
  ~vtkMRMLApplicationLogic() override = default;
  vtkMRMLApplicationLogic(const vtkMRMLApplicationLogic&) = delete;
  void operator=(const vtkMRMLApplicationLogic&) = delete;

private:
  std::map<std::string, vtkMRMLAbstractLogic*> ModuleLogics; ///< not counted
  std::string TemporaryPath;
};
