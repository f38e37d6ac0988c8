#pragma once

#include "Core/geometry/vectors.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

/// How do surfaces travel between Core, VTK and files? RAS in memory; LPS in files, as in Slicer.
namespace f2b
{

TriangleMesh to_triangle_mesh(vtkPolyData* surface);
vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh);
/// The same surface with other point positions; point arrays are kept.
vtkSmartPointer<vtkPolyData> with_points(vtkPolyData* surface, const std::vector<Vec3>& points);
std::vector<Vec3> points_of(vtkPolyData* surface);

void add_point_array(vtkPolyData* surface, const std::string& name,
                     const std::vector<double>& values);
void add_point_array(vtkPolyData* surface, const std::string& name,
                     const std::vector<Vec3>& values);
std::vector<double> point_scalars(vtkPolyData* surface, const std::string& name);
std::vector<Vec3> point_vectors(vtkPolyData* surface, const std::string& name);

/// Reads .vtp, .ply, .obj, .stl or .vtk. The frame is what the file says (SPACE=RAS or LPS), else
/// LPS. Vector point arrays are in RAS. Throws Error on unreadable files, files without triangles,
/// non-finite points.
vtkSmartPointer<vtkPolyData> read_surface(const std::filesystem::path& path);
/// Writes .vtp, or .ply for programs that sculpt, in LPS, and says so in the file. A .vtp keeps
/// arrays and double precision; a .ply holds positions in single precision and triangles.
void write_surface(const std::filesystem::path& path, vtkPolyData* surface);

} // namespace f2b
