#include "vtkSlicerApplicationLogic.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkSlicerApplicationLogic);
