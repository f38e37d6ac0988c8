#include "expect_error.hpp"

#include <Core/geometry/landmark_warp.hpp>

#include <limits>

namespace f2b
{
namespace
{

using test::expect_error;

const std::vector<Vec3> from = {{0, 90, 0}, {15, 80, -5}, {-15, 80, -5}, {0, 85, -30}};
const std::vector<Vec3> to = {{0, 96, 0}, {15, 84, -6}, {-15, 84, -6}, {0, 85, -30}};

TEST(LandmarkWarp, TakesEveryPointToItsPlace)
{
  const LandmarkWarp warp(from, to, 45);
  for (std::size_t i = 0; i < from.size(); ++i)
    EXPECT_LT((from[i] + warp.displacement(from[i]) - to[i]).norm(), 1e-12);
}

TEST(LandmarkWarp, FadesOutAtTheRadius)
{
  const LandmarkWarp warp({{0, 0, 0}}, {{0, 8, 0}}, 40);
  EXPECT_EQ(warp.displacement({40, 0, 0}), Vec3::Zero());
  EXPECT_EQ(warp.displacement({0, 0, -60}), Vec3::Zero());
  EXPECT_LT(warp.displacement({39, 0, 0}).norm(), 1e-4);
  double last = 8;
  for (double r = 1; r < 40; ++r)
  {
    const double now = warp.displacement({r, 0, 0}).y();
    EXPECT_LT(now, last);
    last = now;
  }
  EXPECT_NEAR(warp.displacement({20, 0, 0}).y(), 8 * 3.0 / 16, 1e-12); // (1/2)^4 (4/2 + 1)
}

TEST(LandmarkWarp, SymmetricPointsGiveASymmetricFace)
{
  const LandmarkWarp warp(from, to, 45);
  const Vec3 right = warp.displacement({9, 70, -12}), left = warp.displacement({-9, 70, -12});
  EXPECT_NEAR(right.x(), -left.x(), 1e-12);
  EXPECT_NEAR(right.y(), left.y(), 1e-12);
  EXPECT_NEAR(right.z(), left.z(), 1e-12);
}

TEST(LandmarkWarp, HeldPointsHoldTheFaceAroundThem)
{
  const LandmarkWarp warp(from, to, 45);
  EXPECT_LT(warp.displacement(from[3] + Vec3(0.5, 0, 0)).norm(), 0.2);
}

TEST(LandmarkWarp, BadInputIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  expect_error([] { LandmarkWarp({}, {}, 45); }, {"0 from points"});
  expect_error([] { LandmarkWarp(from, {to[0]}, 45); }, {"4 from points", "1 to points"});
  for (const double radius : {0.0, -3.0, nan, inf})
    expect_error([&] { LandmarkWarp(from, to, radius); }, {"radius"});
  std::vector<Vec3> bad = to;
  bad[1].y() = nan;
  expect_error([&] { LandmarkWarp(from, bad, 45); }, {"point 2", "not finite"});
  bad = from;
  bad[2] = bad[0] + Vec3(0.05, 0, 0);
  expect_error([&] { LandmarkWarp(bad, to, 45); }, {"1 and 3"});
}

} // namespace
} // namespace f2b
