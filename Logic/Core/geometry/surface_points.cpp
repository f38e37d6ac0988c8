#include "Core/geometry/surface_points.hpp"

namespace f2b
{
namespace
{

/// Points where the edge from sample (i, j, k) along an axis crosses the zero level.
void cross_edge(const ScalarGrid& grid, const Eigen::Vector3i& from, int axis,
                const std::function<bool(const Vec3&)>& counts, std::vector<Vec3>& points)
{
  Eigen::Vector3i to = from;
  if (++to[axis] >= grid.size[axis])
    return;
  const double a = grid.values[grid.index(from.x(), from.y(), from.z())];
  const double b = grid.values[grid.index(to.x(), to.y(), to.z())];
  if ((a < 0) == (b < 0))
    return;
  const Vec3 p =
      grid.position(from.x(), from.y(), from.z()) + grid.spacing * a / (a - b) * Vec3::Unit(axis);
  if (counts(p))
    points.push_back(p);
}

} // namespace

std::vector<SurfaceSample> surface_points(const ScalarGrid& distance,
                                         const std::function<bool(const Vec3&)>& counts,
                                         std::size_t at_most)
{
  std::vector<Vec3> all;
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i)
        for (int axis = 0; axis < 3; ++axis)
          cross_edge(distance, {i, j, k}, axis, counts, all);

  constexpr double least_slope = 0.3; // on a ridge between two surfaces no normal is to be trusted
  const double stride = std::max(1.0, static_cast<double>(all.size()) /
                                          static_cast<double>(std::max<std::size_t>(at_most, 1)));
  std::vector<SurfaceSample> kept;
  for (double at = 0; at < static_cast<double>(all.size()); at += stride)
  {
    const Vec3& p = all[static_cast<std::size_t>(at)];
    const Vec3 slope = distance.gradient(p);
    if (slope.norm() > least_slope)
      kept.push_back({p, slope.normalized()});
  }
  return kept;
}

} // namespace f2b
