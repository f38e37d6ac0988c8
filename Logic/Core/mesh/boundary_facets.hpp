#pragma once

#include "Core/mesh/mixed_mesh.hpp"

/// Which facets bound a mesh, and is a sheet of triangles one piece without holes?
namespace f2b
{

using Tet = std::array<int, 4>;

/// One face of a tetrahedron.
struct TetFace
{
  Triangle key{}; ///< node indices, ascending
  int tet = -1;
  int opposite = 0; ///< local index of the corner that the face does not have
};

/// All faces of all tetrahedra, ordered by key: the two sides of an inner face are neighbours.
std::vector<TetFace> sorted_tet_faces(const std::vector<Tet>& tets);

/// Face of a positively oriented tetrahedron opposite to a corner, counter-clockwise from outside.
Triangle outward_face(const Tet& tet, int opposite);

/// Faces that belong to exactly one tetrahedron, seen counter-clockwise from outside.
std::vector<Triangle> tet_boundary(const std::vector<Tet>& tets);

/// The whole boundary of a mixed mesh, every facet counter-clockwise from outside.
struct BoundaryFacets
{
  std::vector<Triangle> skin;            ///< tops of the prisms
  std::vector<std::array<int, 4>> sides; ///< prism sides without a neighbour: the rim of the skin
  std::vector<Triangle> inner;           ///< faces of one tetrahedron and no prism
};
BoundaryFacets boundary_facets(const MixedMesh& mesh);

/// Component of each triangle, by shared edges; numbered by first appearance.
std::vector<int> sheet_components(const std::vector<Triangle>& triangles);

/// Closed chains of nodes along edges that only one triangle has.
std::vector<std::vector<int>> boundary_loops(const std::vector<Triangle>& triangles);

/// Nodes whose triangles are not one fan, and the ends of edges with more than two triangles;
/// ascending.
std::vector<int> non_manifold_nodes(const std::vector<Triangle>& triangles);

/// Component of each tetrahedron, by shared faces; numbered by first appearance.
std::vector<int> tet_components(const std::vector<Tet>& tets);

} // namespace f2b
