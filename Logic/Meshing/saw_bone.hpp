#pragma once

#include "Core/geometry/vectors.hpp"

/// What is left of a bone when saws have gone through it?
namespace f2b
{

/// A bone without what the saws took. Where nothing was cut the triangles are those of before.
struct SawnBone
{
  TriangleMesh surface;             ///< closed, faces outwards; the shells of all pieces [mm]
  std::vector<int> shell;           ///< per triangle
  std::vector<double> shell_volume; ///< [mm^3]; negative: the wall of a cavity
  double bone_mm3 = 0;              ///< before
  double kerf_mm3 = 0;              ///< what the saws took, measured on its own surface
  bool met = false;                 ///< did a saw meet bone?

  double left_mm3() const;
  /// |left + kerf - bone| / bone.
  double imbalance() const;
};

/// Takes the saws' blades away from a bone, exactly: a boolean difference with exact predicates
/// (CGAL's corefinement), so that cut faces are plane and pieces fit to one another.
///
/// Blades may end inside bone, cross each other or miss. Blades that lie in one another's faces are
/// parted by less than a micrometre each.
/// \param bone    closed and manifold, faces outwards, does not cross itself where a blade meets it
/// \param blades  closed, faces outwards (`blade_of`)
/// Throws Error (bad input) where `bone` is open or not manifold, Error (numerical) where blades
/// moved by up to 0.1 mm still give no closed surface with balanced volume.
SawnBone saw_bone(const TriangleMesh& bone, const std::vector<TriangleMesh>& blades);

/// The triangles of some shells, with their points only.
TriangleMesh shells_of(const SawnBone& sawn, const std::vector<char>& wanted);

} // namespace f2b
