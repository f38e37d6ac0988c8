#pragma once

#include "vtkMRMLColorNode.h"

#include <vtkNew.h>

/// A table of colours that a user or a file gives; Slicer's built-in tables are known by id only.
class VTK_MRML_EXPORT vtkMRMLColorTableNode : public vtkMRMLColorNode
{
public:
  static vtkMRMLColorTableNode* New();
  vtkTypeMacro(vtkMRMLColorTableNode, vtkMRMLColorNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "ColorTable"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;

  vtkLookupTable* GetLookupTable() override { return this->LookupTable; }
  void SetNumberOfColors(int n);
  int GetNumberOfColors() override;
  /// Colours are 0 to 1. \return 0 where the entry is out of range
  int SetColor(int entry, const char* name, double r, double g, double b, double a = 1.0);
  int SetColor(int entry, double r, double g, double b, double a);
  int SetColor(int entry, double r, double g, double b);
  int SetOpacity(int entry, double opacity);
  void AddColor(const char* name, double r, double g, double b, double a = 1.0);
  bool GetColor(int entry, double color[4]) override;
  vtkMRMLStorageNode* CreateDefaultStorageNode() override;

protected:
  vtkMRMLColorTableNode();
  ~vtkMRMLColorTableNode() override = default;
  vtkMRMLColorTableNode(const vtkMRMLColorTableNode&) = delete;
  void operator=(const vtkMRMLColorTableNode&) = delete;

private:
  vtkNew<vtkLookupTable> LookupTable;
};
