#pragma once

#include "Core/assembly/discretization.hpp"
#include "Core/material/stability.hpp"

/// Where has a deformed mesh left the range in which its tissues' laws are stable?
namespace f2b
{

/// Asks the guard at every quadrature point; a point's place is the centre of its element at rest.
/// \param x  control vectors [mm]
StabilityReport examine_stability(const Discretization& tissue, const MaterialSet& materials,
                                  const std::vector<Vec3>& x);

} // namespace f2b
