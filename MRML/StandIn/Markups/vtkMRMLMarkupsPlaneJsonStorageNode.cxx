#include "vtkMRMLMarkupsPlaneJsonStorageNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsPlaneJsonStorageNode);

bool vtkMRMLMarkupsPlaneJsonStorageNode::CanReadInReferenceNode(vtkMRMLNode* refNode)
{
  return refNode && refNode->IsA("vtkMRMLMarkupsPlaneNode");
}
