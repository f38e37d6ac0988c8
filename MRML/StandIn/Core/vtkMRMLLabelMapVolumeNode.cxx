#include "vtkMRMLLabelMapVolumeNode.h"

#include "vtkMRMLLabelMapVolumeDisplayNode.h"
#include "vtkMRMLScene.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLLabelMapVolumeNode);

void vtkMRMLLabelMapVolumeNode::CreateDefaultDisplayNodes()
{
  if (!this->GetDisplayNode() && this->GetScene())
  {
    vtkMRMLNode* display = this->GetScene()->AddNewNodeByClass("vtkMRMLLabelMapVolumeDisplayNode");
    static_cast<vtkMRMLLabelMapVolumeDisplayNode*>(display)->SetDefaultColorMap();
    this->SetAndObserveDisplayNodeID(display->GetID());
  }
}
