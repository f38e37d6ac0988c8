#include "Meshing/isosurface.hpp"

#include "Core/geometry/vectors.hpp"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace f2b
{
namespace
{

struct Edge
{
  vtkIdType low, high;
  int direction; ///< +1 from low to high in its triangle
  bool same_ends(const Edge& other) const { return low == other.low && high == other.high; }
};

std::vector<std::array<vtkIdType, 3>> triangles_of(vtkPolyData* surface)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  auto iterator = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    const vtkIdType* corners = nullptr;
    vtkIdType count = 0;
    iterator->GetCurrentCell(count, corners);
    for (vtkIdType c = 2; c < count; ++c)
      triangles.push_back({corners[0], corners[c - 1], corners[c]});
  }
  return triangles;
}

Vec3 position(vtkPolyData* surface, vtkIdType point)
{
  Vec3 p;
  surface->GetPoint(point, p.data());
  return p;
}

void count_edges(const std::vector<std::array<vtkIdType, 3>>& triangles, SurfaceCheck& check)
{
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& t : triangles)
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType a = t[c], b = t[(c + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b)
            { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
  {
    int directions = 0;
    for (next = first; next < edges.size() && edges[next].same_ends(edges[first]); ++next)
      directions += edges[next].direction;
    const std::size_t uses = next - first;
    check.open_edges += uses == 1;
    check.non_manifold_edges += uses > 2 || (uses == 2 && directions != 0);
  }
}

std::size_t count_components(const std::vector<std::array<vtkIdType, 3>>& triangles,
                             std::size_t points)
{
  std::vector<vtkIdType> parent(points);
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](vtkIdType p)
  {
    while (parent[p] != p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  std::vector<char> used(points, 0);
  for (const auto& t : triangles)
    for (int c = 0; c < 3; ++c)
    {
      used[t[c]] = 1;
      parent[root(t[c])] = root(t[0]);
    }
  std::size_t components = 0;
  for (std::size_t p = 0; p < points; ++p)
    components += used[p] && parent[p] == static_cast<vtkIdType>(p);
  return components;
}

} // namespace

SurfaceCheck check_surface(vtkPolyData* surface)
{
  SurfaceCheck check;
  const auto triangles = triangles_of(surface);
  count_edges(triangles, check);
  check.components =
      count_components(triangles, static_cast<std::size_t>(surface->GetNumberOfPoints()));
  if (triangles.empty())
    return check;
  const Vec3 centre = position(surface, triangles[0][0]);
  for (const auto& t : triangles)
  {
    const Vec3 a = position(surface, t[0]) - centre, b = position(surface, t[1]) - centre,
               c = position(surface, t[2]) - centre;
    check.area_mm2 += 0.5 * (b - a).cross(c - a).norm();
    check.volume_mm3 += a.dot(b.cross(c)) / 6.0;
  }
  return check;
}

} // namespace f2b
