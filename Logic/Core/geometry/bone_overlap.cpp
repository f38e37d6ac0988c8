#include "Core/geometry/bone_overlap.hpp"

#include <algorithm>

namespace f2b
{

namespace
{

/// Share of a voxel inside a face that is so many voxels away from its centre.
double inner_share(double distance)
{
  return std::clamp(0.5 + distance, 0.0, 1.0);
}

} // namespace

RigidMotion seen_from(const MovedPart& other, const MovedPart& part)
{
  // M = B^-1 A, about the origin
  const Mat3 back = other.motion.rotation.transpose();
  RigidMotion relative;
  relative.rotation = back * part.motion.rotation;
  relative.translation =
      back * (part.motion.apply(Vec3::Zero()) - other.motion.apply(Vec3::Zero()));
  return relative;
}

BoneOverlap overlap_between(const CutBone& cut, const MovedPart& part, const MovedPart& other)
{
  BoneOverlap overlap;
  const double spacing = cut.bone.spacing, voxel_mm3 = spacing * spacing * spacing;
  const RigidMotion motion = seen_from(other, part);
  const std::vector<CutPoint> own = cuts_of(cut, part.label), face = cuts_of(cut, other.label);
  std::size_t voxel = 0;
  for (int k = 0; k < cut.bone.size.z(); ++k)
    for (int j = 0; j < cut.bone.size.y(); ++j)
      for (int i = 0; i < cut.bone.size.x(); ++i, ++voxel)
      {
        if (cut.parts.values[voxel] != part.label || cut.bone.values[voxel] >= 0)
          continue;
        const Vec3 rest = cut.bone.position(i, j, k), p = motion.apply(rest);
        if (cut.parts.nearest(p) != other.label || cut.bone.value(p) >= 0)
          continue;
        const double inside = distance_to_cut(rest, own, spacing);
        const double below = std::min(-cut.bone.value(p), distance_to_cut(p, face, spacing));
        // the saw's faces pass through voxels: those count with the part that is inside of both
        overlap.volume_mm3 +=
            voxel_mm3 * inner_share(inside / spacing) * inner_share(below / spacing);
        const double depth = inside > -0.5 * spacing ? below + std::min(inside, 0.0) : 0;
        if (depth > overlap.depth_mm)
        {
          overlap.depth_mm = depth;
          overlap.deepest = other.motion.apply(p);
        }
      }
  return overlap;
}

} // namespace f2b
