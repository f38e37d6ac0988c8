#pragma once

#include "Core/geometry/vectors.hpp"

#include <string>

/// What is the finite-element mesh of the facial shell (paper section 2.2, Fig. 3)?
namespace f2b
{

enum class Tissue : unsigned char
{
  Skin = 0,
  Fat = 1,
  Muscle = 2,
};
inline constexpr int tissue_count = 3;

/// The part of the boundary that a node lies on (paper Fig. 6); one part per node.
enum class Boundary : unsigned char
{
  Interior = 0,  ///< not on the boundary
  Skin = 1,      ///< Gamma_e, the face: top nodes of the prisms
  FixedBone = 2, ///< Gamma_c, tissue on uncut bone
  Fragment = 3,  ///< Gamma_n, tissue on a cut fragment; which one is in `node_fragment`
  Free = 4,      ///< inner surface over a cavity, or released along a cut
  Crop = 5,      ///< the walls of the region of interest, fixed
};

/// Conforming prisms (skin) on tetrahedra (fat and muscle). Positions in mm, RAS.
///
/// A prism's corners are 0-2 on the face (counter-clockwise seen from outside) and 3-5 below them;
/// its inner triangle (3, 4, 5) is a face of exactly one tetrahedron. Tetrahedra are positively
/// oriented: (x1 - x0) x (x2 - x0) . (x3 - x0) > 0.
struct MixedMesh
{
  std::vector<Vec3> X; ///< rest positions, one per node
  std::vector<std::array<int, 6>> prisms;
  std::vector<std::array<int, 4>> tets;
  std::vector<Tissue> tet_tissue;      ///< one per tetrahedron, Fat or Muscle; Skin where prisms were split
  std::vector<Boundary> node_boundary; ///< one per node
  std::vector<int> node_fragment;      ///< one per node: fragment index, or -1 off Gamma_n
  std::vector<std::string> fragments;  ///< names, in the order of the indices

  int node_count() const { return static_cast<int>(X.size()); }
};

/// Six times the signed volume of a tetrahedron [mm^3].
inline double tet_volume6(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

} // namespace f2b
