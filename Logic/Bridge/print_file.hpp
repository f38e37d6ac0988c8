#pragma once

#include "Core/geometry/vectors.hpp"

#include <string>

/// How does a surface leave for printing, without a coordinate losing more than 1e-9 mm?
///
/// Both say `SPACE=LPS`, as Slicer writes it, and are in LPS. Usual STL files are single precision:
/// 1e-5 mm at a head's size.
namespace f2b
{

/// Text STL with nine decimals.
std::string stl_text(const TriangleMesh& surface_ras);
/// Binary PLY with double positions.
std::string ply_bytes(const TriangleMesh& surface_ras);

} // namespace f2b
