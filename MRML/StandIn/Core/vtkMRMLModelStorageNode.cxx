#include "vtkMRMLModelStorageNode.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLModelNode.h"

#include <vtkFieldData.h>
#include <vtkOBJReader.h>
#include <vtkOBJWriter.h>
#include <vtkObjectFactory.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkStringArray.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

vtkMRMLNodeNewMacro(vtkMRMLModelStorageNode);

namespace
{

/// The frame that a file's header names; -1 where it names none.
int FrameOfHeader(const char* header)
{
  const std::string text = header ? header : "";
  return text.find("SPACE=RAS") != std::string::npos   ? vtkMRMLStorageNode::CoordinateSystemRAS
         : text.find("SPACE=LPS") != std::string::npos ? vtkMRMLStorageNode::CoordinateSystemLPS
                                                       : -1;
}

/// The frame that the field array SPACE names; the array is taken out.
int TakeFrameOfFieldData(vtkPointSet* mesh)
{
  auto* space = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("SPACE"));
  if (!space || space->GetNumberOfValues() < 1)
  {
    return -1;
  }
  const std::string name = "SPACE=" + space->GetValue(0);
  mesh->GetFieldData()->RemoveArray("SPACE");
  return FrameOfHeader(name.c_str());
}

template <class Reader>
vtkSmartPointer<vtkPointSet> Read(Reader* reader, const std::string& path,
                                  vtkMRMLMessageCollection* messages)
{
  reader->SetFileName(path.c_str());
  messages->SetObservedObject(reader);
  reader->Update();
  messages->SetObservedObject(nullptr);
  auto* mesh = vtkPointSet::SafeDownCast(reader->GetOutputDataObject(0));
  // Readers give what they have of a damaged file; not all of them say so. Empty models are not saved.
  return mesh && mesh->GetNumberOfPoints() > 0 && reader->GetErrorCode() == 0 ? mesh : nullptr;
}

template <class Reader>
vtkSmartPointer<vtkPointSet> ReadLegacy(Reader* reader, const std::string& path,
                                        vtkMRMLMessageCollection* messages)
{
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return Read(reader, path, messages);
}

template <class Writer>
bool Write(Writer* writer, vtkDataObject* mesh, const std::string& path,
           vtkMRMLMessageCollection* messages)
{
  writer->SetInputDataObject(mesh);
  writer->SetFileName(path.c_str());
  messages->SetObservedObject(writer);
  const bool written = writer->Write() != 0;
  messages->SetObservedObject(nullptr);
  return written;
}

} // namespace

vtkMRMLModelStorageNode::vtkMRMLModelStorageNode()
{
  this->DefaultWriteFileExtension = "vtk";
}

void vtkMRMLModelStorageNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  // Scenes of Slicer 4 do not say: their models are RAS.
  this->CoordinateSystem = CoordinateSystemRAS;
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLEnumMacro(coordinateSystem, CoordinateSystem);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLModelStorageNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  of << " coordinateSystem=\"" << GetCoordinateSystemAsString(this->CoordinateSystem) << "\"";
}

void vtkMRMLModelStorageNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  if (auto* source = vtkMRMLModelStorageNode::SafeDownCast(node))
  {
    this->SetCoordinateSystem(source->CoordinateSystem);
  }
}

const char* vtkMRMLModelStorageNode::GetCoordinateSystemAsString(int id)
{
  return GetCoordinateSystemTypeAsString(id);
}

int vtkMRMLModelStorageNode::GetCoordinateSystemFromString(const char* name)
{
  return GetCoordinateSystemTypeFromString(name);
}

bool vtkMRMLModelStorageNode::CanReadInReferenceNode(vtkMRMLNode* refNode)
{
  return refNode && refNode->IsA("vtkMRMLModelNode");
}

