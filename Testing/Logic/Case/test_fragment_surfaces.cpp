#include "Logic/Core/box_bone.hpp"

#include "expect_error.hpp"

#include <Bridge/vtk_surface.hpp>
#include <Case/cut_surfaces.hpp>
#include <Core/geometry/saw_blade.hpp>
#include <Core/geometry/trimmed_cuts.hpp>
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

/// The block's own surface.
TriangleMesh block_surface()
{
  BoundedPlane level;
  level.half_u = testing::box_half.x();
  level.half_v = testing::box_half.y();
  return blade_of(level, 2 * testing::box_half.z());
}

TEST(CutSurfaces, FragmentsAndKerfAreTheBoneExactly)
{
  const ScalarGrid bone = testing::box_bone();
  BonePartition partition = cut_bone(
      bone, bone, {testing::cut_at(12, 25, "right", 1.5), testing::cut_at(-12, -25, "left", 0)});
  partition.osteotomies = trimmed_cuts(partition);
  const auto cut = std::get<CutSurfaces>(cut_surfaces(block_surface(), partition));
  ASSERT_EQ(cut.parts.size(), 3U);
  EXPECT_NEAR(cut.volume_mm3[0], (24 - 0.75 - 0.005) * 1200, 1);
  EXPECT_NEAR(cut.volume_mm3[1], (18 - 0.75) * 1200, 1);
  EXPECT_NEAR(cut.volume_mm3[2], (18 - 0.005) * 1200, 1) << "no kerf is cut with 0.01 mm";
  EXPECT_LT(cut.imbalance, 1e-9);
  for (const TriangleMesh& part : cut.parts)
    EXPECT_TRUE(check_surface(to_polydata(part)).watertight());
}

TEST(CutSurfaces, PlanesAreTrimmedToTheBoneThatTheyPart)
{
  const ScalarGrid bone = testing::box_bone();
  Osteotomy wide = testing::cut_at(5, 20);
  wide.planes[0].half_u = 40;
  BonePartition partition = cut_bone(bone, bone, {wide});
  const BoundedPlane trimmed = trimmed_cuts(partition).at(0).planes.at(0);
  EXPECT_NEAR(trimmed.half_u, 20 + 2, 0.6);
  EXPECT_NEAR(trimmed.half_v, 15 + 2, 0.6);
  EXPECT_NEAR(trimmed.center.x(), 5, 1e-12);
}

TEST(CutSurfaces, BridgeThatTheLatticeDoesNotSeeIsTold)
{
  // the plane ends 0.3 mm inside the block's side: between the last samples and the surface
  const ScalarGrid bone = testing::box_bone();
  Osteotomy narrow = testing::cut_at(5, 20);
  narrow.planes[0].half_u = 19.7;
  const BonePartition partition = cut_bone(bone, bone, {narrow});
  const auto bridge = std::get<BoneBridge>(cut_surfaces(block_surface(), partition));
  EXPECT_NE(bridge.part, bridge.other);
  EXPECT_NEAR(bridge.place.x(), 5, 1e-6);
  EXPECT_NEAR(std::max(std::abs(bridge.place.y()), std::abs(bridge.place.z())), 20, 0.3);
  test::expect_error([&] { throw bridge_error(bridge, partition); },
                     {"bridge of bone", "'end'", "enlarge the cut"});
}

TEST(SawClearance, IsMeasuredFromTheKerf)
{
  const std::vector<Osteotomy> cuts = {testing::cut_at(5, 20, "end", 2)};
  const SawClearance beside = saw_clearance({{9, 0, 0}, {20, 0, 0}}, cuts);
  EXPECT_NEAR(beside.distance_mm, 3, 1e-12);
  EXPECT_EQ(beside.at, Vec3(9, 0, 0));
  EXPECT_NE(beside.cut.find("'end'"), std::string::npos);
  EXPECT_LT(saw_clearance({{5.5, 0, 0}}, cuts).distance_mm, 0);
  EXPECT_NEAR(saw_clearance({{5, 32, 22}}, cuts).distance_mm, 3, 1e-12) << "beyond the blade's end";
}

} // namespace
} // namespace f2b
