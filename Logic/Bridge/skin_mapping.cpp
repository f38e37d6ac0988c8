#include "Bridge/skin_mapping.hpp"

#include "Bridge/vtk_surface.hpp"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <cmath>

namespace f2b
{
namespace
{

Vec3 area_coordinates(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 n = (b - a).cross(c - a);
  const double doubled = n.squaredNorm();
  Vec3 w;
  w[0] = (b - p).cross(c - p).dot(n) / doubled;
  w[1] = (c - p).cross(a - p).dot(n) / doubled;
  w[2] = 1 - w[0] - w[1];
  return w;
}

} // namespace

SkinMap map_skin(const MixedMesh& mesh, const std::vector<Vec3>& reference_skin, double reach_mm)
{
  TriangleMesh tops;
  tops.points = mesh.X;
  for (const auto& prism : mesh.prisms)
    tops.triangles.push_back({prism[0], prism[1], prism[2]});
  const vtkSmartPointer<vtkPolyData> surface = to_polydata(tops);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;

  SkinMap map;
  map.places.resize(reference_skin.size());
  for (std::size_t v = 0; v < reference_skin.size(); ++v)
  {
    Vec3 nearest;
    vtkIdType id = -1;
    int sub = 0;
    double squared = 0;
    locator->FindClosestPoint(reference_skin[v].data(), nearest.data(), cell, id, sub, squared);
    if (id < 0 || std::sqrt(squared) > reach_mm)
      continue;
    const Triangle& t = tops.triangles[static_cast<std::size_t>(id)];
    auto corner = [&](std::size_t i) { return mesh.X[static_cast<std::size_t>(t[i])]; };
    map.places[v].prism = static_cast<int>(id);
    map.places[v].weights = area_coordinates(nearest, corner(0), corner(1), corner(2));
  }
  return map;
}

} // namespace f2b
