#pragma once

#include "Core/mesh/mixed_mesh.hpp"

#include <algorithm>

/// Structured bodies of one tissue for benchmark problems.
namespace f2b::testing
{

/// A grid of nx x ny x nz cells whose nodes are where `place(r, s, t)`, r, s, t in [0, 1], says.
struct Block
{
  int nx = 1, ny = 1, nz = 1;

  int id(int i, int j, int k) const { return (k * (ny + 1) + j) * (nx + 1) + i; }

  template <class Place>
  void add_nodes(MixedMesh& mesh, const Place& place) const
  {
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
        {
          mesh.X.push_back(place(double(i) / nx, double(j) / ny, double(k) / nz));
          mesh.node_boundary.push_back(Boundary::Interior);
          mesh.node_fragment.push_back(-1);
        }
  }
  /// Calls visit(i, j, k) for every cell.
  template <class Visit>
  void for_each_cell(const Visit& visit) const
  {
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          visit(i, j, k);
  }
};

/// Six tetrahedra a cell.
template <class Place>
MixedMesh tet_block(const Block& block, const Place& place)
{
  static const int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  MixedMesh mesh;
  block.add_nodes(mesh, place);
  block.for_each_cell(
      [&](int i, int j, int k)
      {
        for (const auto& path : paths)
        {
          int at[3] = {i, j, k};
          std::array<int, 4> tet{block.id(i, j, k), 0, 0, 0};
          for (std::size_t step = 0; step < 3; ++step)
          {
            ++at[path[step]];
            tet[step + 1] = block.id(at[0], at[1], at[2]);
          }
          auto X = [&](std::size_t c) { return mesh.X[std::size_t(tet[c])]; };
          if (tet_volume6(X(0), X(1), X(2), X(3)) < 0)
            std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
          mesh.tet_tissue.push_back(Tissue::Fat);
        }
      });
  return mesh;
}

/// Two prisms a cell, their faces towards +t, in `nz` layers.
template <class Place>
MixedMesh prism_block(const Block& block, const Place& place)
{
  MixedMesh mesh;
  block.add_nodes(mesh, place);
  block.for_each_cell(
      [&](int i, int j, int k)
      {
        auto prism = [&](std::array<int, 3> a, std::array<int, 3> b)
        {
          std::array<int, 6> corners{};
          for (std::size_t c = 0; c < 3; ++c)
          {
            corners[c] = block.id(i + a[c], j + b[c], k + 1);
            corners[c + 3] = block.id(i + a[c], j + b[c], k);
          }
          mesh.prisms.push_back(corners);
        };
        prism({0, 1, 1}, {0, 0, 1});
        prism({0, 1, 0}, {0, 1, 1});
      });
  return mesh;
}

} // namespace f2b::testing
