#pragma once

#include "Core/geometry/vectors.hpp"

/// Where does a surface pass through itself? (CGAL, exact predicates)
namespace f2b
{

/// The triangles that cross, touch or overlap another one which they do not meet at an edge or
/// corner of both; ascending. Triangles that a manifold does not have are left out.
std::vector<int> crossing_triangles(const TriangleMesh& mesh);

/// Moves points back, as few as it takes, until no triangles cross; returns how many were moved.
///
/// \param mesh  a moved (smoothed) surface
/// \param rest  where its points were when it did not cross itself
std::size_t yield_crossings(TriangleMesh& mesh, const std::vector<Vec3>& rest);

} // namespace f2b
