#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

/// How are Stanford .ply files read, whatever their bytes?
namespace f2b
{

struct PlyFile
{
  vtkSmartPointer<vtkPolyData>
      surface;          ///< every vertex in the file's order; every face as a polygon
  std::string comments; ///< the lines that begin with `comment`
};

/// Text and binary of either byte order. Other elements and properties, such as colours, are read
/// over. VTK's own reader trusts the header: files that were damaged or cut short take the program
/// with them. Throws Error where the header is not understood, where the file ends before what it
/// announces, and for a face with a vertex that is not there.
PlyFile read_ply(const std::filesystem::path& path);

} // namespace f2b
