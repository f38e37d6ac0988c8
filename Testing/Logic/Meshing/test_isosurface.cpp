#include "Meshing/isosurface.hpp"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>

namespace f2b
{
namespace
{

template <class Distance>
ScalarGrid grid_of(int n, double spacing, Distance distance)
{
  ScalarGrid grid{Vec3::Constant(-0.5 * (n - 1) * spacing), spacing, {n, n, n}, {}};
  grid.values.resize(grid.count());
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        grid.values[grid.index(i, j, k)] = static_cast<float>(distance(grid.position(i, j, k)));
  return grid;
}

double sphere(const Vec3& p)
{
  return p.norm() - 20.0;
}

const double pi = std::acos(-1.0);

void expect_watertight(const SurfaceCheck& check)
{
  EXPECT_EQ(check.open_edges, 0U);
  EXPECT_EQ(check.non_manifold_edges, 0U);
}

TEST(Isosurface, SphereIsClosedAndOfTheRightSize)
{
  const auto surface = watertight_isosurface(grid_of(51, 1.0, sphere));
  const SurfaceCheck check = check_surface(surface);
  expect_watertight(check);
  EXPECT_EQ(check.components, 1U);
  EXPECT_NEAR(check.area_mm2, 4 * pi * 400, 0.01 * 4 * pi * 400);
  EXPECT_NEAR(check.volume_mm3, 4 * pi * 8000 / 3, 0.01 * 4 * pi * 8000 / 3);
}

TEST(Isosurface, LevelsAreOffsets)
{
  const auto surface = watertight_isosurface(grid_of(51, 1.0, sphere), -1.5);
  EXPECT_NEAR(check_surface(surface).volume_mm3, 4 * pi * std::pow(18.5, 3) / 3, 300);
}

TEST(Isosurface, BodyThatIsCutByTheWallsIsClosedThere)
{
  const auto surface = watertight_isosurface(grid_of(31, 1.0, sphere));
  const SurfaceCheck check = check_surface(surface);
  expect_watertight(check);
  double bounds[6];
  surface->GetBounds(bounds);
  for (int a = 0; a < 6; ++a)
    EXPECT_NEAR(std::abs(bounds[a]), 15.0, 0.3);
}

TEST(Isosurface, DecimationKeepsItClosedAndInPlace)
{
  SurfaceOptions options;
  options.target_edge_mm = 3.0;
  auto bumpy = [](const Vec3& p)
  { return p.norm() - 20.0 - 1.5 * std::sin(0.7 * p.x()) * std::cos(0.9 * p.z()); };
  const ScalarGrid grid = grid_of(61, 1.0, bumpy);
  const auto fine = watertight_isosurface(grid);
  const auto coarse = watertight_isosurface(grid, 0.0, options);
  const SurfaceCheck check = check_surface(coarse);
  expect_watertight(check);
  EXPECT_LT(coarse->GetNumberOfPolys(), fine->GetNumberOfPolys() / 5);
  EXPECT_NEAR(check.volume_mm3, check_surface(fine).volume_mm3, 0.01 * check.volume_mm3);
}

TEST(Isosurface, DecimationKeepsTheHoleOfAThinTorus)
{
  auto torus = [](const Vec3& p)
  { return std::hypot(std::hypot(p.x(), p.y()) - 15.0, p.z()) - 2.0; };
  SurfaceOptions options;
  options.target_edge_mm = 8.0;
  const auto surface = watertight_isosurface(grid_of(41, 1.0, torus), 0.0, options);
  expect_watertight(check_surface(surface));
  // Euler's characteristic: points - edges + triangles = 0, with three edges to two triangles.
  EXPECT_EQ(2 * surface->GetNumberOfPoints(), surface->GetNumberOfPolys());
}

TEST(Isosurface, NormalsPointOutwards)
{
  const auto surface = watertight_isosurface(grid_of(51, 1.0, sphere));
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); p += 17)
  {
    const Vec3 at(surface->GetPoint(p)), normal(normals->GetTuple3(p));
    EXPECT_GT(at.normalized().dot(normal), 0.95);
  }
}

TEST(Isosurface, LargestComponentDropsTheRest)
{
  auto two = [](const Vec3& p)
  { return std::min((p - Vec3(8, 0, 0)).norm() - 9.0, (p + Vec3(14, 0, 0)).norm() - 5.0); };
  const ScalarGrid grid = grid_of(61, 1.0, two);
  EXPECT_EQ(check_surface(watertight_isosurface(grid)).components, 2U);
  SurfaceOptions options;
  options.largest_component = true;
  const SurfaceCheck check = check_surface(watertight_isosurface(grid, 0.0, options));
  EXPECT_EQ(check.components, 1U);
  EXPECT_NEAR(check.volume_mm3, 4 * pi * 729 / 3, 60);
}

TEST(Isosurface, SamplesExactlyOnTheLevelDoNoHarm)
{
  auto box = [](const Vec3& p) { return p.cwiseAbs().maxCoeff() - 10.0; };
  expect_watertight(check_surface(watertight_isosurface(grid_of(31, 1.0, box))));
}

TEST(Isosurface, AnEmptyBodyGivesAnEmptySurface)
{
  const auto surface = watertight_isosurface(grid_of(9, 1.0, [](const Vec3&) { return 1.0; }));
  EXPECT_EQ(surface->GetNumberOfPolys(), 0);
}

} // namespace
} // namespace f2b
