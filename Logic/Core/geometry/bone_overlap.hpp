#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Core/geometry/scalar_grid.hpp"

/// Does a moved fragment run into bone that stays?
namespace f2b
{

struct BoneOverlap
{
  double volume_mm3 = 0;
  double depth_mm = 0; ///< how deep the fragment reaches below the surface of the bone that stays
  Vec3 deepest = Vec3::Zero(); ///< where [mm, RAS]
};

/// \param bone      signed distance of the actual bone, negative inside
/// \param labels    BonePartition::labels on the same lattice
/// \param fragment  the moved fragment's label
BoneOverlap overlap_with_uncut_bone(const ScalarGrid& bone, const LabelGrid& labels,
                                    unsigned char fragment, const RigidMotion& motion);

} // namespace f2b
