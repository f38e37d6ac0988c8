#pragma once

#include "Core/geometry/vectors.hpp"

#include <filesystem>

/// How is a fragment's movement handed to Slicer and ITK?
namespace f2b
{

/// Writes a rigid movement as an ITK affine transform, `.tfm` or `.h5`.
///
/// ITK transforms map points of the output space to the input space and live in LPS. So the file
/// holds the inverse of the movement, in LPS: Slicer, which reads transforms so, then shows a
/// linear transform node whose "to parent" matrix is `rest_to_planned_ras`.
void write_transform(const std::filesystem::path& path, const Mat4& rest_to_planned_ras);

/// The movement (rest to planned, RAS) that a file written so holds.
Mat4 read_transform(const std::filesystem::path& path);

} // namespace f2b
