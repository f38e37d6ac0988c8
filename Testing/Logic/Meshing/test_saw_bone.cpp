#include "expect_error.hpp"

#include <Core/geometry/saw_blade.hpp>
#include <Meshing/saw_bone.hpp>
#include <Meshing/surface_shells.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace f2b
{
namespace
{

/// A block of 60 x 40 x 30 mm about a centre; a cavity's wall where `outwards` is false.
TriangleMesh block(const Vec3& center, const Vec3& half, bool outwards = true)
{
  BoundedPlane plane;
  plane.center = center;
  plane.half_u = half.x();
  plane.half_v = half.y();
  TriangleMesh mesh = blade_of(plane, 2 * half.z());
  if (!outwards)
    for (Triangle& t : mesh.triangles)
      std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh bone()
{
  return block(Vec3::Zero(), {30, 20, 15});
}

BoundedPlane across(double r, double half = 30)
{
  BoundedPlane plane;
  plane.center = {r, 0, 0};
  plane.u = Vec3::UnitY();
  plane.v = Vec3::UnitZ();
  plane.half_u = plane.half_v = half;
  return plane;
}

std::vector<double> volumes(const SawnBone& sawn)
{
  std::vector<double> v = sawn.shell_volume;
  std::sort(v.begin(), v.end());
  return v;
}

bool is_closed(const TriangleMesh& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      ++uses[{t[c], t[(c + 1) % 3]}];
  return std::all_of(
      uses.begin(), uses.end(),
      [&](const auto& use) {
        return use.second == 1 && uses.count({use.first.second, use.first.first}) == 1;
      });
}

TEST(SawBone, PlanePartsABlock)
{
  const SawnBone sawn = saw_bone(bone(), {blade_of(across(10), 2)});
  ASSERT_EQ(sawn.shell_volume.size(), 2U);
  EXPECT_NEAR(volumes(sawn)[0], 19 * 1200, 1e-6);
  EXPECT_NEAR(volumes(sawn)[1], 39 * 1200, 1e-6);
  EXPECT_NEAR(sawn.kerf_mm3, 2 * 1200, 1e-6);
  EXPECT_LT(sawn.imbalance(), 1e-12);
  EXPECT_TRUE(is_closed(sawn.surface));
}

TEST(SawBone, CutThatEndsInsideLeavesASlot)
{
  const SawnBone sawn = saw_bone(bone(), {blade_of(across(10, 16), 2)});
  ASSERT_EQ(sawn.shell_volume.size(), 1U);
  EXPECT_NEAR(sawn.kerf_mm3, 2 * 32 * 30, 1e-6);
  EXPECT_LT(sawn.imbalance(), 1e-12);
  EXPECT_TRUE(is_closed(sawn.surface));
}

TEST(SawBone, BladesWithinOneAnotherAndCrossingAreOneKerf)
{
  BoundedPlane level = across(0, 50);
  level.u = Vec3::UnitX();
  level.v = Vec3::UnitY();
  const std::vector<TriangleMesh> blades = {blade_of(across(10), 2), blade_of(across(10, 40), 2),
                                            blade_of(level, 2)};
  const SawnBone sawn = saw_bone(bone(), blades);
  EXPECT_EQ(sawn.shell_volume.size(), 4U);
  EXPECT_NEAR(sawn.kerf_mm3, 2 * 1200 + 2 * 60 * 40 - 4 * 40, 0.5) << "they are moved by 0.2 um";
  EXPECT_LT(sawn.imbalance(), 1e-12);
  EXPECT_TRUE(is_closed(sawn.surface));
}

TEST(SawBone, CavityIsOpenedAndFarShellsStay)
{
  TriangleMesh hollow = bone();
  append(hollow, block({10, 0, 0}, {5, 5, 5}, false));
  append(hollow, block({100, 0, 0}, {5, 5, 5}));
  const SawnBone sawn = saw_bone(hollow, {blade_of(across(10), 2)});
  ASSERT_EQ(sawn.shell_volume.size(), 3U);
  EXPECT_NEAR(volumes(sawn)[0], 1000, 1e-6);
  EXPECT_NEAR(volumes(sawn)[1], 19 * 1200 - 400, 1e-6);
  EXPECT_NEAR(sawn.kerf_mm3, 2 * (1200 - 100), 1e-6);
  std::vector<char> wanted;
  for (const double volume : sawn.shell_volume)
    wanted.push_back(volume < 2000);
  EXPECT_EQ(shells_of(sawn, wanted).triangles.size(), 12U);
}

TEST(SawBone, BladeThatMissesChangesNothing)
{
  const SawnBone sawn = saw_bone(bone(), {blade_of(across(35), 2)});
  EXPECT_FALSE(sawn.met);
  EXPECT_EQ(sawn.kerf_mm3, 0);
  EXPECT_EQ(sawn.surface.triangles.size(), bone().triangles.size());
}

TEST(SawBone, OpenBoneIsRefused)
{
  TriangleMesh open = bone();
  open.triangles.pop_back();
  test::expect_error([&] { (void)saw_bone(open, {blade_of(across(10), 2)}); },
                     {"bone surface", "open", "repair"});
}

} // namespace
} // namespace f2b
