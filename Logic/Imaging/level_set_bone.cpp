#include "Imaging/level_set_bone.hpp"

#include "Imaging/signed_distance.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

std::array<int, 3> size_of(const ScalarGrid& grid)
{
  return {grid.size.x(), grid.size.y(), grid.size.z()};
}

void add_balls(ScalarGrid& level, const std::vector<Vec3>& centers, double radius_mm)
{
  const int reach = static_cast<int>(radius_mm / level.spacing) + 2;
  for (const Vec3& center : centers)
  {
    const Eigen::Vector3i middle =
        ((center - level.origin) / level.spacing).array().round().matrix().cast<int>();
    for (int k = -reach; k <= reach; ++k)
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
        {
          const Eigen::Vector3i v = middle + Eigen::Vector3i(i, j, k);
          if ((v.array() < 0).any() || (v.array() >= level.size.array()).any())
            continue;
          float& value = level.values[level.index(v.x(), v.y(), v.z())];
          const double ball = (level.position(v.x(), v.y(), v.z()) - center).norm() - radius_mm;
          value = std::min(value, static_cast<float>(ball));
        }
  }
}

} // namespace

ScalarGrid level_set_bone(const ScalarGrid& hu, const HeadMask& head,
                          const TissueSurfaceOptions& surfaces, const LevelSetBoneOptions& options)
{
  ScalarGrid smooth = hu;
  smooth.values = blurred(size_of(hu), hu.spacing, hu.values, options.contour.blur_mm);
  // streaks, small pieces and the holder go as they do with the threshold
  ScalarGrid start = bone_distance(smooth, head, surfaces);
  add_balls(start, options.seeds_ras, options.seed_radius_mm);
  ScalarGrid level = start;
  level.values =
      geodesic_contour(size_of(hu), hu.spacing, hu.values, start.values, options.contour);
  return signed_distance(level);
}

} // namespace f2b
