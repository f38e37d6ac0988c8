#include "Logic/Core/flat_sheet.hpp"

#include <Core/sculpting/brush_area.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

BrushArea area_on(const SculptedSkin& skin, const Brush& brush, const Vec3& near,
                  const Vec3& view = Vec3::Zero())
{
  GeodesicDistance distances(skin.links());
  return brush_area(skin, brush, skin.tree().nearest(near), view, distances);
}

Brush brush_of(double radius)
{
  Brush brush;
  brush.radius_mm = radius;
  return brush;
}

TEST(Falloff, GoesFromOneToZeroAndNeverBelow)
{
  for (const Falloff curve :
       {Falloff::Smooth, Falloff::Sphere, Falloff::Linear, Falloff::Sharp, Falloff::Constant})
  {
    EXPECT_EQ(falloff(curve, 0), 1);
    EXPECT_EQ(falloff(curve, 1), 0);
    EXPECT_EQ(falloff(curve, std::nan("")), 0);
    for (double t = 0; t < 1; t += 0.1)
      EXPECT_LE(falloff(curve, t + 0.1), falloff(curve, t));
  }
}

TEST(ElasticDrag, IsTheDragInTheMiddleAndFadesWithTheCube)
{
  const Vec3 drag(1, -2, 3);
  EXPECT_LT((elastic_drag(Vec3::Zero(), drag, 12) - drag).norm(), 1e-14);
  const Vec3 far(300, 200, -100);
  EXPECT_NEAR(elastic_drag(2 * far, drag, 12).norm() / elastic_drag(far, drag, 12).norm(), 1 / 8.0,
              0.01);
}

TEST(BrushArea, IsADiscOnFlatSkin)
{
  const SculptedSkin skin(testing::make_sheet(80, 80), {});
  const BrushArea area = area_on(skin, brush_of(10), {3, 0, -4});
  for (const BrushedVertex& b : area.vertices)
  {
    const double r = (skin.points()[std::size_t(b.vertex)] - Vec3(3, 0, -4)).norm();
    EXPECT_NEAR(b.weight, falloff(Falloff::Smooth, r / 10), 0.02) << r;
  }
  EXPECT_NEAR(static_cast<double>(area.vertices.size()), 3.14159 * 100, 12);
}

TEST(BrushArea, DoesNotCrossTheMouth)
{
  // a fold 20 mm deep and 2 mm wide between two lips
  const SculptedSkin skin(
      testing::make_sheet(80, 80, [](double, double s) { return std::abs(s) < 1.5 ? -20.0 : 0.0; }),
      {});
  const BrushArea area = area_on(skin, brush_of(12), {0, 0, 4});
  EXPECT_GT(area.vertices.size(), 150u);
  for (const BrushedVertex& b : area.vertices)
    EXPECT_GT(skin.points()[std::size_t(b.vertex)].z(), 0);
}

TEST(BrushArea, LeavesSkinThatFacesAwayOrLiesBehind)
{
  // a ridge: one flank is seen from the side, the other is not
  const SculptedSkin skin(
      testing::make_sheet(60, 60, [](double r, double) { return 10 - std::abs(r); }), {});
  const Vec3 from_the_right(-1, 0, 0);
  Brush brush = brush_of(15);
  for (const BrushedVertex& b : area_on(skin, brush, {3, 7, 0}, from_the_right).vertices)
    EXPECT_GE(skin.points()[std::size_t(b.vertex)].x(), -1e-9);
  brush.front_faces_only = false;
  int behind = 0;
  for (const BrushedVertex& b : area_on(skin, brush, {3, 7, 0}, from_the_right).vertices)
    behind += skin.points()[std::size_t(b.vertex)].x() < -1;
  EXPECT_GT(behind, 50);
  brush.depth_mm = 4;
  for (const BrushedVertex& b : area_on(skin, brush, {3, 7, 0}, from_the_right).vertices)
    EXPECT_GE(skin.points()[std::size_t(b.vertex)].x(), -1 - 1e-9);
}

TEST(BrushArea, SymmetricBrushHasTwoEqualSides)
{
  const SculptedSkin skin(testing::make_sheet(80, 80), {});
  Brush brush = brush_of(10);
  brush.symmetry = SymmetryPlane{};
  const BrushArea area = area_on(skin, brush, {4, 0, 2});
  ASSERT_TRUE(area.mirror);
  EXPECT_LT((area.mirror->point - Vec3(-4, 0, 2)).norm(), 1e-9);
  for (const BrushedVertex& b : area.vertices)
  {
    const int row = b.vertex / 81, column = b.vertex % 81;
    const int partner = row * 81 + 80 - column;
    const auto found = std::find_if(area.vertices.begin(), area.vertices.end(),
                                    [&](const BrushedVertex& o) { return o.vertex == partner; });
    ASSERT_NE(found, area.vertices.end());
    EXPECT_NEAR(found->weight, b.weight, 1e-9);
    EXPECT_NEAR(found->mirrored_share, 1 - b.mirrored_share, 1e-9);
  }
}

} // namespace
} // namespace f2b
