#pragma once

#include "Core/sculpting/surface_links.hpp"
#include "Core/sculpting/surface_tree.hpp"

/// How does a curve run along a surface from one place to another by a short way?
namespace f2b
{

/// Points on the surface [mm], `from` first and `to` last, about `spacing_mm` apart: the shortest way
/// along edges, pulled straight on the surface. Empty if no way leads there.
/// \param links, tree  of `mesh`
std::vector<Vec3> surface_path(const TriangleMesh& mesh, const SurfaceLinks& links,
                               const SurfaceTree& tree, const SurfacePlace& from,
                               const SurfacePlace& to, double spacing_mm);

} // namespace f2b
