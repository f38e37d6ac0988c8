#pragma once

#include "vtkMRMLMarkupsStorageNode.h"
#include "vtkSlicerMarkupsModuleMRMLExport.h"

/// A markups node's .mrk.json file, by Slicer's schema 1.0.3. What a file says beyond what the classes
/// here know is written back.
class VTK_SLICER_MARKUPS_MODULE_MRML_EXPORT vtkMRMLMarkupsJsonStorageNode
    : public vtkMRMLMarkupsStorageNode
{
public:
  static vtkMRMLMarkupsJsonStorageNode* New();
  vtkTypeMacro(vtkMRMLMarkupsJsonStorageNode, vtkMRMLMarkupsStorageNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "MarkupsJsonStorage"; }
  void Copy(vtkMRMLNode* node) override;

protected:
  vtkMRMLMarkupsJsonStorageNode();
  ~vtkMRMLMarkupsJsonStorageNode() override = default;
  vtkMRMLMarkupsJsonStorageNode(const vtkMRMLMarkupsJsonStorageNode&) = delete;
  void operator=(const vtkMRMLMarkupsJsonStorageNode&) = delete;

  void InitializeSupportedReadFileTypes() override;
  void InitializeSupportedWriteFileTypes() override;
  int ReadDataInternal(vtkMRMLNode* refNode) override;
  int WriteDataInternal(vtkMRMLNode* refNode) override;

private:
  std::string KeptJson; ///< the markup as it was last read
};
