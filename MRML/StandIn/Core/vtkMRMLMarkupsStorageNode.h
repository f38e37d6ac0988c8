#pragma once

#include "vtkMRMLStorageNode.h"

/// A markups node's file, in LPS unless CoordinateSystem says RAS.
class VTK_MRML_EXPORT vtkMRMLMarkupsStorageNode : public vtkMRMLStorageNode
{
public:
  vtkTypeMacro(vtkMRMLMarkupsStorageNode, vtkMRMLStorageNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;
  bool CanReadInReferenceNode(vtkMRMLNode* refNode) override;

  vtkSetMacro(CoordinateSystem, int);
  vtkGetMacro(CoordinateSystem, int);
  static const char* GetCoordinateSystemAsString(int id);
  static int GetCoordinateSystemFromString(const char* name);

protected:
  vtkMRMLMarkupsStorageNode() = default;
  ~vtkMRMLMarkupsStorageNode() override = default;
  vtkMRMLMarkupsStorageNode(const vtkMRMLMarkupsStorageNode&) = delete;
  void operator=(const vtkMRMLMarkupsStorageNode&) = delete;

  int CoordinateSystem = vtkMRMLStorageNode::CoordinateSystemLPS;
};
