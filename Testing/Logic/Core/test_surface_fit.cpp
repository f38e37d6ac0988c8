#include "Logic/Core/box_bone.hpp"

#include <Core/error.hpp>
#include <Core/geometry/fragment_movement.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

using testing::box_distance;
using testing::box_half;
using testing::sampled;

const double degree = std::acos(-1.0) / 180;

RigidMotion small_motion()
{
  RigidMotion motion;
  motion.reference_point = Vec3(2, -3, 4);
  motion.translation = Vec3(2.5, -1.5, 3);
  motion.rotation = rotation_from({4 * degree, -3 * degree, 5 * degree});
  return motion;
}

bool everywhere(const Vec3&)
{
  return true;
}

TEST(SurfacePoints, LieOnTheSurfaceWithOutwardNormals)
{
  const ScalarGrid ball = sampled([](const Vec3& p) { return p.norm() - 18; });
  const auto points = surface_points(ball, everywhere, 700);
  EXPECT_NEAR(static_cast<double>(points.size()), 700, 20);
  for (const SurfaceSample& s : points)
  {
    EXPECT_NEAR(s.point.norm(), 18, 0.02);
    EXPECT_GT(s.normal.dot(s.point.normalized()), 0.999);
  }
  const auto upper = surface_points(
      ball, [](const Vec3& p) { return p.z() > 0; }, 700);
  for (const SurfaceSample& s : upper)
    EXPECT_GT(s.point.z(), 0);
}

TEST(SurfaceFit, FindsTheMotionOfABlock)
{
  const RigidMotion truth = small_motion(), back = inverse(truth);
  const auto points = surface_points(testing::box_bone(), everywhere, 2000);
  const ScalarGrid moved =
      sampled([&](const Vec3& p) { return box_distance(back.apply(p), Vec3::Zero(), box_half); });
  RigidMotion rest;
  const SurfaceFit fit = fit_surface(points, moved, rest);
  EXPECT_LT(largest_difference(fit.motion, truth, points), 0.05);
  EXPECT_LT(angle_between(fit.motion, truth), 0.05 * degree);
  EXPECT_GT(fit.inlier_share, 0.9);
  EXPECT_LT(fit.rms_mm, 0.1);
  EXPECT_GT(fit.least_hold, 0.01);
}

TEST(SurfaceFit, IgnoresWhatIsMissingAndWhatWasAdded)
{
  const RigidMotion truth = small_motion(), back = inverse(truth);
  const auto points = surface_points(testing::box_bone(), everywhere, 2000);
  // a corner is gone, and a plate stands next to another side
  const ScalarGrid moved = sampled(
      [&](const Vec3& p)
      {
        const Vec3 X = back.apply(p);
        const double block = box_distance(X, Vec3::Zero(), box_half);
        const double gone = box_distance(X, box_half, Vec3(15, 15, 15));
        const double plate = box_distance(X, Vec3(-5, 26, 0), Vec3(10, 2, 10));
        return std::min(std::max(block, -gone), plate);
      });
  const SurfaceFit fit = fit_surface(points, moved, RigidMotion());
  EXPECT_LT(largest_difference(fit.motion, truth, points), 0.1);
  EXPECT_LT(fit.inlier_share, 0.97);
}

TEST(SurfaceFit, SaysWhereTheSurfaceSlidesOnItself)
{
  const ScalarGrid ball = sampled([](const Vec3& p) { return p.norm() - 18; });
  const auto points = surface_points(ball, everywhere, 1000);
  EXPECT_LT(fit_surface(points, ball, RigidMotion()).least_hold, 1e-3);
}

/// A block sawn at R 8; its end is the fragment.
struct SawnBlock
{
  ScalarGrid bone = testing::box_bone();
  BonePartition partition = cut_bone(bone, bone, {testing::cut_at(8, 20)});
  std::vector<SurfaceSample> end = fragment_surface(bone, partition, BonePartition::first_fragment);

  ScalarGrid after(const RigidMotion& motion) const
  {
    const RigidMotion back = inverse(motion);
    return sampled(
        [&](const Vec3& p)
        {
          const double stays = box_distance(p, Vec3(-11.5, 0, 0), Vec3(18.5, 20, 15));
          const double moves = box_distance(back.apply(p), Vec3(19.5, 0, 0), Vec3(10.5, 20, 15));
          return std::min(stays, moves);
        });
  }
};

TEST(FragmentMovement, SurfaceLeavesOutTheSawsFaces)
{
  const SawnBlock block;
  ASSERT_GT(block.end.size(), 1000U);
  for (const SurfaceSample& s : block.end)
  {
    EXPECT_NEAR(block.bone.value(s.point), 0, 0.21);
    EXPECT_GT(s.point.x(), 7);
  }
}

TEST(FragmentMovement, IsMeasuredWithoutAPlan)
{
  const SawnBlock block;
  RigidMotion truth;
  truth.reference_point = Vec3(19, 0, 0);
  truth.translation = Vec3(7, -2, 4);
  truth.rotation = rotation_from({6 * degree, 2 * degree, -4 * degree});
  RigidMotion rest;
  rest.reference_point = truth.reference_point;
  const FragmentMovement found =
      measure_fragment_movement(block.end, block.after(truth), rest, "end");
  EXPECT_LT(largest_difference(found.fit.motion, truth, block.end), 0.1);
  EXPECT_EQ(found.fit.motion.reference_point, truth.reference_point);
  EXPECT_FALSE(found.doubtful());
}

TEST(FragmentMovement, IsRefusedWhereThereIsNoBone)
{
  const SawnBlock block;
  const ScalarGrid empty = sampled([](const Vec3&) { return 30.0; });
  try
  {
    (void)measure_fragment_movement(block.end, empty, RigidMotion(), "end");
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.kind(), ErrorKind::Numerical);
    EXPECT_NE(std::string(error.what()).find("'end'"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace f2b
