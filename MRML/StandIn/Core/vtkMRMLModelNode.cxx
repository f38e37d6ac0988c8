#include "vtkMRMLModelNode.h"

#include "vtkMRMLModelDisplayNode.h"
#include "vtkMRMLModelStorageNode.h"
#include "vtkMRMLScene.h"
#include "vtkMRMLTransformNode.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkAssignAttribute.h>
#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkEventForwarderCommand.h>
#include <vtkGeneralTransform.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTransformFilter.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

vtkMRMLNodeNewMacro(vtkMRMLModelNode);

vtkMRMLModelNode::~vtkMRMLModelNode()
{
  this->StopForwarding();
  if (this->MeshProducer)
  {
    this->MeshProducer->RemoveObserver(this->MRMLCallbackCommand);
  }
}

void vtkMRMLModelNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  auto* node = vtkMRMLModelNode::SafeDownCast(anode);
  vtkPointSet* mesh = node ? node->GetMesh() : nullptr;
  if (!mesh)
  {
    this->SetAndObserveMesh(nullptr);
  }
  else if (!deepCopy)
  {
    this->MeshType = node->MeshType;
    this->SetMeshConnection(node->MeshConnection);
  }
  else if (this->GetMesh() && std::string(this->GetMesh()->GetClassName()) == mesh->GetClassName())
  {
    this->GetMesh()->DeepCopy(mesh);
  }
  else
  {
    const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
    copy->DeepCopy(mesh);
    this->SetAndObserveMesh(copy);
  }
}

void vtkMRMLModelNode::ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData)
{
  this->Superclass::ProcessMRMLEvents(caller, event, callData);
  if (caller && caller == this->MeshProducer && event == vtkCommand::ModifiedEvent)
  {
    this->StorableModified();
    this->InvokeCustomModifiedEvent(vtkMRMLModelNode::MeshModifiedEvent);
  }
}

// --- Mesh --------------------------------------------------------------------------------------

void vtkMRMLModelNode::SetAndObserveMesh(vtkPointSet* mesh)
{
  if (mesh && mesh == this->ForwardedMesh)
  {
    return;
  }
  auto* polyData = vtkPolyData::SafeDownCast(mesh);
  if (mesh && !polyData && !vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    vtkErrorMacro("SetAndObserveMesh: a model is a vtkPolyData or a vtkUnstructuredGrid");
    return;
  }
  this->StopForwarding();
  if (!mesh)
  {
    this->SetMeshConnection(nullptr);
    return;
  }
  // A change of the mesh shall be one of its producer, which is what the node observes.
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  this->DataEventForwarder = vtkSmartPointer<vtkEventForwarderCommand>::New();
  this->DataEventForwarder->SetTarget(producer);
  this->ForwardedMesh = mesh;
  mesh->AddObserver(vtkCommand::ModifiedEvent, this->DataEventForwarder);
  this->MeshType = polyData ? PolyDataMeshType : UnstructuredGridMeshType;
  this->SetMeshConnection(producer->GetOutputPort());
}

void vtkMRMLModelNode::StopForwarding()
{
  if (this->ForwardedMesh)
  {
    this->ForwardedMesh->RemoveObserver(this->DataEventForwarder);
    this->ForwardedMesh = nullptr;
    this->DataEventForwarder = nullptr;
  }
}

void vtkMRMLModelNode::SetAndObservePolyData(vtkPolyData* polyData)
{
  this->SetAndObserveMesh(polyData);
}

void vtkMRMLModelNode::SetPolyDataConnection(vtkAlgorithmOutput* inputPort)
{
  this->StopForwarding();
  this->MeshType = PolyDataMeshType;
  this->SetMeshConnection(inputPort);
}

void vtkMRMLModelNode::SetUnstructuredGridConnection(vtkAlgorithmOutput* inputPort)
{
  this->StopForwarding();
  this->MeshType = UnstructuredGridMeshType;
  this->SetMeshConnection(inputPort);
}

