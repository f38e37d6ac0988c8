#include "Case/face_regions.hpp"

#include "Core/mesh/contact.hpp"

namespace f2b
{

FaceRegions face_regions(const ScalarGrid& closed_bone, const LabelGrid& parts,
                         const std::vector<Vec3>& reference_skin)
{
  FaceRegions regions;
  for (const Vec3& vertex : reference_skin)
  {
    // walk down the distance map; a second step mends the bend of its gradient
    Vec3 p = vertex;
    for (int step = 0; step < 3; ++step)
    {
      const Vec3 slope = closed_bone.gradient(p);
      if (slope.norm() > 1e-3)
        p -= closed_bone.value(p) * slope.normalized();
    }
    regions.over_fragment.push_back(nearest_bone(parts, p) >= BonePartition::first_fragment);
  }
  return regions;
}

} // namespace f2b
