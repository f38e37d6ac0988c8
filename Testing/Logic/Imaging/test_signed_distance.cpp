#include "Imaging/lattice.hpp"
#include "Imaging/signed_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

ScalarGrid level_function(int n, double spacing, double (*f)(const Vec3&))
{
  ScalarGrid grid = grid_on({Vec3::Constant(-0.5 * (n - 1) * spacing), spacing, {n, n, n}}, 0.0F);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        grid.values[grid.index(i, j, k)] = static_cast<float>(f(grid.position(i, j, k)));
  return grid;
}

TEST(SignedDistance, PlaneIsExactWhateverTheSlopeOfTheLevelFunction)
{
  const ScalarGrid grid = signed_distance(
      level_function(41, 1.0, [](const Vec3& p) { return 300.0 * p.dot(Vec3(0.6, 0.8, 0)) + 40; }));
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(3.3, -2.2, 5), Vec3(-4, 2, -3)})
    EXPECT_NEAR(grid.value(p), p.dot(Vec3(0.6, 0.8, 0)) + 40.0 / 300.0, 1e-2);
}

TEST(SignedDistance, SphereOfASkewedLevelFunctionIsGoodToAFewHundredths)
{
  // Squared radius: the slope changes from place to place, the zero level stays.
  const ScalarGrid grid = signed_distance(
      level_function(61, 1.0, [](const Vec3& p) { return p.squaredNorm() - 20.3 * 20.3; }));
  double worst = 0.0;
  for (int k = 0; k < 61; ++k)
    for (int j = 0; j < 61; ++j)
      for (int i = 0; i < 61; ++i)
      {
        const double truth = grid.position(i, j, k).norm() - 20.3;
        if (std::abs(truth) < 5)
          worst = std::max(worst, std::abs(grid.values[grid.index(i, j, k)] - truth));
      }
  EXPECT_LT(worst, 0.05);
}

TEST(SignedDistance, GradientHasUnitLengthNearTheSurface)
{
  const ScalarGrid grid = signed_distance(
      level_function(61, 0.8, [](const Vec3& p) { return 500.0 * (p.norm() - 15.0); }));
  for (int n = 0; n < 200; ++n)
  {
    const double a = 0.37 * n, z = -0.95 + 0.0095 * n;
    const Vec3 direction(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
    EXPECT_NEAR(grid.gradient((13.0 + 0.02 * n) * direction).norm(), 1.0, 0.06);
  }
}

TEST(SignedDistance, WithoutACrossingEverythingIsFar)
{
  const ScalarGrid grid = signed_distance(level_function(9, 1.0, [](const Vec3&) { return 1.0; }));
  EXPECT_GT(grid.value(Vec3::Zero()), 1e3);
}

} // namespace
} // namespace f2b
