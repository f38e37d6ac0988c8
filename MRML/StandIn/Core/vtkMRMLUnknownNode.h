#pragma once

#include "vtkMRMLNode.h"

/// The stand-in's own: an element of a scene file whose class is not registered. It takes part in the
/// scene by its id, name, references and attributes; all else is kept as text and written back. The
/// names of its files follow where the scene moves.
class VTK_MRML_EXPORT vtkMRMLUnknownNode : public vtkMRMLNode
{
public:
  static vtkMRMLUnknownNode* New();
  vtkTypeMacro(vtkMRMLUnknownNode, vtkMRMLNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return this->TagName.c_str(); }
  void SetNodeTagName(const std::string& tag) { this->TagName = tag; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;

  /// Absolute names of the files that the element names, in their order.
  std::vector<std::string> GetFiles() const;
  void SetFiles(const std::vector<std::string>& paths);

protected:
  vtkMRMLUnknownNode() = default;
  ~vtkMRMLUnknownNode() override = default;
  vtkMRMLUnknownNode(const vtkMRMLUnknownNode&) = delete;
  void operator=(const vtkMRMLUnknownNode&) = delete;

private:
  struct File
  {
    std::string Attribute;
    std::string Path;
  };
  std::string TagName = "Unknown";
  std::vector<File> Files;
};
