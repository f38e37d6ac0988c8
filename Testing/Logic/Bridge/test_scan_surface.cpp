#include <Bridge/scan_surface.hpp>
#include <Bridge/vtk_surface.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

/// A square of the plane z = 2 in two triangles per cell, each with corners of its own as in .stl.
vtkSmartPointer<vtkPolyData> square_scan()
{
  TriangleMesh mesh;
  auto add = [&](double x, double y)
  {
    mesh.points.emplace_back(x, y, 2.0);
    return int(mesh.points.size()) - 1;
  };
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
    {
      mesh.triangles.push_back({add(i, j), add(i + 1, j), add(i + 1, j + 1)});
      mesh.triangles.push_back({add(i, j), add(i + 1, j + 1), add(i, j + 1)});
    }
  return to_polydata(mesh);
}

TEST(ScanSurface, FindsTheFootItsNormalAndTheBorder)
{
  const ScanSurface scan(square_scan());
  const ScanSurface::Foot inside = scan.nearest({4.3, 5.6, 7});
  EXPECT_LT((inside.point - Vec3(4.3, 5.6, 2)).norm(), 1e-12);
  EXPECT_LT((inside.normal - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_FALSE(inside.is_on_border);
  EXPECT_FALSE(scan.nearest({5, 5, -3}).is_on_border); // a corner that six triangles share
  const ScanSurface::Foot beside = scan.nearest({12, 5.5, 2});
  EXPECT_LT((beside.point - Vec3(10, 5.5, 2)).norm(), 1e-12);
  EXPECT_TRUE(beside.is_on_border);
}

TEST(ScanSurface, SkinCountsWhereTheScanFacesItWithinReach)
{
  const auto scan = std::make_shared<const ScanSurface>(square_scan());
  const std::vector<Vec3> rest = {{5, 5, 1}, {5, 5, -40}, {5, 5, 1}, {15, 5, 2}};
  const std::vector<Vec3> normals = {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitZ()};
  const SkinTarget target = target_on_scan(scan, rest, normals, 30);
  EXPECT_EQ(target.weight, (std::vector<double>{1, 0, 0, 0}));
  EXPECT_LT((target.displacement[0] - Vec3::UnitZ()).norm(), 1e-12);
  const NearestTarget moved = target.nearest(0, {1, 0, 0.5});
  EXPECT_LT((moved.displacement - Vec3(1, 0, 1)).norm(), 1e-12);
}

} // namespace
} // namespace f2b
