#pragma once

#include "Core/inverse/face_model.hpp"

/// A slab of soft tissue on bone, with skin on top: the smallest face that the planner can plan.
namespace f2b::testing
{

struct SlabOptions
{
  int cells = 6;  ///< along R and A
  int layers = 2; ///< of tissue, along S
  double size_mm = 60;
  double tissue_mm = 12;
  double skin_mm = 1.5;
  double dome_mm = 0;          ///< height of a dome over the slab, for curved skin
  double fragment_share = 0.5; ///< of the width, centred: the bone that moves
  int fragments = 1;           ///< 2: it is cut in two halves, right and left
};

/// Five tetrahedra a cell would not conform; six do. The face points to +S.
inline MixedMesh make_slab(const SlabOptions& o)
{
  MixedMesh mesh;
  const int n = o.cells + 1;
  const int levels = o.layers + 2; // bone level, ..., skin bottom, skin top
  auto id = [&](int i, int j, int k) { return (k * n + j) * n + i; };
  for (int k = 0; k < levels; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double r = o.size_mm * (double(i) / o.cells - 0.5);
        const double a = o.size_mm * (double(j) / o.cells - 0.5);
        const double s = k <= o.layers ? o.tissue_mm * k / o.layers : o.tissue_mm + o.skin_mm;
        const double dome =
            o.dome_mm * (1 - (r * r + a * a) / (0.5 * o.size_mm * o.size_mm)) * s / o.tissue_mm;
        mesh.X.emplace_back(r, a, s + dome);
        const bool wall = i == 0 || j == 0 || i == o.cells || j == o.cells;
        const double cut_mm = o.fragments == 2 ? 5 : -1; // half of what is released along it
        const bool fragment =
            k == 0 && std::max(std::abs(r), std::abs(a)) < 0.5 * o.fragment_share * o.size_mm &&
            std::abs(r) > cut_mm;
        const bool released =
            k == 0 && !fragment &&
            std::max(std::abs(r), std::abs(a)) < 0.5 * o.fragment_share * o.size_mm + 11;
        mesh.node_boundary.push_back(wall              ? Boundary::Crop
                                     : fragment        ? Boundary::Fragment
                                     : released        ? Boundary::Free
                                     : k == 0          ? Boundary::FixedBone
                                     : k == levels - 1 ? Boundary::Skin
                                                       : Boundary::Interior);
        mesh.node_fragment.push_back(wall || !fragment ? -1 : o.fragments == 2 && r > 0 ? 1 : 0);
      }
  mesh.fragments = {"block"};
  if (o.fragments == 2)
    mesh.fragments = {"left", "right"};
  static const int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int k = 0; k < o.layers; ++k)
    for (int j = 0; j < o.cells; ++j)
      for (int i = 0; i < o.cells; ++i)
        for (const auto& path : paths)
        {
          int at[3] = {i, j, k};
          std::array<int, 4> tet{id(i, j, k), 0, 0, 0};
          for (std::size_t step = 0; step < 3; ++step)
          {
            ++at[path[step]];
            tet[step + 1] = id(at[0], at[1], at[2]);
          }
          auto X = [&](int c) { return mesh.X[std::size_t(tet[std::size_t(c)])]; };
          if (tet_volume6(X(0), X(1), X(2), X(3)) < 0)
            std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
          mesh.tet_tissue.push_back(k % 2 ? Tissue::Fat : Tissue::Muscle);
        }
  const int bottom = o.layers, top = o.layers + 1;
  for (int j = 0; j < o.cells; ++j)
    for (int i = 0; i < o.cells; ++i)
    {
      // the same diagonal as the tetrahedra's top faces
      const int c[2][3][2] = {{{i, j}, {i + 1, j}, {i + 1, j + 1}},
                              {{i, j}, {i + 1, j + 1}, {i, j + 1}}};
      for (const auto& f : c)
        mesh.prisms.push_back({id(f[0][0], f[0][1], top), id(f[1][0], f[1][1], top),
                               id(f[2][0], f[2][1], top), id(f[0][0], f[0][1], bottom),
                               id(f[1][0], f[1][1], bottom), id(f[2][0], f[2][1], bottom)});
    }
  return mesh;
}

/// One soft material for every tissue, nearly incompressible.
inline MaterialSet soft_material(double poisson_ratio = 0.45)
{
  MaterialSet set;
  set.name = "test";
  set.laws.fill(
      Yeoh{{0.01, 0.004, 0.002}, {VolumetricLaw::Kind::Barrier, bulk_from(0.02, poisson_ratio)}});
  return set;
}

/// The reference skin is the mesh's own skin: one vertex per top corner of each prism.
inline SkinMap corner_map(const MixedMesh& mesh)
{
  SkinMap map;
  for (std::size_t p = 0; p < mesh.prisms.size(); ++p)
    for (int c = 0; c < 3; ++c)
      map.places.push_back({int(p), Vec3::Unit(c)});
  return map;
}

} // namespace f2b::testing
