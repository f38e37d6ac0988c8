#include "expect_error.hpp"

#include <Core/geometry/bite.hpp>
#include <Core/geometry/rigid_motion.hpp>

#include <cmath>

namespace f2b
{
namespace
{

/// A level occlusal plane at S = -70, teeth in the middle.
Landmarks straight_bite()
{
  return {{"N", {0, 75, 5}},      {"Or_R", {33, 66, -23}}, {"Or_L", {-33, 66, -23}},
          {"U1", {0, 80, -70}},   {"U6_R", {27, 50, -70}}, {"U6_L", {-27, 50, -70}},
          {"L1", {0, 77, -68.5}}, {"A", {0, 74, -50}},     {"B", {0, 74, -91}}};
}

Bite bite_of(const Landmarks& l)
{
  return bite(l, mid_sagittal_plane(l));
}

void expect_same(const Bite& a, const Bite& b)
{
  EXPECT_NEAR(a.overjet_mm, b.overjet_mm, 1e-9);
  EXPECT_NEAR(a.overbite_mm, b.overbite_mm, 1e-9);
  EXPECT_NEAR(a.dental_midline_mm, b.dental_midline_mm, 1e-9);
  EXPECT_NEAR(a.upper_midline_mm, b.upper_midline_mm, 1e-9);
  EXPECT_NEAR(a.lower_midline_mm, b.lower_midline_mm, 1e-9);
}

TEST(Bite, OfALevelPlaneIsRead)
{
  expect_same(bite_of(straight_bite()), {3, 1.5, 0, 0, 0});
  Landmarks open = straight_bite();
  open["L1"] = {2, 84, -75};
  expect_same(bite_of(open), {-4, -5, 2, 0, 2});
}

TEST(Bite, IsMeasuredInTheOcclusalPlane)
{
  // the upper jaw turned by pitch about U1: L1 is read in the turned axes
  Landmarks l = straight_bite();
  const double pitch = 0.2;
  RigidMotion turn;
  turn.rotation = rotation_from({pitch, 0, 0});
  turn.reference_point = l["U1"];
  for (const char* tooth : {"U6_R", "U6_L"})
    l[tooth] = turn.apply(l[tooth]);
  const Bite b = bite_of(l);
  EXPECT_NEAR(b.overjet_mm, 3 * std::cos(pitch) - 1.5 * std::sin(pitch), 1e-9);
  EXPECT_NEAR(b.overbite_mm, 1.5 * std::cos(pitch) + 3 * std::sin(pitch), 1e-9);
}

TEST(Bite, FollowsAMovedMaxilla)
{
  const Landmarks rest = straight_bite();
  Landmarks moved = rest;
  for (const char* tooth : {"U1", "U6_R", "U6_L"})
    moved[tooth] += Vec3(2, 11, -5);
  expect_same(bite(moved, mid_sagittal_plane(rest)), {14, 6.5, -2, 2, 0});
}

TEST(Bite, DoesNotDependOnWhereTheHeadLies)
{
  Landmarks l = straight_bite();
  l["L1"] = {1.2, 78, -69};
  l["Zy_R"] = {61, 24, -26};
  l["Zy_L"] = {-60, 24, -27};
  const Bite rest = bite_of(l);
  RigidMotion motion;
  motion.rotation = rotation_from({0.5, -0.7, 2});
  motion.translation = {10, 200, -30};
  for (auto& [name, point] : l)
    point = motion.apply(point);
  expect_same(bite_of(l), rest);
}

TEST(Bite, MidSagittalPlaneIsTheMeanOfThePairs)
{
  Landmarks l = straight_bite();
  const double tilt = 0.1;
  l["Zy_R"] = Vec3(60 * std::cos(tilt), 24, 60 * std::sin(tilt));
  l["Zy_L"] = -l["Zy_R"] + Vec3(0, 48, 0);
  const MidSagittalPlane plane = mid_sagittal_plane(l);
  EXPECT_NEAR(plane.normal.dot(Vec3(std::cos(tilt / 2), 0, std::sin(tilt / 2))), 1, 1e-12);
  EXPECT_EQ(plane.point, l["N"]);
}

TEST(Bite, TeethAskTheBoneTowardsTheirRoots)
{
  Landmarks l = straight_bite();
  EXPECT_NEAR((bone_of_tooth(l, "U1") - l["U1"]).norm(), 10, 1e-12);
  EXPECT_GT(bone_of_tooth(l, "U1").z(), l["U1"].z() + 8);
  EXPECT_LT(bone_of_tooth(l, "L1").z(), l["L1"].z() - 8);
  EXPECT_NEAR((bone_of_tooth(l, "U6_R") - Vec3(27, 50, -60)).norm(), 0, 1e-12);
  l.erase("B");
  EXPECT_NEAR((bone_of_tooth(l, "L1") - Vec3(0, 77, -78.5)).norm(), 0, 1e-12);
}

TEST(Bite, MissingLandmarksAreNamed)
{
  Landmarks l = straight_bite();
  EXPECT_TRUE(missing_for_bite(l).empty());
  l.erase("L1");
  EXPECT_EQ(missing_for_bite(l), std::vector<std::string>{"L1"});
  test::expect_error([&] { (void)bite(l, {}); }, {"L1", "landmark file"});
}

} // namespace
} // namespace f2b
