#pragma once

#include "Core/geometry/vectors.hpp"

/// How does a closed surface get by with fewer triangles and stay closed?
namespace f2b
{

/// Collapses edges in the order of their quadric error (Garland & Heckbert 1997) as long as every
/// vertex stays within `error_mm` of the planes of all triangles that were merged into it: flat
/// places get by with few triangles, curved ones keep theirs.
///
/// An edge goes only if the link condition holds and no triangle turns over: a closed manifold
/// stays one, with the same components and handles. The result does not depend on anything but the
/// input.
TriangleMesh collapse_edges(const TriangleMesh& closed_surface, double error_mm);

} // namespace f2b
