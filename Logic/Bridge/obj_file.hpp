#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

/// How are Wavefront .obj files read without changing their vertices?
namespace f2b
{

struct ObjFile
{
  vtkSmartPointer<vtkPolyData> surface; ///< every `v` in the file's order; every `f` as a polygon
  std::string comments;                 ///< the lines that begin with #
};

/// VTK's own reader splits vertices at seams of texture and normals, and drops the unused ones; a
/// skin that went through a sculpting program would lose its correspondence. Throws Error naming
/// the line.
ObjFile read_obj(const std::filesystem::path& path);

} // namespace f2b
