#pragma once

#include "Core/mesh/boundary_facets.hpp"

#include <functional>

/// How is a region that a function describes filled with well-shaped tetrahedra? (CGAL Mesh_3)
/// Lengths in mm, RAS. Sequential: the same input gives the same mesh, bit for bit.
namespace f2b
{

using ScalarField = std::function<double(const Vec3&)>;

/// The region where `level` is negative, and how finely to mesh it.
struct TetrahedralDomain
{
  ScalarField level;      ///< continuous; negative inside, positive outside
  Vec3 lo = Vec3::Zero(); ///< box that holds the whole region with some room
  Vec3 hi = Vec3::Zero();
  ScalarField facet_size;     ///< largest radius of a surface facet's Delaunay ball
  ScalarField facet_distance; ///< largest distance between a facet and the surface
  ScalarField cell_size;      ///< largest circumradius of a tetrahedron
  double facet_angle_deg = 25.0;
  double radius_edge_ratio = 2.0;
  double sliver_bound_deg = 12.0; ///< vertices are perturbed until no dihedral angle is smaller
  double seed_spacing = 9.0;      ///< distance of the lines along which the surface is looked for
};

struct TetrahedralMesh
{
  std::vector<Vec3> X;
  std::vector<Tet> tets; ///< positively oriented
};

/// Empty when the region is.
TetrahedralMesh mesh_domain(const TetrahedralDomain& domain);

} // namespace f2b
