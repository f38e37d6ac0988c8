#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <vector>

/// How thick is the skin at a place of the face, when it is told part by part?
namespace f2b
{

/// A smooth field of thickness on a lattice of its own around the skin [mm]: at a place it is the
/// mean over the skin within 12 mm, by area and the nearer the more, so that prisms change in height
/// over about a centimetre where two parts meet. Far from the skin it is `elsewhere`.
/// \param of_vertex  thickness at each vertex [mm]
ScalarGrid skin_thickness(const TriangleMesh& skin, const std::vector<double>& of_vertex,
                          double elsewhere);

} // namespace f2b
