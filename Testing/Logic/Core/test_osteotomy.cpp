#include "Logic/Core/box_bone.hpp"
#include "expect_error.hpp"

#include <Core/geometry/osteotomy.hpp>

namespace f2b
{
namespace
{

using test::expect_error;
using testing::box_bone;
using testing::box_distance;
using testing::cut_at;
using testing::plane_at;
using testing::sampled;
using testing::volume;

constexpr double whole_mm3 = 60 * 40 * 30, section_mm2 = 40 * 30;
constexpr unsigned char first = BonePartition::first_fragment;

TEST(BoundedPlane, SeparatesOnlyThroughItsRectangle)
{
  const BoundedPlane plane = plane_at(5, 10, 10);
  Vec3 at;
  EXPECT_TRUE(plane.separates({4, 1, 2}, {7, 1, 2}, at));
  EXPECT_EQ(at, Vec3(5, 1, 2));
  EXPECT_FALSE(plane.separates({6, 1, 2}, {7, 1, 2}, at));
  EXPECT_FALSE(plane.separates({4, 11, 2}, {7, 11, 2}, at));
  EXPECT_TRUE(plane.faces({40, 11, 2}, 1));
  EXPECT_FALSE(plane.faces({40, 11.5, 2}, 1));
}

TEST(Osteotomy, PlaneFreesTheSideOfTheFragmentPoint)
{
  const ScalarGrid bone = box_bone();
  for (const double side : {-20.0, 20.0})
  {
    const BonePartition partition = cut_bone(bone, bone, {cut_at(5, side)});
    EXPECT_EQ(partition.labels.nearest({side, 0, 0}), first);
    EXPECT_EQ(partition.labels.nearest({-side, 0, 0}), BonePartition::uncut);
    EXPECT_EQ(partition.labels.nearest({0, 0, 22}), BonePartition::no_bone);
    EXPECT_NEAR(partition.fragment_volume_mm3.at(0), (side > 0 ? 25 : 35) * section_mm2,
                0.04 * whole_mm3);
  }
}

TEST(Osteotomy, FragmentRestAndKerfMakeUpTheBone)
{
  const ScalarGrid bone = box_bone();
  for (const double kerf : {0.0, 1.0, 2.0, 5.0})
  {
    const BonePartition partition = cut_bone(bone, bone, {cut_at(5, 20, "end", kerf)});
    const double fragment = volume(part_field(bone, partition, first));
    const double rest = volume(part_field(bone, partition, BonePartition::uncut));
    EXPECT_NEAR(fragment, (25 - 0.5 * kerf) * section_mm2, 0.01 * whole_mm3) << kerf;
    EXPECT_NEAR(rest, (35 - 0.5 * kerf) * section_mm2, 0.01 * whole_mm3) << kerf;
    EXPECT_NEAR(fragment + rest + kerf * section_mm2, volume(bone), 0.01 * whole_mm3) << kerf;
  }
}

TEST(Osteotomy, ObliqueCutThroughASphereKeepsTheVolume)
{
  const ScalarGrid bone = sampled([](const Vec3& p) { return p.norm() - 18; });
  Osteotomy cut = cut_at(0, 12);
  cut.planes[0].u = Vec3(1, 2, 0).normalized();
  cut.planes[0].v = Vec3(-2, 1, 1.5).normalized();
  const Vec3 normal = cut.planes[0].normal();
  cut.fragment_point = 12 * normal;
  cut.planes[0].center = 4 * normal;
  cut.planes[0].half_u = cut.planes[0].half_v = 25;
  const BonePartition partition = cut_bone(bone, bone, {cut});
  auto cap = [](double height) { return 3.14159265358979 * height * height * (18 - height / 3); };
  auto samples_inside = [&](unsigned char label)
  {
    const ScalarGrid field = part_field(bone, partition, label);
    return static_cast<double>(
        std::count_if(field.values.begin(), field.values.end(), [](float d) { return d < 0; }));
  };
  EXPECT_NEAR(samples_inside(first), cap(18 - 4 - 1), 0.02 * cap(13));
  EXPECT_NEAR(samples_inside(BonePartition::uncut), cap(36) - cap(18 - 4 + 1), 0.02 * cap(21));
}

TEST(Osteotomy, TwoFragmentsFromOneBone)
{
  const ScalarGrid bone = box_bone();
  const BonePartition partition =
      cut_bone(bone, bone, {cut_at(12, 25, "right"), cut_at(-12, -25, "left")});
  double sum = 2 * 2 * section_mm2;
  for (const unsigned char label :
       {BonePartition::uncut, first, static_cast<unsigned char>(first + 1)})
    sum += volume(part_field(bone, partition, label));
  EXPECT_NEAR(sum, whole_mm3, 0.015 * whole_mm3);
  EXPECT_EQ(partition.labels.nearest({-25, 0, 0}), first + 1);
  EXPECT_EQ(partition.labels.nearest({0, 0, 0}), BonePartition::uncut);
  for (const Vec3& p : partition.cut_points.at(0))
    EXPECT_NEAR(p.x(), 12, 1e-9);
}

TEST(Osteotomy, SeveralPlanesFreeOneFragment)
{
  const ScalarGrid bone = box_bone();
  Osteotomy cut = cut_at(0, 20);
  cut.planes = {plane_at(5), plane_at(0)};
  cut.planes[1].center = {17, 0, 0}; // lies flat, through the middle of the right end
  cut.planes[1].u = Vec3::UnitX();
  cut.planes[1].v = Vec3::UnitY();
  cut.planes[1].half_u = 16;
  cut.planes[1].half_v = 28;
  cut.planes[0].center.z() = 11; // from the flat plane upwards
  cut.planes[0].half_v = 11;
  cut.fragment_point = {20, 0, 10};
  const BonePartition partition = cut_bone(bone, bone, {cut});
  EXPECT_EQ(partition.labels.nearest({20, 0, 10}), first);
  EXPECT_EQ(partition.labels.nearest({20, 0, -10}), BonePartition::uncut);
  EXPECT_NEAR(partition.fragment_volume_mm3.at(0), 25 * 40 * 15, 0.04 * whole_mm3);
}

TEST(Osteotomy, PlaneDoesNoHarmToBoneBeyondItsFragment)
{
  // a second block above, which the plane's extension crosses
  const Vec3 above(0, 0, 40);
  const ScalarGrid bone = sampled(
      [&](const Vec3& p)
      {
        return std::min(box_distance(p, Vec3::Zero(), testing::box_half),
                        box_distance(p, above, {30, 20, 10}));
      });
  Osteotomy cut = cut_at(5, 20);
  cut.planes[0].half_v = 80;
  const BonePartition partition = cut_bone(bone, bone, {cut});
  EXPECT_EQ(partition.labels.nearest(above + Vec3(20, 0, 0)), BonePartition::uncut);
  EXPECT_NEAR(volume(part_field(bone, partition, BonePartition::uncut)),
              34 * section_mm2 + 60 * 40 * 20, 0.01 * whole_mm3);
}

TEST(Osteotomy, CavitiesAndIslandsGoWithTheNearestBone)
{
  auto hollow = [](const Vec3& p)
  {
    return std::max(box_distance(p, Vec3::Zero(), testing::box_half),
                    4 - (p - Vec3(20, 0, 0)).norm());
  };
  const Vec3 island(20, 26, 0);
  auto with_island = [&](const Vec3& p) { return std::min(hollow(p), (p - island).norm() - 3); };
  const ScalarGrid bone = sampled(with_island);
  const ScalarGrid closed = sampled(
      [&](const Vec3& p)
      {
        return std::min({box_distance(p, Vec3::Zero(), testing::box_half), (p - island).norm() - 3,
                         box_distance(p, {20, 21, 0}, {1.5, 4, 1.5})});
      });
  const BonePartition partition = cut_bone(bone, closed, {cut_at(5, 27)});
  EXPECT_EQ(partition.labels.nearest({20, 0, 0}), first) << "cavity";
  EXPECT_EQ(partition.labels.nearest(island), first) << "island";
  EXPECT_EQ(partition.labels.nearest({-20, 0, 0}), BonePartition::uncut);
}

TEST(Osteotomy, PlaneThatMissesIsNamed)
{
  const ScalarGrid bone = box_bone();
  Osteotomy cut = cut_at(5, 20);
  cut.planes.push_back(plane_at(38));
  cut.planes.back().name = "far";
  expect_error([&] { cut_bone(bone, bone, {cut}); },
               {"'end'", "'far'", "misses the bone", "move or enlarge"});
}

TEST(Osteotomy, TwoFragmentsThatAreOnePieceAreRefused)
{
  const ScalarGrid bone = box_bone();
  Osteotomy same = cut_at(5, 22);
  same.fragment = "other";
  expect_error(
      [&] {
        cut_bone(bone, bone, {cut_at(5, 20), same});
      },
      {"'end' and 'other'", "the same piece of bone", "add a plane between them"});
}

TEST(Osteotomy, CutsThatDoNotFreeAreRefused)
{
  const ScalarGrid bone = box_bone();
  Osteotomy cut = cut_at(5, 20);
  cut.planes[0].half_u = 10; // half of the width
  expect_error([&] { cut_bone(bone, bone, {cut}); },
               {"'end'", "do not free", "100 %", "bone leads round it, narrowest near R 6, A -10,"});
}

TEST(Osteotomy, TwoOfOnePieceAreRefused)
{
  const ScalarGrid bone = box_bone();
  expect_error(
      [&] {
        cut_bone(bone, bone, {cut_at(5, 20, "a"), cut_at(-25, 12, "b")});
      },
      {"'a' and 'b'", "same piece"});
}

TEST(Osteotomy, FragmentPointFarFromBoneIsRefused)
{
  const ScalarGrid bone = box_bone();
  Osteotomy cut = cut_at(5, 20);
  cut.fragment_point = {20, 0, 40};
  expect_error([&] { cut_bone(bone, bone, {cut}); }, {"'end'", "10 mm", "fragment point"});
}

TEST(Osteotomy, SliverBelowTheIslandLimitIsNoFragment)
{
  const ScalarGrid bone = sampled(
      [](const Vec3& p) {
        return box_distance(p, Vec3::Zero(), {30, 5, 5});
      });
  expect_error([&] { cut_bone(bone, bone, {cut_at(18.8, 29)}); }, {"'end'"});
}

} // namespace
} // namespace f2b
