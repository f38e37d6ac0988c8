#include "vtkMRMLVolumeDisplayNode.h"

#include "vtkMRMLVolumeNode.h"

void vtkMRMLVolumeDisplayNode::CopyContent(vtkMRMLNode* node, bool deepCopy)
{
  this->Superclass::CopyContent(node, deepCopy);
}

vtkMRMLVolumeNode* vtkMRMLVolumeDisplayNode::GetVolumeNode()
{
  return vtkMRMLVolumeNode::SafeDownCast(this->GetDisplayableNode());
}
