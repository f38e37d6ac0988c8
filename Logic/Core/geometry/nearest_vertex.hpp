#pragma once

#include "Core/geometry/vectors.hpp"

#include <algorithm>
#include <vector>

/// Which vertex lies nearest to a place?
namespace f2b
{

/// Index of the first that is nearest; looks at all, for a few places. \param points  not empty [mm]
inline std::size_t nearest_vertex(const std::vector<Vec3>& points, const Vec3& to)
{
  return static_cast<std::size_t>(
      std::min_element(points.begin(), points.end(),
                       [&](const Vec3& a, const Vec3& b)
                       { return (a - to).squaredNorm() < (b - to).squaredNorm(); }) -
      points.begin());
}

} // namespace f2b
