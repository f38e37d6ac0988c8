#pragma once

#include "vtkMRMLStorageNode.h"

/// A colour table's file (.ctbl, .txt): a line a colour, index, name and 0 to 255 of red, green, blue
/// and opacity.
class VTK_MRML_EXPORT vtkMRMLColorTableStorageNode : public vtkMRMLStorageNode
{
public:
  static vtkMRMLColorTableStorageNode* New();
  vtkTypeMacro(vtkMRMLColorTableStorageNode, vtkMRMLStorageNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "ColorTableStorage"; }
  bool CanReadInReferenceNode(vtkMRMLNode* refNode) override;

protected:
  vtkMRMLColorTableStorageNode();
  ~vtkMRMLColorTableStorageNode() override = default;
  vtkMRMLColorTableStorageNode(const vtkMRMLColorTableStorageNode&) = delete;
  void operator=(const vtkMRMLColorTableStorageNode&) = delete;

  void InitializeSupportedReadFileTypes() override;
  void InitializeSupportedWriteFileTypes() override;
  int ReadDataInternal(vtkMRMLNode* refNode) override;
  int WriteDataInternal(vtkMRMLNode* refNode) override;
};
