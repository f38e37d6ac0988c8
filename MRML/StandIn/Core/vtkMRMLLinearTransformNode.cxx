#include "vtkMRMLLinearTransformNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLLinearTransformNode);

vtkMRMLLinearTransformNode::vtkMRMLLinearTransformNode()
{
  this->SetMatrixTransformToParent(nullptr);
}

void vtkMRMLLinearTransformNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  if (!this->IsLinear())
  {
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  this->GetMatrixTransformToParent(matrix);
  of << " matrixTransformToParent=\"";
  for (int i = 0; i < 16; ++i)
  {
    of << (i > 0 ? " " : "") << vtkMRMLNumberText(matrix->GetElement(i / 4, i % 4));
  }
  of << "\"";
}
