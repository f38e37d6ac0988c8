#include "Core/geometry/noise_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

/// Mean product of the errors of two points, over seeds and components [mm^2].
double covariance(double distance, double correlation_mm)
{
  double sum = 0;
  constexpr int seeds = 400;
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
  {
    const std::vector<Vec3> noise =
        correlated_noise({{10, -20, 30}, {10, -20 + distance, 30}}, {0.5, correlation_mm, seed});
    sum += noise[0].dot(noise[1]) / 3;
  }
  return sum / seeds;
}

TEST(NoiseField, NeighboursErrAlikeAsTheCorrelationLengthSays)
{
  // standard error of a mean of 1200 products: 0.25 / sqrt(1200) * 1.4 = 0.01
  for (const double l : {5.0, 15.0})
    for (const double r : {0.0, 5.0, 15.0, 60.0})
      EXPECT_NEAR(covariance(r, l), 0.25 * std::exp(-r * r / (2 * l * l)), 0.035)
          << "r " << r << ", l " << l;
}

TEST(NoiseField, WithoutLengthNoPointKnowsOfAnother)
{
  EXPECT_NEAR(covariance(0.01, 0), 0, 0.035);
  std::vector<Vec3> points(20000, Vec3::Zero());
  double sum = 0;
  for (const Vec3& n : correlated_noise(points, {0.5, 0, 7}))
    sum += n.squaredNorm() / (3 * 20000);
  EXPECT_NEAR(std::sqrt(sum), 0.5, 0.01);
}

TEST(NoiseField, ASeedGivesTheSameNoiseAgain)
{
  const std::vector<Vec3> points = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(correlated_noise(points, {0.5, 5, 3}), correlated_noise(points, {0.5, 5, 3}));
  EXPECT_NE(correlated_noise(points, {0.5, 5, 3}), correlated_noise(points, {0.5, 5, 4}));
  RandomNumbers random(1);
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < 10000; ++i)
  {
    const Vec3 d = random.direction();
    EXPECT_NEAR(d.norm(), 1, 1e-12);
    mean += d / 10000;
  }
  EXPECT_LT(mean.norm(), 0.03);
}

} // namespace
} // namespace f2b
