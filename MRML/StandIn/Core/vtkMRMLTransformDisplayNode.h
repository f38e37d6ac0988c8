#pragma once

#include "vtkMRMLDisplayNode.h"

/// How is a transform seen; Slicer's own settings are kept as text.
class VTK_MRML_EXPORT vtkMRMLTransformDisplayNode : public vtkMRMLDisplayNode
{
public:
  static vtkMRMLTransformDisplayNode* New();
  vtkTypeMacro(vtkMRMLTransformDisplayNode, vtkMRMLDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "TransformDisplayNode"; }
  vtkMRMLCopyContentDefaultMacro(vtkMRMLTransformDisplayNode);

protected:
  vtkMRMLTransformDisplayNode();
  ~vtkMRMLTransformDisplayNode() override = default;
  vtkMRMLTransformDisplayNode(const vtkMRMLTransformDisplayNode&) = delete;
  void operator=(const vtkMRMLTransformDisplayNode&) = delete;
};
