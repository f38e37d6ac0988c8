#include "Core/mesh/skin_over_bone.hpp"

#include "Core/mesh/contact.hpp"

#include <algorithm>

namespace f2b
{

std::vector<int> fragments_below(const ScalarGrid& closed_bone, const LabelGrid& parts,
                                 const std::vector<Vec3>& skin)
{
  std::vector<int> fragments;
  for (const Vec3& vertex : skin)
  {
    // walk down the distance map; a second step mends the bend of its gradient
    Vec3 p = vertex;
    for (int step = 0; step < 3; ++step)
    {
      const Vec3 slope = closed_bone.gradient(p);
      if (slope.norm() > 1e-3)
        p -= closed_bone.value(p) * slope.normalized();
    }
    fragments.push_back(std::max(-1, nearest_bone(parts, p) - BonePartition::first_fragment));
  }
  return fragments;
}

} // namespace f2b
