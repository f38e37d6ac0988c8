#pragma once

#include "Core/mesh/mixed_mesh.hpp"

#include <map>

/// A ball of soft tissue in a skin of prisms: curved skin all around.
namespace f2b::testing
{

/// Icosahedron with its faces split `levels` times into four, on the unit sphere.
inline TriangleMesh make_icosphere(int levels)
{
  const double g = 0.5 * (1 + std::sqrt(5.0));
  TriangleMesh sphere;
  sphere.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  sphere.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<int, int>, int> middles;
    auto middle = [&](int a, int b)
    {
      const auto [entry, is_new] =
          middles.emplace(std::minmax(a, b), static_cast<int>(sphere.points.size()));
      if (is_new)
        sphere.points.push_back(sphere.points[std::size_t(a)] + sphere.points[std::size_t(b)]);
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : sphere.triangles)
    {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& part :
           {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
        finer.push_back(part);
    }
    sphere.triangles = finer;
    for (Vec3& p : sphere.points)
      p.normalize();
  }
  return sphere;
}

/// Node 0 is the centre, then the nodes under the skin, then the face.
inline MixedMesh make_ball(int levels, double radius_mm, double skin_mm)
{
  const TriangleMesh sphere = make_icosphere(levels);
  const int n = static_cast<int>(sphere.points.size());
  MixedMesh mesh;
  mesh.X = {Vec3::Zero()};
  for (const double radius : {radius_mm - skin_mm, radius_mm})
    for (const Vec3& p : sphere.points)
      mesh.X.push_back(radius * p);
  for (const auto& [a, b, c] : sphere.triangles)
  {
    mesh.prisms.push_back({1 + n + a, 1 + n + b, 1 + n + c, 1 + a, 1 + b, 1 + c});
    mesh.tets.push_back({0, 1 + a, 1 + b, 1 + c});
  }
  mesh.tet_tissue.assign(mesh.tets.size(), Tissue::Fat);
  mesh.node_boundary.assign(mesh.X.size(), Boundary::Interior);
  mesh.node_fragment.assign(mesh.X.size(), -1);
  for (int node = 1 + n; node < mesh.node_count(); ++node)
    mesh.node_boundary[std::size_t(node)] = Boundary::Skin;
  return mesh;
}

} // namespace f2b::testing
