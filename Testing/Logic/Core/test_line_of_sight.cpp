#include <Core/sculpting/line_of_sight.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

const double pi = 3.14159265358979323846;

TEST(LineOfSight, FindsThePlaceOnAnAxisThatIsSeen)
{
  const LineOfSight line{{3, 100, 7}, {0, -1, 0}};
  EXPECT_NEAR(*along_axis(line, {0, 0, 7}, {1, 0, 0}), 3, 1e-12);
  EXPECT_NEAR(*along_axis(line, {1, 20, 0}, {0, 0, 1}), 7, 1e-12);
  EXPECT_FALSE(along_axis(line, {0, 0, 0}, {0, 1, 0}));
}

TEST(LineOfSight, MeetsAPlaneInFrontOfTheEye)
{
  const LineOfSight line{{3, 100, 7}, {0, -1, 0}};
  EXPECT_LT((*on_plane(line, {0, 5, 0}, {0, 1, 0}) - Vec3(3, 5, 7)).norm(), 1e-12);
  EXPECT_FALSE(on_plane(line, {0, 200, 0}, {0, 1, 0}));
  EXPECT_FALSE(on_plane(line, {0, 0, 0}, {1, 0, 0}));
}

TEST(LineOfSight, AnglesAreRightHanded)
{
  const Vec3 c(1, 2, 3);
  EXPECT_NEAR(angle_about(c, Vec3::UnitZ(), c + Vec3(2, 0, 5), c + Vec3(0, 1, 0)), pi / 2, 1e-12);
  EXPECT_NEAR(angle_about(c, Vec3::UnitZ(), c + Vec3(0, 2, 0), c + Vec3(1, 0, -4)), -pi / 2, 1e-12);
  EXPECT_EQ(angle_about(c, Vec3::UnitZ(), c, c + Vec3(1, 0, 0)), 0);
}

} // namespace
} // namespace f2b