void vtkMRMLModelStorageNode::InitializeSupportedReadFileTypes()
{
  for (const char* type :
       {"Poly Data (.vtk)", "XML Poly Data (.vtp)", "XML Unstructured Grid (.vtu)", "STL (.stl)",
        "PLY (.ply)", "Wavefront OBJ (.obj)"})
  {
    this->SupportedReadFileTypes->InsertNextValue(type);
  }
}

void vtkMRMLModelStorageNode::InitializeSupportedWriteFileTypes()
{
  for (const char* type :
       {"Poly Data (.vtk)", "XML Poly Data (.vtp)", "XML Unstructured Grid (.vtu)", "STL (.stl)",
        "PLY (.ply)", "Wavefront OBJ (.obj)"})
  {
    this->SupportedWriteFileTypes->InsertNextValue(type);
  }
}

void vtkMRMLModelStorageNode::ConvertBetweenRASAndLPS(vtkPointSet* inputMesh,
                                                      vtkPointSet* outputMesh)
{
  vtkNew<vtkTransform> flip;
  flip->Scale(-1.0, -1.0, 1.0);
  if (inputMesh->IsA("vtkPolyData"))
  {
    vtkNew<vtkTransformPolyDataFilter> filter; // keeps texture coordinates
    filter->SetTransform(flip);
    filter->SetInputData(inputMesh);
    filter->Update();
    outputMesh->ShallowCopy(filter->GetOutput());
  }
  else
  {
    vtkNew<vtkTransformFilter> filter;
    filter->SetTransform(flip);
    filter->SetInputData(inputMesh);
    filter->TransformAllInputVectorsOn();
    filter->Update();
    outputMesh->ShallowCopy(filter->GetOutput());
  }
}

// --- Reading -----------------------------------------------------------------------------------

int vtkMRMLModelStorageNode::ReadDataInternal(vtkMRMLNode* refNode)
{
  int frame = -1;
  const int errors = this->UserMessages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent);
  vtkSmartPointer<vtkPointSet> mesh = this->ReadMesh(this->GetFullNameFromFileName(), frame);
  if (!mesh || this->UserMessages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent) > errors)
  {
    return 0;
  }
  this->CoordinateSystem = frame >= 0 ? frame : this->CoordinateSystem;
  if (this->CoordinateSystem == CoordinateSystemLPS)
  {
    const auto flipped = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
    ConvertBetweenRASAndLPS(mesh, flipped);
    mesh = flipped;
  }
  static_cast<vtkMRMLModelNode*>(refNode)->SetAndObserveMesh(mesh);
  return 1;
}

vtkSmartPointer<vtkPointSet> vtkMRMLModelStorageNode::ReadMesh(const std::string& path, int& frame)
{
  const std::string extension = GetLowercaseExtensionFromFileName(path);
  vtkSmartPointer<vtkPointSet> mesh;
  if (extension == ".vtp" || extension == ".vtu")
  {
    mesh = extension == ".vtp"
               ? Read(vtkNew<vtkXMLPolyDataReader>().Get(), path, this->UserMessages)
               : Read(vtkNew<vtkXMLUnstructuredGridReader>().Get(), path, this->UserMessages);
    frame = mesh ? TakeFrameOfFieldData(mesh) : -1;
  }
  else if (extension == ".vtk")
  {
    vtkNew<vtkPolyDataReader> surface;
    surface->SetFileName(path.c_str());
    vtkNew<vtkUnstructuredGridReader> grid;
    grid->SetFileName(path.c_str());
    if (surface->IsFilePolyData())
    {
      mesh = ReadLegacy(surface.Get(), path, this->UserMessages);
      frame = FrameOfHeader(surface->GetHeader());
    }
    else if (grid->IsFileUnstructuredGrid())
    {
      mesh = ReadLegacy(grid.Get(), path, this->UserMessages);
      frame = FrameOfHeader(grid->GetHeader());
    }
  }
  else if (extension == ".stl")
  {
    vtkNew<vtkSTLReader> reader;
    mesh = Read(reader.Get(), path, this->UserMessages);
    frame = FrameOfHeader(reader->GetHeader());
  }
  else if (extension == ".ply")
  {
    vtkNew<vtkPLYReader> reader;
    mesh = Read(reader.Get(), path, this->UserMessages);
    for (vtkIdType i = 0; frame < 0 && i < reader->GetComments()->GetNumberOfValues(); ++i)
    {
      frame = FrameOfHeader(reader->GetComments()->GetValue(i).c_str());
    }
  }
  else if (extension == ".obj")
  {
    vtkNew<vtkOBJReader> reader;
    mesh = Read(reader.Get(), path, this->UserMessages);
    frame = FrameOfHeader(reader->GetComment());
  }
  return mesh;
}

