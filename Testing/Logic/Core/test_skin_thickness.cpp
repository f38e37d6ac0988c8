#include "Core/geometry/skin_thickness.hpp"

#include "sphere_mesh.hpp"

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

TEST(SkinThickness, IsThatOfThePartWithinItAndChangesSmoothlyBetweenParts)
{
  TriangleMesh skin = testing::icosphere(4);
  for (Vec3& p : skin.points)
    p *= 60;
  std::vector<double> of_vertex;
  for (const Vec3& p : skin.points)
    of_vertex.push_back(std::abs(p.x()) < 1e-9 ? 2 : p.x() < 0 ? 1 : 3);
  const ScalarGrid map = skin_thickness(skin, of_vertex, 1.5);
  EXPECT_NEAR(map.value({-60, 0, 0}), 1, 1e-6);
  EXPECT_NEAR(map.value({60, 0, 0}), 3, 1e-6);
  EXPECT_NEAR(map.value({0, 58, 0}), 2, 0.1);
  double before = 1;
  for (double x = -20; x <= 20; x += 0.5)
  {
    const double here = map.value({x, std::sqrt(60 * 60 - x * x), 0});
    EXPECT_GE(here, before - 1e-6);
    EXPECT_LT(here, before + 0.15);
    before = here;
  }
  EXPECT_EQ(map.value({0, 0, 0}), 1.5f) << "far from all skin";
}

} // namespace
} // namespace f2b
