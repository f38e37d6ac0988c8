#pragma once

#include "Core/geometry/vectors.hpp"

/// In which order are points, so that neighbours in space are neighbours in memory?
namespace f2b
{

/// Indices of the points along a Z-order curve (G. M. Morton, IBM report, 1966) of 2^21 cells a
/// side over their bounding box; points of one cell keep their order.
std::vector<int> spatial_order(const std::vector<Vec3>& points);

} // namespace f2b
