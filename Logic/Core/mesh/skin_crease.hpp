#pragma once

#include "Core/mesh/smooth_skin.hpp"

/// By what angle does the face's normal jump across the edges of its prisms?
namespace f2b
{

/// Over the edges that two prisms share.
struct SkinCrease
{
  double mean_deg = 0; ///< mean over edges of the mean over the points of an edge
  double max_deg = 0;  ///< over edges and points
  long edges = 0;
  std::pair<int, int> worst{-1, -1}; ///< nodes of the edge with the largest angle
};

/// Crease of the facets.
/// \param x  positions of the nodes, rest or current [mm]
SkinCrease linear_skin_crease(const MixedMesh& mesh, const std::vector<Vec3>& x);

/// Crease of the smooth face, at five points of each edge.
/// \param x  all control vectors, rest or current [mm]
SkinCrease smooth_skin_crease(const SmoothSkin& skin, const std::vector<Vec3>& x);

} // namespace f2b
