#include "vtkMRMLMarkupsClosedCurveNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsClosedCurveNode);

vtkMRMLMarkupsClosedCurveNode::vtkMRMLMarkupsClosedCurveNode()
{
  this->CurveClosed = true;
}
