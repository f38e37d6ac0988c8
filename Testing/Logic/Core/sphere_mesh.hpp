#pragma once

#include "Core/mesh/mixed_mesh.hpp"

#include <cmath>
#include <map>

/// A hollow sphere of soft tissue under skin: every curvature is known.
namespace f2b::testing
{

struct SphereOptions
{
  int subdivisions = 2; ///< of an icosahedron: 20 * 4^n faces
  int layers = 3;       ///< of tetrahedra between the two radii, of equal thickness
  double inner_mm = 20;
  double outer_mm = 30; ///< of the tetrahedra; the skin lies outside
  double skin_mm = 1.5; ///< 0: no skin
};

/// Triangles of a unit icosphere, counter-clockwise seen from outside.
inline TriangleMesh icosphere(int subdivisions)
{
  const double g = 0.5 * (1 + std::sqrt(5.0));
  TriangleMesh sphere;
  sphere.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  sphere.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < subdivisions; ++level)
  {
    std::map<std::pair<int, int>, int> middles;
    auto middle = [&](int a, int b)
    {
      const auto [entry, fresh] =
          middles.emplace(std::minmax(a, b), static_cast<int>(sphere.points.size()));
      if (fresh)
        sphere.points.push_back(0.5 *
                                (sphere.points[std::size_t(a)] + sphere.points[std::size_t(b)]));
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : sphere.triangles)
    {
      const int m[3] = {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
      finer.insert(
          finer.end(),
          {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}, {m[0], m[1], m[2]}});
    }
    sphere.triangles = std::move(finer);
    for (Vec3& p : sphere.points)
      p.normalize();
  }
  for (Vec3& p : sphere.points)
    p.normalize();
  return sphere;
}

/// Nodes level by level from the inside; the innermost are FixedBone, the outermost Skin.
inline MixedMesh make_sphere(const SphereOptions& o)
{
  const TriangleMesh unit = icosphere(o.subdivisions);
  const int n = static_cast<int>(unit.points.size());
  const int levels = o.layers + (o.skin_mm > 0 ? 2 : 1);
  MixedMesh mesh;
  for (int k = 0; k < levels; ++k)
    for (const Vec3& p : unit.points)
    {
      const double inside = o.inner_mm + (o.outer_mm - o.inner_mm) * k / o.layers;
      mesh.X.push_back(p * (k <= o.layers ? inside : o.outer_mm + o.skin_mm));
      mesh.node_boundary.push_back(k == 0            ? Boundary::FixedBone
                                   : k == levels - 1 ? Boundary::Skin
                                                     : Boundary::Interior);
      mesh.node_fragment.push_back(-1);
    }
  for (const auto& face : unit.triangles)
  {
    // every lateral face is cut from its lower corner at the smaller index: neighbours agree
    std::array<int, 3> s = face;
    std::sort(s.begin(), s.end());
    for (int k = 0; k < o.layers; ++k)
    {
      auto low = [&](int i) { return k * n + s[std::size_t(i)]; };
      auto high = [&](int i) { return (k + 1) * n + s[std::size_t(i)]; };
      for (std::array<int, 4> tet : {std::array<int, 4>{low(0), low(1), low(2), high(2)},
                                     {low(0), low(1), high(1), high(2)},
                                     {low(0), high(0), high(1), high(2)}})
      {
        auto X = [&](int c) { return mesh.X[std::size_t(tet[std::size_t(c)])]; };
        if (tet_volume6(X(0), X(1), X(2), X(3)) < 0)
          std::swap(tet[2], tet[3]);
        mesh.tets.push_back(tet);
        mesh.tet_tissue.push_back(Tissue::Fat);
      }
    }
    if (o.skin_mm > 0)
    {
      const int top = (o.layers + 1) * n, bottom = o.layers * n;
      mesh.prisms.push_back({top + face[0], top + face[1], top + face[2], bottom + face[0],
                             bottom + face[1], bottom + face[2]});
    }
  }
  return mesh;
}

} // namespace f2b::testing
