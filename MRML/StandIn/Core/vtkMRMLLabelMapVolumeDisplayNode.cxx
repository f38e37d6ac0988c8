#include "vtkMRMLLabelMapVolumeDisplayNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLLabelMapVolumeDisplayNode);

void vtkMRMLLabelMapVolumeDisplayNode::SetDefaultColorMap()
{
  this->SetAndObserveColorNodeID("vtkMRMLColorTableNodeLabels");
}
