#include "Bridge/vtk_surface.hpp"

#include "Bridge/obj_file.hpp"
#include "Bridge/ply_file.hpp"
#include "Bridge/vtk_messages.hpp"
#include "Core/error.hpp"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

namespace f2b
{

TriangleMesh to_triangle_mesh(vtkPolyData* surface)
{
  TriangleMesh mesh;
  mesh.points = points_of(surface);
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners);)
    if (corners->GetNumberOfIds() == 3)
      mesh.triangles.push_back({static_cast<int>(corners->GetId(0)),
                                static_cast<int>(corners->GetId(1)),
                                static_cast<int>(corners->GetId(2))});
  return mesh;
}

namespace
{

void copy_vectors(const std::vector<Vec3>& vectors, double* to)
{
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  if (!vectors.empty())
    std::copy_n(vectors.front().data(), 3 * vectors.size(), to);
}

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<Vec3>& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  copy_vectors(points, static_cast<double*>(result->GetVoidPointer(0)));
  return result;
}

} // namespace

vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(vtk_points(mesh.points));
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles)
    cells->InsertNextCell({t[0], t[1], t[2]});
  surface->SetPolys(cells);
  return surface;
}

vtkSmartPointer<vtkPolyData> with_points(vtkPolyData* surface, const std::vector<Vec3>& points)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  result->SetPoints(vtk_points(points));
  return result;
}

std::vector<Vec3> points_of(vtkPolyData* surface)
{
  std::vector<Vec3> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  return points;
}

void add_point_array(vtkPolyData* surface, const std::string& name,
                     const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  surface->GetPointData()->AddArray(array);
}

void add_point_array(vtkPolyData* surface, const std::string& name, const std::vector<Vec3>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  copy_vectors(values, array->GetPointer(0));
  surface->GetPointData()->AddArray(array);
}

namespace
{

vtkDataArray* array_of(vtkPolyData* surface, const std::string& name, int components)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != components)
    throw Error("surface",
                "it has no point array '" + name + "' of " + std::to_string(components) +
                    " components",
                "make the case's step anew");
  return array;
}

} // namespace

std::vector<double> point_scalars(vtkPolyData* surface, const std::string& name)
{
  vtkDataArray* array = array_of(surface, name, 1);
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  return values;
}

std::vector<Vec3> point_vectors(vtkPolyData* surface, const std::string& name)
{
  vtkDataArray* array = array_of(surface, name, 3);
  std::vector<Vec3> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    array->GetTuple(static_cast<vtkIdType>(i), values[i].data());
  return values;
}

namespace
{

constexpr const char* space_key = "SPACE";

/// Which frame a text such as "SPACE=RAS" names; empty if none.
std::string frame_in(const char* text)
{
  const std::string line = text ? text : "";
  const auto at = line.find("SPACE=");
  return at == std::string::npos ? "" : line.substr(at + 6, 3);
}

struct LoadedSurface
{
  vtkSmartPointer<vtkPolyData> surface;
  std::string frame;
};

/// Runs a reader, taking VTK's error output as an exception.
template <class Reader>
vtkSmartPointer<vtkPolyData> run(Reader* reader, const std::filesystem::path& path)
{
  const VtkMessages messages;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (messages.error())
    throw Error(path.string(), "it cannot be read as a surface",
                "check that the file is whole and of the kind that its name says");
  return reader->GetOutput();
}

LoadedSurface load(const std::filesystem::path& path)
{
  std::string kind = path.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (kind == ".vtp")
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    LoadedSurface loaded{run(reader.Get(), path), ""};
    auto* space =
        vtkStringArray::SafeDownCast(loaded.surface->GetFieldData()->GetAbstractArray(space_key));
    loaded.frame = space && space->GetNumberOfValues() ? std::string(space->GetValue(0)) : "";
    return loaded;
  }
  if (kind == ".ply")
  {
    const PlyFile ply = read_ply(path);
    return {ply.surface, frame_in(ply.comments.c_str())};
  }
  if (kind == ".obj")
  {
    const ObjFile obj = read_obj(path);
    return {obj.surface, frame_in(obj.comments.c_str())};
  }
  if (kind == ".stl")
  {
    vtkNew<vtkSTLReader> reader;
    LoadedSurface loaded{run(reader.Get(), path), ""};
    loaded.frame = frame_in(reader->GetHeader());
    return loaded;
  }
  if (kind == ".vtk")
  {
    vtkNew<vtkPolyDataReader> reader;
    LoadedSurface loaded{run(reader.Get(), path), ""};
    loaded.frame = frame_in(reader->GetHeader());
    return loaded;
  }
  throw Error(path.string(), "its ending '" + kind + "' is not that of a surface",
              "use .vtp, .ply, .obj, .stl or .vtk");
}

