#pragma once

#include "Core/geometry/vectors.hpp"

#include <cstddef>

/// How does a closed surface get by with fewer triangles and stay closed?
namespace f2b
{

/// Collapses edges in the order of their quadric error (Garland & Heckbert 1997) until
/// `target_triangles` are left or no edge may go any more.
///
/// An edge goes only if the link condition holds and no triangle turns over: a closed manifold
/// stays one, with the same components and handles. The result does not depend on anything but the
/// input.
TriangleMesh collapse_edges(const TriangleMesh& closed_surface, std::size_t target_triangles);

} // namespace f2b
