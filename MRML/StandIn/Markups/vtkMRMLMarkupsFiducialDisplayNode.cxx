#include "vtkMRMLMarkupsFiducialDisplayNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsFiducialDisplayNode);

vtkMRMLMarkupsFiducialDisplayNode::vtkMRMLMarkupsFiducialDisplayNode()
{
  this->SetPropertiesLabelVisibility(false);
  this->SetPointLabelsVisibility(true);
}
