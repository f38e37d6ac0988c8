#pragma once

#include "Core/mesh/mixed_mesh.hpp"

#include <limits>

/// How good is a mixed mesh as a finite-element mesh: shapes, volumes and conformity? Lengths in
/// mm.
namespace f2b
{

/// Smallest of the six dihedral angles of a positively oriented tetrahedron [degrees]; negative
/// (-1) when it is flat or inverted.
double min_dihedral_deg(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Corners of one prism in the order of MixedMesh::prisms.
using PrismCorners = std::array<Vec3, 6>;

/// Scaled Jacobian of a prism, in [-1, 1]: the least, over the six corners, of the determinant of
/// the three unit edge vectors at that corner (to the next corner of its triangle, to the previous
/// one, and from the bottom to the top). An upright prism on an equilateral triangle has 0.866.
double min_scaled_jacobian(const PrismCorners& x);

/// Jacobian determinants of the prism's map from (L1, L2, t), t in [-1, 1], at the 3 x 2 Gauss
/// points [mm^3]; all positive in a usable prism.
std::array<double, 6> quadrature_jacobians(const PrismCorners& x);

/// Signed volume of the prism with bilinear sides [mm^3].
double prism_volume(const PrismCorners& x);

PrismCorners prism_corners(const MixedMesh& mesh, int prism);

/// Inner faces (3, 4, 5) of prisms that are not a face of exactly one tetrahedron.
int unmatched_inner_faces(const MixedMesh& mesh);

/// The figures that a report prints.
struct MeshQuality
{
  static constexpr int bin_count = 18;
  static constexpr double bin_deg = 5.0;

  double min_dihedral_deg = std::numeric_limits<double>::infinity();
  int worst_tet = -1;
  std::array<int, bin_count> dihedral_histogram{}; ///< tets by smallest angle, bins of 5 degrees
  double min_scaled_jacobian = std::numeric_limits<double>::infinity();
  int worst_prism = -1;
  double min_quadrature_jacobian = std::numeric_limits<double>::infinity(); ///< [mm^3]
  double min_tet_volume = std::numeric_limits<double>::infinity();          ///< [mm^3]
  double tet_volume = 0.0;                                                  ///< sum [mm^3]
  double prism_volume = 0.0;                                                ///< sum [mm^3]
  int inverted_elements = 0; ///< tets or prisms with a non-positive volume or Jacobian
  int unmatched_inner_faces = 0;

  double volume() const { return tet_volume + prism_volume; }
};

MeshQuality measure_quality(const MixedMesh& mesh);

} // namespace f2b
