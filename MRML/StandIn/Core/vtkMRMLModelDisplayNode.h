#pragma once

#include "vtkMRMLDisplayNode.h"

#include <vtkAlgorithmOutput.h>

class vtkAlgorithm;
class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/// How is a model seen, in 3D and cut by slices.
class VTK_MRML_EXPORT vtkMRMLModelDisplayNode : public vtkMRMLDisplayNode
{
public:
  static vtkMRMLModelDisplayNode* New();
  vtkTypeMacro(vtkMRMLModelDisplayNode, vtkMRMLDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "ModelDisplay"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLModelDisplayNode);

  enum SliceDisplayModeType
  {
    SliceDisplayIntersection,
    SliceDisplayProjection,
    SliceDisplayDistanceEncodedProjection,
    SliceDisplayMode_Last
  };
  vtkGetMacro(SliceDisplayMode, int);
  vtkSetMacro(SliceDisplayMode, int);
  static const char* GetSliceDisplayModeAsString(int id);
  static int GetSliceDisplayModeFromString(const char* name);

  /// The model's mesh; set by the model node.
  virtual void SetInputMeshConnection(vtkAlgorithmOutput* meshConnection);
  virtual vtkAlgorithmOutput* GetInputMeshConnection();
  virtual vtkPointSet* GetInputMesh();
  virtual vtkPolyData* GetInputPolyData();
  virtual vtkUnstructuredGrid* GetInputUnstructuredGrid();
  vtkDataSet* GetScalarDataSet() override;
  vtkDataArray* GetActiveScalarArray() override;

  /// Whether only what has a scalar within the range is shown.
  vtkSetMacro(ThresholdEnabled, bool);
  vtkGetMacro(ThresholdEnabled, bool);
  vtkBooleanMacro(ThresholdEnabled, bool);
  vtkSetVector2Macro(ThresholdRange, double);
  vtkGetVector2Macro(ThresholdRange, double);
  double GetThresholdMin() { return this->ThresholdRange[0]; }
  double GetThresholdMax() { return this->ThresholdRange[1]; }
  vtkSetVector3Macro(BackfaceColorHSVOffset, double);
  vtkGetVector3Macro(BackfaceColorHSVOffset, double);

protected:
  vtkMRMLModelDisplayNode();
  ~vtkMRMLModelDisplayNode() override = default;
  vtkMRMLModelDisplayNode(const vtkMRMLModelDisplayNode&) = delete;
  void operator=(const vtkMRMLModelDisplayNode&) = delete;

private:
  int SliceDisplayMode = SliceDisplayIntersection;
  bool ThresholdEnabled = false;
  double ThresholdRange[2] = {0.0, -1.0};
  double BackfaceColorHSVOffset[3] = {-0.05, -0.1, 0.0};
  vtkSmartPointer<vtkAlgorithm> MeshProducer; ///< held for its output
  vtkSmartPointer<vtkAlgorithmOutput> MeshConnection;
};
