#include "Logic/Core/box_bone.hpp"

#include <Meshing/isosurface.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

/// As the verb `cut` makes them.
SurfaceCheck part_surface(const ScalarGrid& bone, const BonePartition& partition,
                          unsigned char label)
{
  SurfaceOptions options;
  options.smoothing_iterations = 0;
  return check_surface(watertight_isosurface(part_field(bone, partition, label), 0, options));
}

TEST(FragmentSurfaces, AreClosedAndFillTheBoneButForTheKerf)
{
  const ScalarGrid bone = testing::box_bone();
  Osteotomy oblique = testing::cut_at(12, 25, "right", 1.5);
  oblique.planes[0].u = Vec3(0.3, 1, 0.1).normalized();
  oblique.planes[0].v = Vec3(0.2, -0.1, 0.4).normalized();
  oblique.planes[0].v =
      (oblique.planes[0].v - oblique.planes[0].u * oblique.planes[0].u.dot(oblique.planes[0].v))
          .normalized();
  oblique.planes[0].half_u = oblique.planes[0].half_v = 50;
  const double section_mm2 = 40 * 30 / std::abs(oblique.planes[0].normal().x());
  const BonePartition partition =
      cut_bone(bone, bone, {oblique, testing::cut_at(-12, -25, "left", 2)});
  double sum = 0;
  for (const unsigned char label : {1, 2, 3})
  {
    const SurfaceCheck check = part_surface(bone, partition, label);
    EXPECT_TRUE(check.watertight()) << check.open_edges << " open edges, part " << int(label);
    EXPECT_EQ(check.components, 1u) << "part " << int(label);
    sum += check.volume_mm3;
  }
  EXPECT_NEAR(sum + 2 * 40 * 30 + 1.5 * section_mm2, 60 * 40 * 30, 0.015 * 60 * 40 * 30);
}

} // namespace
} // namespace f2b
