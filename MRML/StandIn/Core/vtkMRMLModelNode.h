#pragma once

#include "vtkMRMLDisplayableNode.h"

#include <vtkAlgorithmOutput.h>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkEventForwarderCommand;
class vtkMRMLModelDisplayNode;
class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/// A surface (poly data) or a volume mesh (unstructured grid) with named arrays; RAS [mm].
class VTK_MRML_EXPORT vtkMRMLModelNode : public vtkMRMLDisplayableNode
{
public:
  static vtkMRMLModelNode* New();
  vtkTypeMacro(vtkMRMLModelNode, vtkMRMLDisplayableNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "Model"; }
  vtkMRMLCopyContentMacro(vtkMRMLModelNode);
  void ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData) override;

  enum MeshTypeHint
  {
    PolyDataMeshType = 0,
    UnstructuredGridMeshType
  };
  vtkGetMacro(MeshType, MeshTypeHint);
  enum
  {
    MeshModifiedEvent = 17001,
    PolyDataModifiedEvent = 17001
  };

  virtual void SetAndObserveMesh(vtkPointSet* Mesh);
  virtual void SetAndObservePolyData(vtkPolyData* polyData);
  virtual vtkPointSet* GetMesh();
  virtual vtkPolyData* GetPolyData();
  virtual vtkUnstructuredGrid* GetUnstructuredGrid();
  virtual void SetPolyDataConnection(vtkAlgorithmOutput* inputPort);
  virtual void SetUnstructuredGridConnection(vtkAlgorithmOutput* inputPort);
  vtkAlgorithmOutput* GetMeshConnection() { return this->MeshConnection; }
  virtual vtkAlgorithmOutput* GetPolyDataConnection();
  virtual vtkAlgorithmOutput* GetUnstructuredGridConnection();
  vtkMRMLModelDisplayNode* GetModelDisplayNode();

  /// \name Named arrays on points or cells
  ///@{
  void AddPointScalars(vtkDataArray* array);
  void AddCellScalars(vtkDataArray* array);
  /// \param location  vtkAssignAttribute::POINT_DATA or CELL_DATA
  void AddScalars(vtkDataArray* array, int location);
  void RemoveScalars(const char* scalarName);
  bool HasPointScalarName(const char* scalarName);
  bool HasCellScalarName(const char* scalarName);
  int SetActivePointScalars(const char* scalarName, int attributeType);
  const char* GetActivePointScalarName(int type);
  int SetActiveCellScalars(const char* scalarName, int attributeType);
  const char* GetActiveCellScalarName(int type);
  ///@}

  void GetRASBounds(double bounds[6]) override;
  void GetBounds(double bounds[6]) override;
  bool CanApplyNonLinearTransforms() const override;
  void ApplyTransform(vtkAbstractTransform* transform) override;
  vtkMRMLStorageNode* CreateDefaultStorageNode() override;
  std::string GetDefaultStorageNodeClassName(const char* filename = nullptr) override;
  void CreateDefaultDisplayNodes() override;
  bool GetModifiedSinceRead() override;

protected:
  vtkMRMLModelNode() = default;
  ~vtkMRMLModelNode() override;
  vtkMRMLModelNode(const vtkMRMLModelNode&) = delete;
  void operator=(const vtkMRMLModelNode&) = delete;

  virtual void SetMeshConnection(vtkAlgorithmOutput* inputPort);
  void OnNodeReferenceAdded(vtkMRMLNodeReference* reference) override;
  void OnNodeReferenceModified(vtkMRMLNodeReference* reference) override;
  void SetMeshToDisplayNodes();

private:
  void StopForwarding();
  vtkDataSetAttributes* AttributesAt(int location);

  vtkSmartPointer<vtkAlgorithm> MeshProducer; ///< observed, and held for its output
  vtkSmartPointer<vtkAlgorithmOutput> MeshConnection;
  vtkSmartPointer<vtkPointSet> ForwardedMesh;
  vtkSmartPointer<vtkEventForwarderCommand> DataEventForwarder;
  MeshTypeHint MeshType = PolyDataMeshType;
};
