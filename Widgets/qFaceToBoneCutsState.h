#ifndef qFaceToBoneCutsState_h
#define qFaceToBoneCutsState_h

#include "qFaceToBoneCut.h"
#include "qFaceToBoneCuts.h"

#include <vtkPolyData.h>

/// All that one step of undo brings back. For the cuts' own sources only.
struct qFaceToBoneCuts::State
{
  std::vector<qFaceToBoneCut> cuts;
  std::vector<qFaceToBoneSpared> spared;
  int current = -1;
};

/// What is to be spared, read once.
struct qFaceToBoneCuts::Structure
{
  std::vector<f2b::Vec3> points; ///< close together
  vtkSmartPointer<vtkPolyData> surface;
};

#endif
