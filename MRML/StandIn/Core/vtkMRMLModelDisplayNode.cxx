#include "vtkMRMLModelDisplayNode.h"

#include "vtkMRMLEnumText.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkAssignAttribute.h>
#include <vtkCellData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

vtkMRMLNodeNewMacro(vtkMRMLModelDisplayNode);

namespace
{

const char* const sliceDisplayModes[] = {"intersection", "projection", "distanceEncodedProjection"};

} // namespace

vtkMRMLModelDisplayNode::vtkMRMLModelDisplayNode()
{
  vtkNew<vtkIntArray> events;
  events->InsertNextValue(vtkCommand::ModifiedEvent);
  this->AddNodeReferenceRole("distanceEncodedProjectionColor", nullptr, events);
}

void vtkMRMLModelDisplayNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLEnumMacro(sliceDisplayMode, SliceDisplayMode);
  vtkMRMLWriteXMLBooleanMacro(thresholdEnabled, ThresholdEnabled);
  vtkMRMLWriteXMLVectorMacro(thresholdRange, ThresholdRange, double, 2);
  vtkMRMLWriteXMLVectorMacro(backfaceColorHSVOffset, BackfaceColorHSVOffset, double, 3);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLModelDisplayNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(sliceDisplayMode, SliceDisplayMode);
  vtkMRMLReadXMLBooleanMacro(thresholdEnabled, ThresholdEnabled);
  vtkMRMLReadXMLVectorMacro(thresholdRange, ThresholdRange, double, 2);
  vtkMRMLReadXMLVectorMacro(backfaceColorHSVOffset, BackfaceColorHSVOffset, double, 3);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLModelDisplayNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  vtkMRMLCopyBeginMacro(anode);
  vtkMRMLCopyEnumMacro(SliceDisplayMode);
  vtkMRMLCopyBooleanMacro(ThresholdEnabled);
  vtkMRMLCopyVectorMacro(ThresholdRange, double, 2);
  vtkMRMLCopyVectorMacro(BackfaceColorHSVOffset, double, 3);
  vtkMRMLCopyEndMacro();
}

const char* vtkMRMLModelDisplayNode::GetSliceDisplayModeAsString(int id)
{
  return vtkMRMLEnumText(sliceDisplayModes, id);
}

int vtkMRMLModelDisplayNode::GetSliceDisplayModeFromString(const char* name)
{
  return vtkMRMLEnumFromText(sliceDisplayModes, name);
}

void vtkMRMLModelDisplayNode::SetInputMeshConnection(vtkAlgorithmOutput* meshConnection)
{
  if (this->MeshConnection != meshConnection)
  {
    MRMLNodeModifyBlocker blocker(this);
    this->MeshConnection = meshConnection;
    this->MeshProducer = meshConnection ? meshConnection->GetProducer() : nullptr;
    this->UpdateScalarRange();
    this->Modified();
  }
}

vtkAlgorithmOutput* vtkMRMLModelDisplayNode::GetInputMeshConnection()
{
  return this->MeshConnection;
}

vtkPointSet* vtkMRMLModelDisplayNode::GetInputMesh()
{
  if (!this->MeshProducer)
  {
    return nullptr;
  }
  this->MeshProducer->Update();
  return vtkPointSet::SafeDownCast(
      this->MeshProducer->GetOutputDataObject(this->MeshConnection->GetIndex()));
}

vtkPolyData* vtkMRMLModelDisplayNode::GetInputPolyData()
{
  return vtkPolyData::SafeDownCast(this->GetInputMesh());
}

vtkUnstructuredGrid* vtkMRMLModelDisplayNode::GetInputUnstructuredGrid()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetInputMesh());
}

vtkDataSet* vtkMRMLModelDisplayNode::GetScalarDataSet()
{
  return this->GetInputMesh();
}

vtkDataArray* vtkMRMLModelDisplayNode::GetActiveScalarArray()
{
  vtkPointSet* mesh = this->GetInputMesh();
  if (!mesh || !this->ActiveScalarName)
  {
    return nullptr;
  }
  vtkDataSetAttributes* attributes = mesh->GetPointData();
  if (this->ActiveAttributeLocation == vtkAssignAttribute::CELL_DATA)
  {
    attributes = mesh->GetCellData();
  }
  return attributes->GetArray(this->ActiveScalarName);
}
