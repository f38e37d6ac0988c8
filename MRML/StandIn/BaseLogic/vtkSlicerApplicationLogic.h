#pragma once

#include "vtkMRMLApplicationLogic.h"
#include "vtkSlicerBaseLogicExport.h"

/// The application logic as modules see it.
class VTK_SLICER_BASE_LOGIC_EXPORT vtkSlicerApplicationLogic : public vtkMRMLApplicationLogic
{
public:
  static vtkSlicerApplicationLogic* New();
  vtkTypeMacro(vtkSlicerApplicationLogic, vtkMRMLApplicationLogic);

protected:
  vtkSlicerApplicationLogic() = default;
  ~vtkSlicerApplicationLogic() override = default;
  vtkSlicerApplicationLogic(const vtkSlicerApplicationLogic&) = delete;
  void operator=(const vtkSlicerApplicationLogic&) = delete;
};
