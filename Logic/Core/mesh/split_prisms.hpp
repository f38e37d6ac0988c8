#pragma once

#include "Core/mesh/mixed_mesh.hpp"

/// What is the mesh of the models that know tetrahedra only (paper section 3.2: LFEM, MTM, NFEM)?
namespace f2b
{

/// The three tetrahedra of one prism, positively oriented where the prism is convex.
///
/// Each lateral quad is cut along the diagonal from its smallest node, so two prisms that share a
/// quad cut it alike; the node that is smallest of all lies on two diagonals, so the third quad may
/// have either. The triangles stay whole. Reference: J. Dompierre, P. Labbe, M.-G. Vallet,
/// R. Camarero, "How to subdivide pyramids, prisms and hexahedra into tetrahedra", 8th Int. Meshing
/// Roundtable (1999).
std::array<std::array<int, 4>, 3> split_prism(const std::array<int, 6>& prism);

/// The same nodes and tissue with tetrahedra only: those of the mesh first, then three a prism in
/// the order of the prisms, whose tissue is Skin. Conforming if the mesh is.
///
/// Throws Error if a prism is so warped that one of its three is flat or inverted at rest.
MixedMesh split_prisms(const MixedMesh& mesh);

} // namespace f2b
