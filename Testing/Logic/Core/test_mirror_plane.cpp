#include "Logic/Core/sphere_mesh.hpp"

#include <Core/geometry/rigid_motion.hpp>
#include <Core/sculpting/mirror_plane.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;

/// A head of 80 mm, symmetric about x = 0 only: a nose in front, ears, and a chin below.
TriangleMesh head()
{
  TriangleMesh mesh = testing::icosphere(5);
  auto bump = [](const Vec3& p, const Vec3& at, double width)
  { return std::exp(-(p - at.normalized()).squaredNorm() / (width * width)); };
  for (Vec3& p : mesh.points)
  {
    const Vec3 side(std::abs(p.x()), p.y(), p.z());
    p *= 80 + 18 * bump(p, {0, 1, 0.05}, 0.2) + 12 * bump(side, {1, -0.2, 0.1}, 0.2) +
         10 * bump(p, {0, 0.8, -0.7}, 0.3) - 8 * bump(side, {0.4, 0.9, 0.35}, 0.15);
    p.z() *= 1.3;
  }
  return mesh;
}

void expect_found(const TriangleMesh& mesh, const RigidMotion& motion, double mm, double degrees)
{
  const auto found = mirror_plane(mesh);
  ASSERT_TRUE(found);
  const Vec3 normal = motion.rotation * Vec3::UnitX();
  EXPECT_LT(std::acos(std::min(1.0, found->plane.normal.dot(normal))) / degree, degrees);
  const Vec3 middle = motion.apply(Vec3(0, 60, 0));
  EXPECT_LT(std::abs((middle - found->plane.point).dot(found->plane.normal)), mm);
}

TEST(MirrorPlane, IsFoundInAHeadThatIsTurnedInTheScanner)
{
  for (const Vec3& turned : {Vec3(0, 0, 0), Vec3(15, 12, -14), Vec3(-20, -10, 18)})
  {
    SCOPED_TRACE(turned.transpose());
    const RigidMotion motion = {
        rotation_from({turned.x() * degree, turned.y() * degree, turned.z() * degree}),
        Vec3(13, -40, 220), Vec3::Zero()};
    TriangleMesh mesh = head();
    for (Vec3& p : mesh.points)
      p = motion.apply(p);
    expect_found(mesh, motion, 0.05, 0.1);
  }
}

TEST(MirrorPlane, ASwollenCheekAndAMissingSideOfTheNeckMoveItLittle)
{
  TriangleMesh mesh = head();
  for (Vec3& p : mesh.points)
  {
    const Vec3 cheek = Vec3(0.8, 0.6, -0.2).normalized() * 80;
    p += 10 * std::exp(-(p - cheek).squaredNorm() / 400) * cheek.normalized();
    if (p.z() < -70 && p.x() < 0)
      p.z() = -70;
  }
  expect_found(mesh, {Mat3::Identity(), Vec3::Zero(), Vec3::Zero()}, 0.5, 1);
}

TEST(MirrorPlane, SaysNothingOfWhatIsTooSmall)
{
  EXPECT_FALSE(mirror_plane({}));
  EXPECT_FALSE(mirror_plane({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}));
}

} // namespace
} // namespace f2b
