#pragma once

#include "Core/mesh/mixed_mesh.hpp"

/// How far is the tissue stretched?
namespace f2b
{

struct TissueStretch
{
  double p99 = 1; ///< 99 % of the tissue's volume is stretched by no more than this factor
  double max = 1; ///< largest principal stretch of a tetrahedron
  Vec3 where = Vec3::Zero(); ///< its rest centroid [mm, RAS]
};

/// Largest principal stretches of the tetrahedra between rest and current positions.
TissueStretch tissue_stretch(const MixedMesh& mesh, const std::vector<Vec3>& x);

} // namespace f2b
