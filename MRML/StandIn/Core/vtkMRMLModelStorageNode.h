#pragma once

#include "vtkMRMLStorageNode.h"

class vtkMRMLModelNode;
class vtkPointSet;

/// A model's file: .vtp, .vtu, .vtk, .stl, .ply or .obj. Files are in LPS unless CoordinateSystem or
/// the file's own header says RAS; in memory models are in RAS. Without compression XML files hold raw
/// bytes (Slicer: text), which both read.
class VTK_MRML_EXPORT vtkMRMLModelStorageNode : public vtkMRMLStorageNode
{
public:
  static vtkMRMLModelStorageNode* New();
  vtkTypeMacro(vtkMRMLModelStorageNode, vtkMRMLStorageNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "ModelStorage"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;
  bool CanReadInReferenceNode(vtkMRMLNode* refNode) override;

  vtkSetClampMacro(CoordinateSystem, int, 0, vtkMRMLStorageNode::CoordinateSystemType_Last - 1);
  vtkGetMacro(CoordinateSystem, int);
  static const char* GetCoordinateSystemAsString(int id);
  static int GetCoordinateSystemFromString(const char* name);
  static void ConvertBetweenRASAndLPS(vtkPointSet* inputMesh, vtkPointSet* outputMesh);

protected:
  vtkMRMLModelStorageNode();
  ~vtkMRMLModelStorageNode() override = default;
  vtkMRMLModelStorageNode(const vtkMRMLModelStorageNode&) = delete;
  void operator=(const vtkMRMLModelStorageNode&) = delete;

  void InitializeSupportedReadFileTypes() override;
  void InitializeSupportedWriteFileTypes() override;
  int ReadDataInternal(vtkMRMLNode* refNode) override;
  int WriteDataInternal(vtkMRMLNode* refNode) override;

private:
  vtkSmartPointer<vtkPointSet> ReadMesh(const std::string& path, int& coordinateSystem);
  bool WriteMesh(vtkPointSet* mesh, const std::string& path);

  int CoordinateSystem = vtkMRMLStorageNode::CoordinateSystemLPS;
};
