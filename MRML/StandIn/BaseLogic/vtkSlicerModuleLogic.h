#pragma once

#include "vtkMRMLAbstractLogic.h"
#include "vtkSlicerBaseLogicExport.h"

#include <string>

class vtkSlicerApplicationLogic;

/// What a module's logic derives from.
class VTK_SLICER_BASE_LOGIC_EXPORT vtkSlicerModuleLogic : public vtkMRMLAbstractLogic
{
public:
  static vtkSlicerModuleLogic* New();
  vtkTypeMacro(vtkSlicerModuleLogic, vtkMRMLAbstractLogic);
  virtual vtkSlicerApplicationLogic* GetApplicationLogic();
  virtual vtkMRMLAbstractLogic* GetModuleLogic(const char* moduleName);
  /// Folder of the module's resources.
  std::string GetModuleShareDirectory() const { return this->ModuleShareDirectory; }
  void SetModuleShareDirectory(const std::string& shareDirectory);

protected:
  vtkSlicerModuleLogic() = default;
  ~vtkSlicerModuleLogic() override = default;
  vtkSlicerModuleLogic(const vtkSlicerModuleLogic&) = delete;
  void operator=(const vtkSlicerModuleLogic&) = delete;

private:
  std::string ModuleShareDirectory;
};