void vtkMRMLModelNode::SetMeshConnection(vtkAlgorithmOutput* inputPort)
{
  if (this->MeshConnection == inputPort)
  {
    return;
  }
  if (this->MeshProducer)
  {
    this->MeshProducer->RemoveObserver(this->MRMLCallbackCommand);
  }
  this->MeshConnection = inputPort;
  this->MeshProducer = inputPort ? inputPort->GetProducer() : nullptr;
  if (this->MeshProducer)
  {
    this->MeshProducer->AddObserver(vtkCommand::ModifiedEvent, this->MRMLCallbackCommand);
  }
  this->SetMeshToDisplayNodes();
  this->StorableModified();
  this->Modified();
  this->InvokeCustomModifiedEvent(vtkMRMLModelNode::MeshModifiedEvent, this);
}

vtkPointSet* vtkMRMLModelNode::GetMesh()
{
  if (!this->MeshProducer)
  {
    return nullptr;
  }
  this->MeshProducer->Update();
  return vtkPointSet::SafeDownCast(
      this->MeshProducer->GetOutputDataObject(this->MeshConnection->GetIndex()));
}

vtkPolyData* vtkMRMLModelNode::GetPolyData()
{
  return vtkPolyData::SafeDownCast(this->GetMesh());
}

vtkUnstructuredGrid* vtkMRMLModelNode::GetUnstructuredGrid()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetMesh());
}

vtkAlgorithmOutput* vtkMRMLModelNode::GetPolyDataConnection()
{
  return this->MeshType == PolyDataMeshType ? this->MeshConnection.Get() : nullptr;
}

vtkAlgorithmOutput* vtkMRMLModelNode::GetUnstructuredGridConnection()
{
  return this->MeshType == UnstructuredGridMeshType ? this->MeshConnection.Get() : nullptr;
}

// --- Arrays ------------------------------------------------------------------------------------

vtkDataSetAttributes* vtkMRMLModelNode::AttributesAt(int location)
{
  vtkPointSet* mesh = this->GetMesh();
  if (!mesh)
  {
    return nullptr;
  }
  if (location == vtkAssignAttribute::CELL_DATA)
  {
    return mesh->GetCellData();
  }
  return mesh->GetPointData();
}

void vtkMRMLModelNode::AddPointScalars(vtkDataArray* array)
{
  this->AddScalars(array, vtkAssignAttribute::POINT_DATA);
}

void vtkMRMLModelNode::AddCellScalars(vtkDataArray* array)
{
  this->AddScalars(array, vtkAssignAttribute::CELL_DATA);
}

void vtkMRMLModelNode::AddScalars(vtkDataArray* array, int location)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(location);
  if (!array || !attributes)
  {
    return;
  }
  const int before = attributes->GetNumberOfArrays();
  attributes->AddArray(array);
  if (before > 0)
  {
    attributes->SetActiveScalars(array->GetName());
  }
}

void vtkMRMLModelNode::RemoveScalars(const char* scalarName)
{
  for (const int location : {vtkAssignAttribute::POINT_DATA, vtkAssignAttribute::CELL_DATA})
  {
    if (vtkDataSetAttributes* attributes = this->AttributesAt(location))
    {
      attributes->RemoveArray(scalarName);
    }
  }
}

bool vtkMRMLModelNode::HasPointScalarName(const char* scalarName)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(vtkAssignAttribute::POINT_DATA);
  return attributes && scalarName && attributes->HasArray(scalarName);
}

bool vtkMRMLModelNode::HasCellScalarName(const char* scalarName)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(vtkAssignAttribute::CELL_DATA);
  return attributes && scalarName && attributes->HasArray(scalarName);
}

int vtkMRMLModelNode::SetActivePointScalars(const char* scalarName, int attributeType)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(vtkAssignAttribute::POINT_DATA);
  return attributes ? attributes->SetActiveAttribute(scalarName, attributeType) : -1;
}

int vtkMRMLModelNode::SetActiveCellScalars(const char* scalarName, int attributeType)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(vtkAssignAttribute::CELL_DATA);
  return attributes ? attributes->SetActiveAttribute(scalarName, attributeType) : -1;
}

const char* vtkMRMLModelNode::GetActivePointScalarName(int type)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(vtkAssignAttribute::POINT_DATA);
  vtkAbstractArray* array = attributes ? attributes->GetAbstractAttribute(type) : nullptr;
  return array ? array->GetName() : nullptr;
}

