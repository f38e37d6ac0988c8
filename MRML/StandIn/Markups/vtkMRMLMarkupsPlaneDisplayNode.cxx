#include "vtkMRMLMarkupsPlaneDisplayNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsPlaneDisplayNode);

vtkMRMLMarkupsPlaneDisplayNode::vtkMRMLMarkupsPlaneDisplayNode()
{
  this->SetHandlesInteractive(true);
}
