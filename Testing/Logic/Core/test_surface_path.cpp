#include "Logic/Core/flat_sheet.hpp"
#include "Logic/Core/sphere_mesh.hpp"

#include <Core/sculpting/surface_path.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

double length_of(const std::vector<Vec3>& line)
{
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += (line[i] - line[i - 1]).norm();
  return length;
}

struct Surface
{
  explicit Surface(TriangleMesh m)
      : mesh(std::move(m)), links(mesh.points.size(), mesh.triangles), tree(mesh)
  {
  }
  std::vector<Vec3> path(const Vec3& from, const Vec3& to) const
  {
    return surface_path(mesh, links, tree, tree.nearest(from), tree.nearest(to), 1.5);
  }
  TriangleMesh mesh;
  SurfaceLinks links;
  SurfaceTree tree;
};

TEST(SurfacePath, IsStraightOnAPlane)
{
  const Surface sheet(testing::make_sheet(60, 60));
  const Vec3 from(-20.3, 0, -11.2), to(23.1, 0, 17.7);
  const auto line = sheet.path(from, to);
  ASSERT_GT(line.size(), 20u);
  EXPECT_EQ(line.front(), from);
  EXPECT_EQ(line.back(), to);
  EXPECT_LT(length_of(line), 1.001 * (to - from).norm());
}

TEST(SurfacePath, IsAGreatCircleOnASphere)
{
  TriangleMesh ball = testing::icosphere(4);
  for (Vec3& p : ball.points)
    p *= 40;
  const Surface sphere(std::move(ball));
  const auto line = sphere.path({40, 0, 0}, {0, 40, 5});
  const double arc = 40 * std::acos(line.front().normalized().dot(line.back().normalized()));
  EXPECT_NEAR(length_of(line), arc, 0.01 * arc);
  for (const Vec3& p : line)
    EXPECT_LT(sphere.tree.nearest(p).distance, 1e-9);
}

TEST(SurfacePath, StaysOnItsOwnSideOfASlit)
{
  // two sheets 1 mm apart: no way leads from one to the other
  TriangleMesh two = testing::make_sheet(20, 40);
  const TriangleMesh other = testing::make_sheet(20, 40, [](double, double) { return 1.0; });
  const int shift = static_cast<int>(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const Surface sheets(std::move(two));
  EXPECT_TRUE(sheets.path({-10, 0, 0}, {10, 1, 0}).empty());
  EXPECT_FALSE(sheets.path({-10, 1, 0}, {10, 1, 0}).empty());
}

TEST(SurfacePath, OfOnePlaceIsThatPlace)
{
  const Surface sheet(testing::make_sheet(20, 40));
  EXPECT_EQ(sheet.path({1, 0, 1}, {1, 0, 1}).size(), 2u);
  EXPECT_GE(sheet.path({1, 0, 1}, {1.2, 0, 1.1}).size(), 2u);
}

} // namespace
} // namespace f2b
