#include "Bridge/mesh_file.hpp"

#include "Bridge/vtk_messages.hpp"
#include "Core/error.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace f2b
{
namespace
{

Vec3 flipped(const Vec3& p)
{
  return {-p.x(), -p.y(), p.z()};
}

template <std::size_t N>
void insert_cell(vtkUnstructuredGrid* grid, int type, const std::array<int, N>& nodes)
{
  vtkIdType ids[N];
  for (std::size_t i = 0; i < N; ++i)
    ids[i] = nodes[i];
  grid->InsertNextCell(type, static_cast<vtkIdType>(N), ids);
}

template <class Value>
vtkSmartPointer<vtkIntArray> int_array(const char* name, const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  for (const Value& value : values)
    array->InsertNextValue(static_cast<int>(value));
  return array;
}

void add_string(vtkUnstructuredGrid* grid, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
    array->InsertNextValue(value);
  grid->GetFieldData()->AddArray(array);
}

vtkSmartPointer<vtkUnstructuredGrid> to_grid(const MixedMesh& mesh)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : mesh.X)
    points->InsertNextPoint(flipped(p).data());
  grid->SetPoints(points);
  std::vector<Tissue> tissue(mesh.prisms.size(), Tissue::Skin);
  tissue.insert(tissue.end(), mesh.tet_tissue.begin(), mesh.tet_tissue.end());
  for (const auto& prism : mesh.prisms)
    insert_cell(grid, VTK_WEDGE, prism);
  for (const auto& tet : mesh.tets)
    insert_cell(grid, VTK_TETRA, tet);
  grid->GetCellData()->AddArray(int_array("tissue", tissue));
  grid->GetPointData()->AddArray(int_array("boundary", mesh.node_boundary));
  grid->GetPointData()->AddArray(int_array("fragment", mesh.node_fragment));
  add_string(grid, "fragments", mesh.fragments);
  add_string(grid, "SPACE", {"LPS"});
  return grid;
}

[[noreturn]] void refuse(const std::filesystem::path& path)
{
  throw Error(path.string(), "it is not a mesh that FaceToBone wrote, or it is damaged",
              "make the mesh anew (facetobone mesh)");
}

} // namespace

void write_mesh(const std::filesystem::path& path, const MixedMesh& mesh,
                const std::vector<std::pair<std::string, std::vector<Vec3>>>& displacements)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = to_grid(mesh);
  for (const auto& [name, vectors] : displacements)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(3);
    for (const Vec3& v : vectors)
      array->InsertNextTuple(flipped(v).data());
    grid->GetPointData()->AddArray(array);
  }
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(grid);
  if (!writer->Write() || writer->GetErrorCode() != 0 || messages.error())
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
}

MixedMesh read_mesh(const std::filesystem::path& path)
{
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  vtkDataArray* tissue = grid->GetCellData()->GetArray("tissue");
  vtkDataArray* boundary = grid->GetPointData()->GetArray("boundary");
  vtkDataArray* fragment = grid->GetPointData()->GetArray("fragment");
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("fragments"));
  if (messages.error() || !tissue || !boundary || !fragment)
    refuse(path);

  MixedMesh mesh;
  for (vtkIdType n = 0; n < grid->GetNumberOfPoints(); ++n)
  {
    mesh.X.push_back(flipped(Vec3(grid->GetPoint(n))));
    mesh.node_boundary.push_back(static_cast<Boundary>(static_cast<int>(boundary->GetTuple1(n))));
    mesh.node_fragment.push_back(static_cast<int>(fragment->GetTuple1(n)));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, ids);
    auto id = [&](vtkIdType i) { return static_cast<int>(ids->GetId(i)); };
    if (grid->GetCellType(c) == VTK_WEDGE)
      mesh.prisms.push_back({id(0), id(1), id(2), id(3), id(4), id(5)});
    else if (grid->GetCellType(c) == VTK_TETRA)
    {
      mesh.tets.push_back({id(0), id(1), id(2), id(3)});
      mesh.tet_tissue.push_back(static_cast<Tissue>(static_cast<int>(tissue->GetTuple1(c))));
    }
    else
      refuse(path);
  }
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    mesh.fragments.push_back(names->GetValue(i));
  return mesh;
}

std::vector<Vec3> read_node_vectors(const std::filesystem::path& path, const std::string& name)
{
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  if (messages.error() || grid->GetNumberOfPoints() == 0)
    refuse(path);
  vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
  std::vector<Vec3> vectors;
  for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
    vectors.push_back(flipped(Vec3(array->GetTuple3(n))));
  return vectors;
}

} // namespace f2b