const char* vtkMRMLModelNode::GetActiveCellScalarName(int type)
{
  vtkDataSetAttributes* attributes = this->AttributesAt(vtkAssignAttribute::CELL_DATA);
  vtkAbstractArray* array = attributes ? attributes->GetAbstractAttribute(type) : nullptr;
  return array ? array->GetName() : nullptr;
}

// --- Display, storage, frame -------------------------------------------------------------------

vtkMRMLModelDisplayNode* vtkMRMLModelNode::GetModelDisplayNode()
{
  return vtkMRMLModelDisplayNode::SafeDownCast(this->GetDisplayNode());
}

void vtkMRMLModelNode::SetMeshToDisplayNodes()
{
  for (int n = 0; n < this->GetNumberOfDisplayNodes(); ++n)
  {
    if (auto* display = vtkMRMLModelDisplayNode::SafeDownCast(this->GetNthDisplayNode(n)))
    {
      display->SetInputMeshConnection(this->MeshConnection);
    }
  }
}

void vtkMRMLModelNode::OnNodeReferenceAdded(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceAdded(reference);
  if (auto* display = vtkMRMLModelDisplayNode::SafeDownCast(reference->GetReferencedNode()))
  {
    display->SetInputMeshConnection(this->MeshConnection);
  }
}

void vtkMRMLModelNode::OnNodeReferenceModified(vtkMRMLNodeReference* reference)
{
  this->Superclass::OnNodeReferenceModified(reference);
  if (auto* display = vtkMRMLModelDisplayNode::SafeDownCast(reference->GetReferencedNode()))
  {
    display->SetInputMeshConnection(this->MeshConnection);
  }
}

void vtkMRMLModelNode::CreateDefaultDisplayNodes()
{
  if (this->GetModelDisplayNode() || !this->GetScene())
  {
    return;
  }
  vtkMRMLNode* display = this->GetScene()->AddNewNodeByClass("vtkMRMLModelDisplayNode");
  this->SetAndObserveDisplayNodeID(display->GetID());
}

vtkMRMLStorageNode* vtkMRMLModelNode::CreateDefaultStorageNode()
{
  return vtkMRMLModelStorageNode::New();
}

std::string vtkMRMLModelNode::GetDefaultStorageNodeClassName(const char*)
{
  return "vtkMRMLModelStorageNode";
}

bool vtkMRMLModelNode::GetModifiedSinceRead()
{
  return this->Superclass::GetModifiedSinceRead() ||
         (this->GetMesh() && this->GetMesh()->GetMTime() > this->GetStoredTime().GetMTime());
}

void vtkMRMLModelNode::GetBounds(double bounds[6])
{
  this->Superclass::GetBounds(bounds);
  if (vtkPointSet* mesh = this->GetMesh())
  {
    mesh->ComputeBounds();
    mesh->GetBounds(bounds);
  }
}

void vtkMRMLModelNode::GetRASBounds(double bounds[6])
{
  double local[6];
  this->GetBounds(local);
  vtkMRMLTransformNode* parent = this->GetParentTransformNode();
  if (!parent || !vtkBoundingBox::IsValid(local))
  {
    std::copy(local, local + 6, bounds);
    return;
  }
  vtkNew<vtkGeneralTransform> toWorld;
  parent->GetTransformToWorld(toWorld);
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double point[3] = {local[corner & 1], local[2 + (corner >> 1 & 1)],
                             local[4 + (corner >> 2)]};
    double moved[3];
    toWorld->TransformPoint(point, moved);
    box.AddPoint(moved);
  }
  box.GetBounds(bounds);
}

bool vtkMRMLModelNode::CanApplyNonLinearTransforms() const
{
  return true;
}

void vtkMRMLModelNode::ApplyTransform(vtkAbstractTransform* transform)
{
  vtkPointSet* mesh = this->GetMesh();
  if (!mesh)
  {
    return;
  }
  vtkNew<vtkTransformFilter> filter;
  filter->SetInputData(mesh);
  filter->SetTransform(transform);
  filter->Update();
  if (this->ForwardedMesh)
  {
    mesh->DeepCopy(filter->GetOutput());
  }
  else
  {
    this->SetAndObserveMesh(vtkPointSet::SafeDownCast(filter->GetOutput()));
  }
}
