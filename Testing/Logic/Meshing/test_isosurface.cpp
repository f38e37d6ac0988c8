#include "Meshing/isosurface.hpp"
#include "Meshing/self_crossings.hpp"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
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

/// Samples that are inside alone, all others outside.
ScalarGrid few_inside(const std::vector<Eigen::Vector3i>& inside)
{
  ScalarGrid grid = grid_of(6, 1.0, [](const Vec3&) { return 1.0; });
  for (const Eigen::Vector3i& v : inside)
    grid.values[grid.index(v.x(), v.y(), v.z())] = -1;
  return grid;
}

TEST(Isosurface, BonesThatMeetAtAnEdgeOrCornerOfTheLatticeStayApart)
{
  SurfaceOptions raw;
  raw.smoothing_iterations = 0;
  for (const Eigen::Vector3i& other :
       {Eigen::Vector3i(3, 3, 2), Eigen::Vector3i(3, 2, 3), Eigen::Vector3i(2, 3, 3),
        Eigen::Vector3i(3, 1, 2), Eigen::Vector3i(3, 3, 3), Eigen::Vector3i(1, 3, 3)})
  {
    const SurfaceCheck check =
        check_surface(watertight_isosurface(few_inside({{2, 2, 2}, other}), 0, raw));
    expect_watertight(check);
    EXPECT_EQ(check.components, 2U) << other.transpose();
  }
  EXPECT_EQ(
      check_surface(watertight_isosurface(few_inside({{2, 2, 2}, {3, 2, 2}}), 0, raw)).components,
      1U);
}

TEST(Isosurface, SmoothedThinWallsDoNotCross)
{
  // two shells 0.4 mm apart with folds that smoothing flattens
  auto folded = [](const Vec3& p)
  {
    const double wave = 1.5 * std::sin(p.x() * 1.3) * std::cos(p.y() * 1.1);
    return std::max({std::abs(p.z() - wave) - 0.6, 0.3 - std::abs(p.z() - wave),
                     Vec3(p.x(), p.y(), 0).norm() - 15});
  };
  const auto surface = watertight_isosurface(grid_of(41, 1.0, folded));
  const SurfaceCheck check = check_surface(surface);
  expect_watertight(check);
  TriangleMesh mesh;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    mesh.points.push_back(Vec3(surface->GetPoint(p)));
  for (vtkIdType t = 0; t < surface->GetNumberOfPolys(); ++t)
  {
    vtkNew<vtkIdList> corners;
    surface->GetCellPoints(t, corners);
    mesh.triangles.push_back(
        {int(corners->GetId(0)), int(corners->GetId(1)), int(corners->GetId(2))});
  }
  EXPECT_GT(mesh.triangles.size(), 1000U);
  EXPECT_TRUE(crossing_triangles(mesh).empty());
}

TEST(SelfCrossings, AreFoundAndYieldToWherePointsWere)
{
  // two stacked tetrahedra; the upper one's tip is pushed through the lower one's base
  auto tetrahedron = [](double z, double tip)
  {
    return TriangleMesh{{{0, 0, z}, {4, 0, z}, {0, 4, z}, {1, 1, tip}},
                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  };
  TriangleMesh mesh = tetrahedron(0, 2);
  TriangleMesh upper = tetrahedron(5, 8);
  for (Triangle t : upper.triangles)
    mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  mesh.points.insert(mesh.points.end(), upper.points.begin(), upper.points.end());
  const std::vector<Vec3> rest = mesh.points;
  EXPECT_TRUE(crossing_triangles(mesh).empty());
  mesh.points[3] = {1, 1, 6}; // the lower tip pierces the upper base
  EXPECT_FALSE(crossing_triangles(mesh).empty());
  EXPECT_GE(yield_crossings(mesh, rest), 1U);
  EXPECT_TRUE(crossing_triangles(mesh).empty());
  EXPECT_EQ(mesh.points[3], rest[3]);
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

/// Farthest that a vertex of one surface lies from another.
double farthest(vtkPolyData* from, vtkPolyData* to)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(to);
  locator->BuildLocator();
  double most = 0;
  for (vtkIdType p = 0; p < from->GetNumberOfPoints(); ++p)
  {
    double closest[3], squared = 0;
    vtkIdType cell = 0;
    int sub = 0;
    locator->FindClosestPoint(from->GetPoint(p), closest, cell, sub, squared);
    most = std::max(most, std::sqrt(squared));
  }
  return most;
}

TEST(Isosurface, DecimationKeepsItClosedAndWithinItsError)
{
  auto bumpy = [](const Vec3& p)
  { return p.norm() - 20.0 - 1.5 * std::sin(0.7 * p.x()) * std::cos(0.9 * p.z()); };
  const ScalarGrid grid = grid_of(61, 1.0, bumpy);
  const auto fine = watertight_isosurface(grid);
  vtkIdType fewer = fine->GetNumberOfPolys();
  for (const double error : {0.05, 0.2})
  {
    SurfaceOptions options;
    options.decimation_error_mm = error;
    const auto coarse = watertight_isosurface(grid, 0.0, options);
    const SurfaceCheck check = check_surface(coarse);
    expect_watertight(check);
    EXPECT_LT(coarse->GetNumberOfPolys(), 3 * fewer / 4);
    fewer = coarse->GetNumberOfPolys();
    EXPECT_LT(farthest(coarse, fine), error);
    EXPECT_LT(farthest(fine, coarse), error);
  }
}

TEST(Isosurface, DecimationKeepsTheHoleOfAThinTorus)
{
  auto torus = [](const Vec3& p)
  { return std::hypot(std::hypot(p.x(), p.y()) - 15.0, p.z()) - 2.0; };
  SurfaceOptions options;
  options.decimation_error_mm = 0.5;
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
