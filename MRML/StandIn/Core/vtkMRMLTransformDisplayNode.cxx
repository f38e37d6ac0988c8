#include "vtkMRMLTransformDisplayNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLTransformDisplayNode);

vtkMRMLTransformDisplayNode::vtkMRMLTransformDisplayNode()
{
  this->Visibility = 0;
  this->ScalarVisibility = 1;
}