bool is_real(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

/// Turns LPS into RAS or back, positions and vector arrays; the input stays as it is.
vtkSmartPointer<vtkPolyData> flipped(vtkPolyData* surface)
{
  std::vector<Vec3> points = points_of(surface);
  for (Vec3& p : points)
    p = Vec3(-p.x(), -p.y(), p.z());
  vtkSmartPointer<vtkPolyData> result = with_points(surface, points);
  vtkNew<vtkPolyData> vectors; // keeps the arrays' names and order
  vectors->GetPointData()->ShallowCopy(surface->GetPointData());
  for (int a = 0; a < vectors->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = vectors->GetPointData()->GetArray(a);
    // triples of integers are colours
    if (!array || !array->GetName() || array->GetNumberOfComponents() != 3 || !is_real(array))
      continue;
    std::vector<Vec3> values = point_vectors(surface, array->GetName());
    for (Vec3& v : values)
      v = Vec3(-v.x(), -v.y(), v.z());
    add_point_array(result, array->GetName(), values);
  }
  return result;
}

} // namespace

vtkSmartPointer<vtkPolyData> read_surface(const std::filesystem::path& path)
{
  if (!std::filesystem::is_regular_file(path))
    throw Error(path.string(), "there is no such file", "check the path");
  const LoadedSurface loaded = load(path);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(loaded.surface);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkSmartPointer<vtkPolyData> surface = triangles->GetOutput();
  if (surface->GetNumberOfPolys() == 0)
    throw Error(path.string(), "it holds no triangles", "give a triangulated surface");
  for (const Vec3& p : points_of(surface))
    if (!p.allFinite())
      throw Error(path.string(),
                  "it has a vertex whose coordinates are not finite (NaN or infinite)",
                  "repair the mesh in the program that wrote it");
  if (loaded.frame != "RAS")
    surface = flipped(surface);
  surface->GetFieldData()->RemoveArray(space_key);
  return surface;
}

namespace
{

void write_vtp(const std::filesystem::path& path, vtkPolyData* in_lps)
{
  vtkNew<vtkStringArray> space;
  space->SetName(space_key);
  space->InsertNextValue("LPS");
  in_lps->GetFieldData()->AddArray(space);
  // of a surface's arrays Slicer turns the active vectors alone between LPS and RAS
  in_lps->GetPointData()->SetActiveVectors("displacement");
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(in_lps);
  if (!writer->Write() || writer->GetErrorCode() != 0 || messages.error())
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
}

void write_ply(const std::filesystem::path& path, vtkPolyData* in_lps)
{
  const VtkMessages messages;
  vtkNew<vtkPLYWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(in_lps);
  writer->AddComment("SPACE=LPS");
  if (!writer->Write() || writer->GetErrorCode() != 0 || messages.error())
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
}

} // namespace

void write_surface(const std::filesystem::path& path, vtkPolyData* surface)
{
  const vtkSmartPointer<vtkPolyData> in_lps = flipped(surface);
  if (path.extension() == ".ply")
    write_ply(path, in_lps);
  else
    write_vtp(path, in_lps);
}

} // namespace f2b
