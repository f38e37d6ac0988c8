#pragma once

#include "Core/geometry/cut_face.hpp"
#include "Core/geometry/rigid_motion.hpp"

/// Does a moved part of the bone run into another?
namespace f2b
{

/// A fragment, or the bone that stays, and where it goes.
struct MovedPart
{
  unsigned char label = BonePartition::uncut;
  RigidMotion motion; ///< at rest by default
};

/// The motion of one part as the other sees it, which it takes to be at rest.
RigidMotion seen_from(const MovedPart& other, const MovedPart& part);

struct BoneOverlap
{
  double volume_mm3 = 0;
  double depth_mm = 0; ///< how deep the part reaches below the surface of the other, cuts included
  Vec3 deepest = Vec3::Zero(); ///< where, after the movement [mm, RAS]
};

/// Counts the part's bone samples that lie in the other's bone. What the saw takes away is in
/// neither: a cut may close by its kerf.
BoneOverlap overlap_between(const CutBone& cut, const MovedPart& part, const MovedPart& other);

} // namespace f2b
