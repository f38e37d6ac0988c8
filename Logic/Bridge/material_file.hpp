#pragma once

#include "Core/material/material_set.hpp"

#include <filesystem>

/// Which laws does a material file give the tissues?
namespace f2b
{

/// Reads a material set: the name of one that FaceToBone carries (`table1-stable`), or a file.
///
/// JSON: `name`, `units` (MPa), `volumetric_law` (barrier), `tissues` with `skin`, `fat` and
/// `muscle`, each `law` (yeoh), `c1`, `c2`, `c3`, `poisson_ratio`. Throws Error naming file and
/// key.
MaterialSet read_materials(const std::string& name_or_path);

} // namespace f2b
