#pragma once

#include "Core/material/law_fit.hpp"

#include <filesystem>

/// Which curve of stress does a text file hold?
namespace f2b
{

/// Reads comma-, semicolon- or tab-separated text of two columns.
///
/// A comment `# test: uniaxial`, `equibiaxial` or `simple-shear` says how the specimen was loaded;
/// other lines that begin with # are skipped. The header line names quantity and unit: `stretch`,
/// `strain` (nominal, without unit), `strain_percent`, or `shear` (the amount, in a simple-shear
/// test); then `nominal_stress_UNIT` or `true_stress_UNIT` with MPa, kPa, Pa or gf/mm^2. True
/// stress becomes nominal as for matter that keeps its volume. Throws Error naming file and line.
StressCurve read_stress_curve(const std::filesystem::path& path);

} // namespace f2b
