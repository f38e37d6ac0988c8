#include "Core/geometry/bone_overlap.hpp"

#include "Core/geometry/osteotomy.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

/// Points of the cut faces: fragment samples with a neighbour in the bone that stays.
std::vector<Vec3> cut_face(const LabelGrid& labels, unsigned char fragment)
{
  std::vector<Vec3> points;
  const Eigen::Vector3i n = labels.size;
  for (int k = 1; k + 1 < n.z(); ++k)
    for (int j = 1; j + 1 < n.y(); ++j)
      for (int i = 1; i + 1 < n.x(); ++i)
      {
        if (labels.values[labels.index(i, j, k)] != fragment)
          continue;
        auto stays = [&](int di, int dj, int dk)
        { return labels.values[labels.index(i + di, j + dj, k + dk)] == BonePartition::uncut; };
        if (stays(1, 0, 0) || stays(-1, 0, 0) || stays(0, 1, 0) || stays(0, -1, 0) ||
            stays(0, 0, 1) || stays(0, 0, -1))
          points.push_back(labels.position(i, j, k));
      }
  return points;
}

/// Depth of a point below the surface of the bone that stays, its cut faces included.
double depth_below(const Vec3& p, const ScalarGrid& bone, const std::vector<Vec3>& face)
{
  const double below_surface = -bone.value(p);
  if (below_surface <= 0)
    return 0;
  double squared = below_surface * below_surface;
  for (const Vec3& point : face)
    squared = std::min(squared, (point - p).squaredNorm());
  return std::sqrt(squared);
}

} // namespace

BoneOverlap overlap_with_uncut_bone(const ScalarGrid& bone, const LabelGrid& labels,
                                    unsigned char fragment, const RigidMotion& motion)
{
  BoneOverlap overlap;
  const double voxel_mm3 = bone.spacing * bone.spacing * bone.spacing;
  const std::vector<Vec3> face = cut_face(labels, fragment);
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
        const double depth = depth_below(p, bone, face);
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
