#include "Core/error.hpp"
#include "Imaging/segment_head.hpp"
#include "Logic/Imaging/sphere_ct.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace f2b
{
namespace
{

using test::SphereCt;

const Vec3 centre_ras(-10.0, 20.0, 30.0);

SegmentOptions options_for(const SphereCt& sphere)
{
  SegmentOptions options;
  options.skin_threshold_hu = sphere.skin_threshold;
  options.bone_threshold_hu = sphere.bone_threshold;
  options.region_ras = Box{centre_ras - Vec3(45, 0, 45), centre_ras + Vec3(45, 62, 45)};
  return options;
}

CtImage::DirectionType rotated(double angle, const Vec3& axis)
{
  const Mat3 r = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  CtImage::DirectionType direction;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      direction(row, column) = r(row, column);
  return direction;
}

/// The largest error of a distance to a sphere among the samples of the region nearer to it than
/// 5 mm [mm].
double worst_error(const ScalarGrid& distance, const Box& region, double radius)
{
  double worst = 0.0;
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i)
      {
        const Vec3 p = distance.position(i, j, k);
        const double truth = (p - centre_ras).norm() - radius;
        const bool in_region =
            (p.array() >= region.min.array()).all() && (p.array() <= region.max.array()).all();
        if (in_region && std::abs(truth) < 5.0)
          worst = std::max(worst, std::abs(distance.values[distance.index(i, j, k)] - truth));
      }
  return worst;
}

std::string message_of(const CtImage& ct, const SegmentOptions& options)
{
  try
  {
    segment_head(ct, options);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "no error";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(SegmentSphere, DistancesAreExactToATenthOfAMillimetre)
{
  const SphereCt sphere;
  const HeadSegmentation found = segment_head(*sphere.image(), options_for(sphere));
  EXPECT_LT(worst_error(found.skin, found.region_ras, sphere.skin_radius), 0.1);
  EXPECT_LT(worst_error(found.bone, found.region_ras, sphere.bone_radius), 0.1);
  EXPECT_LT(worst_error(found.closed_bone, found.region_ras, sphere.bone_radius), 0.1);
}

TEST(SegmentSphere, ObliqueCtGivesTheSameSphere)
{
  const SphereCt sphere;
  const auto ct = sphere.image(rotated(0.4, Vec3(1, 2, -1)));
  const HeadSegmentation found = segment_head(*ct, options_for(sphere));
  EXPECT_LT(worst_error(found.skin, found.region_ras, sphere.skin_radius), 0.15);
  EXPECT_LT(worst_error(found.bone, found.region_ras, sphere.bone_radius), 0.15);
}

TEST(SegmentSphere, ThickSlicesStillGiveTheSphere)
{
  SphereCt sphere;
  sphere.spacing[2] = 2.0;
  const HeadSegmentation found = segment_head(*sphere.image(), options_for(sphere));
  EXPECT_LT(worst_error(found.skin, found.region_ras, sphere.skin_radius), 0.4);
  EXPECT_LT(worst_error(found.bone, found.region_ras, sphere.bone_radius), 0.4);
}

TEST(SegmentSphere, LabelsFollowTheLayers)
{
  const SphereCt sphere;
  const HeadSegmentation found = segment_head(*sphere.image(), options_for(sphere));
  auto label_at = [&](double radius)
  { return static_cast<HeadLabel>(found.labels.nearest(centre_ras + Vec3(0, radius, 0))); };
  EXPECT_EQ(label_at(64), HeadLabel::Air);
  EXPECT_EQ(label_at(59), HeadLabel::Skin);
  EXPECT_EQ(label_at(50), HeadLabel::Muscle);
  EXPECT_EQ(label_at(30), HeadLabel::Bone);
}

TEST(SegmentSphere, RefusesThresholdsThatSelectNothing)
{
  const SphereCt sphere;
  SegmentOptions options = options_for(sphere);
  options.bone_threshold_hu = 5000;
  const std::string bone = message_of(*sphere.image(), options);
  EXPECT_TRUE(contains(bone, "bone_threshold_hu: 5000 HU")) << bone;
  EXPECT_TRUE(contains(bone, "1200 HU")) << bone;
  options = options_for(sphere);
  options.skin_threshold_hu = -3000;
  const std::string skin = message_of(*sphere.image(), options);
  EXPECT_TRUE(contains(skin, "skin_threshold_hu: -3000 HU")) << skin;
}

TEST(SegmentSphere, RefusesARegionThatHoldsNothing)
{
  const SphereCt sphere;
  const auto ct = sphere.image();
  SegmentOptions options = options_for(sphere);
  auto message_for = [&](const Vec3& low, const Vec3& high)
  {
    options.region_ras = Box{centre_ras + low, centre_ras + high};
    return message_of(*ct, options);
  };
  const std::string without_bone = message_for({-10, 45, -10}, {10, 65, 10});
  EXPECT_TRUE(contains(without_bone, "holds no bone")) << without_bone;
  const std::string without_skin = message_for({55, 55, 55}, {66, 66, 66});
  EXPECT_TRUE(contains(without_skin, "holds no skin")) << without_skin;
  const std::string outside = message_for({500, 0, 0}, {520, 20, 20});
  EXPECT_TRUE(contains(outside, "outside the CT")) << outside;
  const std::string reversed = message_for({20, 0, 0}, {-20, 20, 20});
  EXPECT_TRUE(contains(reversed, "min < max")) << reversed;
}

} // namespace
} // namespace f2b
