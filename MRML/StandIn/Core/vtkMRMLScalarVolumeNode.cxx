#include "vtkMRMLScalarVolumeNode.h"

#include "vtkMRMLScalarVolumeDisplayNode.h"
#include "vtkMRMLScene.h"
#include "vtkMRMLVolumeArchetypeStorageNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLScalarVolumeNode);

vtkMRMLScalarVolumeDisplayNode* vtkMRMLScalarVolumeNode::GetScalarVolumeDisplayNode()
{
  return vtkMRMLScalarVolumeDisplayNode::SafeDownCast(this->GetDisplayNode());
}

vtkMRMLStorageNode* vtkMRMLScalarVolumeNode::CreateDefaultStorageNode()
{
  return vtkMRMLVolumeArchetypeStorageNode::New();
}

void vtkMRMLScalarVolumeNode::CreateDefaultDisplayNodes()
{
  if (!this->GetDisplayNode() && this->GetScene())
  {
    vtkMRMLNode* display = this->GetScene()->AddNewNodeByClass("vtkMRMLScalarVolumeDisplayNode");
    static_cast<vtkMRMLScalarVolumeDisplayNode*>(display)->SetDefaultColorMap();
    this->SetAndObserveDisplayNodeID(display->GetID());
  }
}
