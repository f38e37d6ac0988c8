#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <filesystem>

/// How are distance maps and labels kept? `.nrrd`, LPS geometry, axes R, A, S of the grid.
namespace f2b
{

void write_grid(const std::filesystem::path& path, const ScalarGrid& grid);
void write_grid(const std::filesystem::path& path, const LabelGrid& grid);
/// Reads what write_grid wrote; throws Error on anything else.
ScalarGrid read_scalar_grid(const std::filesystem::path& path);
LabelGrid read_label_grid(const std::filesystem::path& path);

} // namespace f2b
