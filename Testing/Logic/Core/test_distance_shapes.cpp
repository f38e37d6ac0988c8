#include <Core/geometry/sculpture.hpp>

#include <gtest/gtest.h>

namespace
{

using namespace f2b;

TEST(DistanceShapesTest, ExactShapesMeasureMillimetres)
{
  EXPECT_NEAR((Capsule{{0, 0, 0}, 2, {10, 0, 0}, 2}.distance({5, 5, 0})), 3, 1e-12);
  EXPECT_NEAR((Capsule{{0, 0, 0}, 3, {10, 0, 0}, 1}.distance({-5, 0, 0})), 2, 1e-12);
  EXPECT_NEAR((RoundedBox{{1, 2, 3}, {4, 5, 6}, 1}.distance({1, 2, 12})), 3, 1e-12);
  EXPECT_NEAR((Ring{{0, 0, 0}, {10, 10}, 2}.distance({0, 15, 0})), 3, 1e-12);
  EXPECT_NEAR((Sheet{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, 1}.distance({4, 5, -3})), 2,
              1e-12);
  EXPECT_NEAR((Sheet{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, 1}.distance({12, 13, 0})), 4,
              1e-12);
}

TEST(DistanceShapesTest, EllipsoidIsZeroOnItsSurfaceAndASphereIsExact)
{
  const Ellipsoid e{{1, 0, 0}, {30, 20, 10}, turned(10, 20, 30)};
  const Vec3 direction = Vec3(0.4, 0.5, 0.6).normalized();
  const Vec3 on_surface = e.centre + e.axes * direction.cwiseProduct(e.semi_axes);
  EXPECT_NEAR(e.distance(on_surface), 0, 1e-12);
  EXPECT_NEAR((Ellipsoid{{0, 0, 0}, {7, 7, 7}}.distance({0, 0, 9})), 2, 1e-12);
}

TEST(DistanceShapesTest, BlendsActOnlyWithinTheirRange)
{
  EXPECT_EQ(smooth_union(1, 9, 3), 1);
  EXPECT_DOUBLE_EQ(smooth_union(2, 2, 4), 1);
  EXPECT_DOUBLE_EQ(smooth_intersection(2, 2, 4), 3);
  EXPECT_EQ(smooth_subtraction(-5, 8, 2), -5);
}

TEST(SculptureTest, SkippingDistantShapesChangesNothing)
{
  const Capsule near{{0, 0, 0}, 3, {5, 0, 0}, 2}, hole{{2, 0, 0}, 1, {2, 9, 0}, 1};
  const RoundedBox distant{{40, 0, 0}, {5, 5, 5}, 1};
  Sculpture s;
  s.add(near).add(distant, 4).cut(hole, 1);
  for (double x = 0; x < 50; x += 0.7)
    for (double y = -8; y < 8; y += 0.7)
    {
      const Vec3 p(x, y, 0.3);
      const double all = smooth_subtraction(smooth_union(near.distance(p), distant.distance(p), 4),
                                            hole.distance(p), 1);
      EXPECT_DOUBLE_EQ(s.distance(p), all);
    }
}

} // namespace
