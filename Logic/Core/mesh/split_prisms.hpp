#pragma once

#include "Core/mesh/mixed_mesh.hpp"

/// What is the mesh of the models that know tetrahedra only (paper section 3.2: LFEM, MTM, NFEM)?
namespace f2b
{

/// How the lateral quads of a prism are cut: flag i says that the diagonal of the quad below the
/// edge from corner i to corner i + 1 starts at the top of i; else at the top of i + 1. Three equal
/// flags are no split: no tetrahedron fits into such a prism.
using PrismCut = std::array<bool, 3>;

/// The cut whose diagonals all start at the smallest node of their quad: two prisms that share a
/// quad cut it alike, and the smallest node of all lies on two diagonals, so it never is cyclic.
/// Reference: J. Dompierre, P. Labbe, M.-G. Vallet, R. Camarero, "How to subdivide pyramids, prisms
/// and hexahedra into tetrahedra", 8th Int. Meshing Roundtable (1999).
PrismCut cut_by_node_number(const std::array<int, 6>& prism);

/// The three tetrahedra of one prism, positively oriented where it is not too warped. The triangles
/// stay whole. The flags are not all equal.
std::array<std::array<int, 4>, 3> split_prism(const std::array<int, 6>& prism, const PrismCut& cut);

/// The same nodes and tissue with tetrahedra only: those of the mesh first, then three a prism in
/// the order of the prisms, whose tissue is Skin. Conforming if the mesh is.
///
/// Cuts are by node number, but where that leaves a tetrahedron inverted or under a twentieth of
/// its prism's mean, quads of that prism are cut otherwise, and those of its neighbours where they
/// must follow. Throws Error if a prism is so warped that this does not help.
MixedMesh split_prisms(const MixedMesh& mesh);

} // namespace f2b
