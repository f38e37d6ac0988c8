#include "Core/geometry/skin_thickness.hpp"

#include "Core/inverse/skin_error.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

constexpr double reach_mm = 12, spacing_mm = 3;

/// Weight at a squared distance; 0 from the reach on.
double weight(double squared_mm)
{
  const double rest = 1 - squared_mm / (reach_mm * reach_mm);
  return rest > 0 ? rest * rest * rest : 0;
}

ScalarGrid lattice_around(const TriangleMesh& skin)
{
  Vec3 low = skin.points.front(), high = low;
  for (const Vec3& p : skin.points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  ScalarGrid grid;
  grid.spacing = spacing_mm;
  grid.origin = low.array() - reach_mm;
  grid.size =
      ((high - low).array() / spacing_mm + 2 * reach_mm / spacing_mm).ceil().cast<int>() + 1;
  return grid;
}

} // namespace

ScalarGrid skin_thickness(const TriangleMesh& skin, const std::vector<double>& of_vertex,
                          double elsewhere)
{
  ScalarGrid grid = lattice_around(skin);
  std::vector<double> weights(grid.count(), 0), sums(grid.count(), 0);
  const std::vector<double> areas = vertex_areas(skin);
  for (std::size_t v = 0; v < skin.points.size(); ++v)
  {
    const Eigen::Array3d at = (skin.points[v] - grid.origin) / spacing_mm;
    const Eigen::Array3i first = (at - reach_mm / spacing_mm).ceil().cast<int>().max(0);
    const Eigen::Array3i last =
        (at + reach_mm / spacing_mm).floor().cast<int>().min(grid.size.array() - 1);
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
        {
          const double w =
              areas[v] * weight((grid.position(i, j, k) - skin.points[v]).squaredNorm());
          weights[grid.index(i, j, k)] += w;
          sums[grid.index(i, j, k)] += w * of_vertex[v];
        }
  }
  grid.values.resize(grid.count());
  for (std::size_t n = 0; n < grid.values.size(); ++n)
    grid.values[n] = static_cast<float>(weights[n] > 0 ? sums[n] / weights[n] : elsewhere);
  return grid;
}

} // namespace f2b
