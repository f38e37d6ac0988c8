#pragma once

#include "vtkSlicerBaseLogicExport.h"
