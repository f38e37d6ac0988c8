#pragma once

#include "Core/material/material_set.hpp"

#include <nlohmann/json_fwd.hpp>

/// Which laws does a material file give the tissues?
namespace f2b
{

/// Reads a material set: the name of one that FaceToBone carries, such as `table1-stable`, or a
/// file.
///
/// JSON: `units` (MPa, kPa, Pa or gf/mm^2) of the coefficients, `volumetric_law` (quadratic, log or
/// barrier, see VolumetricLaw), `tissues` with `skin`, `fat` and `muscle`; `name`, `description`,
/// `reference`, `stable_range` and `fit` are for the reader. A tissue has `law`, `poisson_ratio` in
/// (-1, 0.4999] and the law's coefficients: `youngs_modulus` (linear), `c10` (neo-hookean), `c10`
/// and `c01` (mooney-rivlin), `c1`, `c2` and `c3` (yeoh); `units` in a tissue are its own. Stiffness
/// at rest must be positive; a law that loses stability further out is read, and guarded while
/// solving (stability.hpp). Throws Error naming file and key.
MaterialSet read_materials(const std::string& name_or_path);

/// A law as a tissue's entry of a material file, in MPa with ten digits.
nlohmann::ordered_json tissue_entry(const Law& law);

} // namespace f2b
