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

#include <cmath>
#include <optional>

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

/// The grid of a file; null where VTK finds it damaged.
vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::filesystem::path& path)
{
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return messages.error() ? nullptr : reader->GetOutput();
}

/// The array of that name; null unless it has so many components and tuples.
vtkDataArray* array_of(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfComponents() == components &&
                 array->GetNumberOfTuples() == tuples
             ? array
             : nullptr;
}

/// A whole number of an array, from `first` to `last`; nothing if it is another.
std::optional<int> whole_number(vtkDataArray* array, vtkIdType at, int first, int last)
{
  const double value = array->GetTuple1(at);
  if (!(value >= first && value <= last) || value != std::floor(value))
    return std::nullopt;
  return static_cast<int>(value);
}

/// False where a node's position, boundary or fragment is none.
bool take_nodes(vtkUnstructuredGrid* grid, MixedMesh& mesh)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  vtkDataArray* boundary = array_of(grid->GetPointData(), "boundary", 1, count);
  vtkDataArray* fragment = array_of(grid->GetPointData(), "fragment", 1, count);
  if (!boundary || !fragment)
    return false;
  for (vtkIdType n = 0; n < count; ++n)
  {
    const Vec3 p = flipped(Vec3(grid->GetPoint(n)));
    const auto part = whole_number(boundary, n, 0, static_cast<int>(Boundary::Crop));
    const auto owner = whole_number(fragment, n, -1, static_cast<int>(mesh.fragments.size()) - 1);
    if (!p.allFinite() || !part || !owner)
      return false;
    mesh.X.push_back(p);
    mesh.node_boundary.push_back(static_cast<Boundary>(*part));
    mesh.node_fragment.push_back(*owner);
  }
  return true;
}

/// The corners of a cell; false unless there are as many, each of them a node.
template <std::size_t N>
bool take_corners(vtkUnstructuredGrid* grid, vtkIdType cell, std::vector<std::array<int, N>>& cells)
{
  vtkIdType count = 0;
  const vtkIdType* nodes = nullptr;
  grid->GetCellPoints(cell, count, nodes);
  if (count != static_cast<vtkIdType>(N))
    return false;
  std::array<int, N>& corners = cells.emplace_back();
  for (std::size_t i = 0; i < N; ++i)
  {
    if (nodes[i] < 0 || nodes[i] >= grid->GetNumberOfPoints())
      return false;
    corners[i] = static_cast<int>(nodes[i]);
  }
  return true;
}

/// False where a cell is neither prism nor tetrahedron of known tissue and nodes.
bool take_elements(vtkUnstructuredGrid* grid, MixedMesh& mesh)
{
  vtkDataArray* tissue = array_of(grid->GetCellData(), "tissue", 1, grid->GetNumberOfCells());
  if (!tissue)
    return false;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const auto of = whole_number(tissue, c, 0, tissue_count - 1);
    const int type = grid->GetCellType(c);
    if (!of || (type != VTK_WEDGE && type != VTK_TETRA) ||
        !(type == VTK_WEDGE ? take_corners(grid, c, mesh.prisms)
                            : take_corners(grid, c, mesh.tets)))
      return false;
    if (type == VTK_TETRA)
      mesh.tet_tissue.push_back(static_cast<Tissue>(*of));
  }
  return true;
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
  const vtkSmartPointer<vtkUnstructuredGrid> grid = read_grid(path);
  if (!grid)
    refuse(path);
  MixedMesh mesh;
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("fragments"));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    mesh.fragments.push_back(names->GetValue(i));
  if (!take_nodes(grid, mesh) || !take_elements(grid, mesh))
    refuse(path);
  return mesh;
}

std::vector<Vec3> read_node_vectors(const std::filesystem::path& path, const std::string& name)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = read_grid(path);
  if (!grid || grid->GetNumberOfPoints() == 0)
    refuse(path);
  vtkDataArray* array = array_of(grid->GetPointData(), name.c_str(), 3, grid->GetNumberOfPoints());
  std::vector<Vec3> vectors;
  for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
    vectors.push_back(flipped(Vec3(array->GetTuple3(n))));
  return vectors;
}

} // namespace f2b
