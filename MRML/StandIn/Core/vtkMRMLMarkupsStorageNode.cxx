#include "vtkMRMLMarkupsStorageNode.h"

void vtkMRMLMarkupsStorageNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(coordinateSystem, CoordinateSystem);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLMarkupsStorageNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLEnumMacro(coordinateSystem, CoordinateSystem);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLMarkupsStorageNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  vtkMRMLCopyBeginMacro(node);
  vtkMRMLCopyEnumMacro(CoordinateSystem);
  vtkMRMLCopyEndMacro();
}

bool vtkMRMLMarkupsStorageNode::CanReadInReferenceNode(vtkMRMLNode* refNode)
{
  return refNode && refNode->IsA("vtkMRMLMarkupsNode");
}

const char* vtkMRMLMarkupsStorageNode::GetCoordinateSystemAsString(int id)
{
  return GetCoordinateSystemTypeAsString(id);
}

int vtkMRMLMarkupsStorageNode::GetCoordinateSystemFromString(const char* name)
{
  return GetCoordinateSystemTypeFromString(name);
}
