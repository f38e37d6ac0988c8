#pragma once

#include "Core/geometry/scalar_grid.hpp"
#include "Meshing/shell_domain.hpp"

/// A head of smoothly joined ellipsoids with nose, lips and chin, its bone, and a cavity in the
/// bone below its closed surface; sampled on a lattice. Lengths in mm, RAS, face towards +A.
namespace f2b::testing
{

struct AnalyticHead
{
  ScalarGrid skin, closed_bone, bone, hu;

  ShellFields fields() const { return {skin, closed_bone, bone, hu}; }
};

AnalyticHead analytic_head(double spacing_mm);

/// The face of it.
RegionBox face_region();

/// Centre of the cavity's opening in the bone's surface.
Vec3 cavity_centre();

} // namespace f2b::testing
