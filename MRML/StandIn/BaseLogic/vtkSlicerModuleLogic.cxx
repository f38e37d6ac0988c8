#include "vtkSlicerModuleLogic.h"

#include "vtkSlicerApplicationLogic.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkSlicerModuleLogic);

vtkSlicerApplicationLogic* vtkSlicerModuleLogic::GetApplicationLogic()
{
  return vtkSlicerApplicationLogic::SafeDownCast(this->GetMRMLApplicationLogic());
}

vtkMRMLAbstractLogic* vtkSlicerModuleLogic::GetModuleLogic(const char* moduleName)
{
  return this->GetMRMLApplicationLogic()
             ? this->GetMRMLApplicationLogic()->GetModuleLogic(moduleName)
             : nullptr;
}

void vtkSlicerModuleLogic::SetModuleShareDirectory(const std::string& shareDirectory)
{
  if (this->ModuleShareDirectory != shareDirectory)
  {
    this->ModuleShareDirectory = shareDirectory;
    this->Modified();
  }
}