// --- Writing -----------------------------------------------------------------------------------

int vtkMRMLModelStorageNode::WriteDataInternal(vtkMRMLNode* refNode)
{
  vtkSmartPointer<vtkPointSet> mesh = static_cast<vtkMRMLModelNode*>(refNode)->GetMesh();
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    this->SetWriteStateSkippedNoData();
    return 1;
  }
  const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  if (this->CoordinateSystem == CoordinateSystemLPS)
  {
    ConvertBetweenRASAndLPS(mesh, copy);
  }
  else
  {
    copy->ShallowCopy(mesh);
  }
  return this->WriteMesh(copy, this->GetTemporaryFileName()) ? 1 : 0;
}

bool vtkMRMLModelStorageNode::WriteMesh(vtkPointSet* mesh, const std::string& path)
{
  const std::string extension = GetLowercaseExtensionFromFileName(path);
  const std::string frame = GetCoordinateSystemAsString(this->CoordinateSystem);
  const std::string header = "FaceToBone output. SPACE=" + frame;
  const bool surface = mesh->IsA("vtkPolyData");
  if ((extension == ".vtp" && surface) || (extension == ".vtu" && !surface))
  {
    vtkNew<vtkStringArray> space;
    space->SetName("SPACE");
    space->InsertNextValue(frame);
    vtkNew<vtkFieldData> fields; // the model shares its own
    fields->ShallowCopy(mesh->GetFieldData());
    fields->AddArray(space);
    mesh->SetFieldData(fields);
    vtkSmartPointer<vtkXMLWriter> writer;
    if (surface)
    {
      writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
    }
    else
    {
      writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
    }
    writer->SetCompressorType(this->UseCompression ? vtkXMLWriter::ZLIB : vtkXMLWriter::NONE);
    writer->SetDataModeToAppended();
    writer->SetEncodeAppendedData(this->UseCompression);
    return Write(writer.Get(), mesh, path, this->UserMessages);
  }
  if (extension == ".vtk")
  {
    vtkSmartPointer<vtkDataWriter> writer;
    if (surface)
    {
      writer = vtkSmartPointer<vtkPolyDataWriter>::New();
    }
    else
    {
      writer = vtkSmartPointer<vtkUnstructuredGridWriter>::New();
    }
    writer->SetFileVersion(42); // what others than VTK 9 read
    writer->SetFileType(VTK_BINARY);
    writer->SetHeader(header.c_str());
    return Write(writer.Get(), mesh, path, this->UserMessages);
  }
  if (!surface)
  {
    return false;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->Update();
  if (extension == ".stl")
  {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    writer->SetHeader(header.c_str());
    return Write(writer.Get(), triangles->GetOutput(), path, this->UserMessages);
  }
  if (extension == ".ply")
  {
    vtkNew<vtkPLYWriter> writer;
    writer->SetFileTypeToBinary();
    writer->AddComment("SPACE=" + frame);
    return Write(writer.Get(), triangles->GetOutput(), path, this->UserMessages);
  }
  if (extension == ".obj" && this->CoordinateSystem == CoordinateSystemLPS)
  {
    // VTK's writer has no comment for the frame: LPS, which Slicer assumes.
    return Write(vtkNew<vtkOBJWriter>().Get(), triangles->GetOutput(), path, this->UserMessages);
  }
  return false;
}
