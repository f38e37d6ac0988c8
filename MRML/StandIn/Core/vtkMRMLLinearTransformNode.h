#pragma once

#include "vtkMRMLTransformNode.h"

/// A transform by a matrix; the scene file holds it too, besides the node's own file.
class VTK_MRML_EXPORT vtkMRMLLinearTransformNode : public vtkMRMLTransformNode
{
public:
  static vtkMRMLLinearTransformNode* New();
  vtkTypeMacro(vtkMRMLLinearTransformNode, vtkMRMLTransformNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "LinearTransform"; }
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentDefaultMacro(vtkMRMLLinearTransformNode);

protected:
  vtkMRMLLinearTransformNode();
  ~vtkMRMLLinearTransformNode() override = default;
  vtkMRMLLinearTransformNode(const vtkMRMLLinearTransformNode&) = delete;
  void operator=(const vtkMRMLLinearTransformNode&) = delete;
};
