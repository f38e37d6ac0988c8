#include "Core/geometry/bone_overlap.hpp"

#include "Core/geometry/osteotomy.hpp"

namespace f2b
{

BoneOverlap overlap_with_uncut_bone(const ScalarGrid& bone, const LabelGrid& labels,
                                    unsigned char fragment, const RigidMotion& motion)
{
  BoneOverlap overlap;
  const double voxel_mm3 = bone.spacing * bone.spacing * bone.spacing;
  std::size_t voxel = 0;
  for (int k = 0; k < bone.size.z(); ++k)
    for (int j = 0; j < bone.size.y(); ++j)
      for (int i = 0; i < bone.size.x(); ++i, ++voxel)
      {
        if (labels.values[voxel] != fragment || bone.values[voxel] >= 0)
          continue;
        const Vec3 p = motion.apply(bone.position(i, j, k));
        if (labels.nearest(p) != BonePartition::uncut)
          continue;
        const double depth = -bone.value(p);
        overlap.volume_mm3 += depth > 0 ? voxel_mm3 : 0;
        if (depth > overlap.depth_mm)
        {
          overlap.depth_mm = depth;
          overlap.deepest = p;
        }
      }
  return overlap;
}

} // namespace f2b
