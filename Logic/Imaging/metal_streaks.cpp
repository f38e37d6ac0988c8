#include "Imaging/metal_streaks.hpp"

#include "Imaging/signed_distance.hpp"

#include <algorithm>
#include <functional>

namespace f2b
{
namespace
{

constexpr float metal_hu = 2000.0F;
constexpr double smallest_metal_area = 60.0; ///< of a slice [mm^2]
constexpr double reach = 40.0;               ///< of streaks worth treating [mm]

std::vector<char> slices_with_metal(const BinaryMask& metal)
{
  const Eigen::Vector3i size = metal.lattice.size;
  const double sample_area = metal.lattice.spacing * metal.lattice.spacing;
  const std::size_t slice = static_cast<std::size_t>(size.x()) * size.y();
  std::vector<char> found(size.z(), 0);
  for (int k = 0; k < size.z(); ++k)
  {
    const auto first = metal.values.begin() + static_cast<std::ptrdiff_t>(k * slice);
    const auto count = std::count(first, first + static_cast<std::ptrdiff_t>(slice), 1);
    found[k] = static_cast<double>(count) * sample_area >= smallest_metal_area;
  }
  return found;
}

/// Slices up to `margin` [samples] away from a marked one are marked too.
std::vector<char> widened(const std::vector<char>& marked, int margin)
{
  const int n = static_cast<int>(marked.size());
  std::vector<char> result(marked.size(), 0);
  for (int k = 0; k < n; ++k)
    for (int o = std::max(0, k - margin); o <= std::min(n - 1, k + margin); ++o)
      result[k] |= marked[o];
  return result;
}

/// result[k] = the extreme of line[k - before .. k + after].
template <class Better>
void running_extreme(const std::vector<float>& line, int before, int after, Better better,
                     std::vector<float>& result)
{
  const int n = static_cast<int>(line.size());
  for (int k = 0; k < n; ++k)
  {
    float best = line[k];
    for (int o = std::max(0, k - before); o <= std::min(n - 1, k + after); ++o)
      if (better(line[o], best))
        best = line[o];
    result[k] = best;
  }
}

/// Grey opening (first = greater) or closing (first = less) along S, kept inside the zone only.
template <class First, class Second>
void filter_along_s(ScalarGrid& level, const BinaryMask& zone, double length, First first,
                    Second second)
{
  const int window = static_cast<int>(std::lround(length / level.spacing));
  const int before = window / 2, after = window - before;
  const int n = level.size.z();
#pragma omp parallel
  {
    std::vector<float> line(n), once(n), twice(n);
#pragma omp for schedule(dynamic)
    for (int j = 0; j < level.size.y(); ++j)
      for (int i = 0; i < level.size.x(); ++i)
      {
        bool touched = false;
        for (int k = 0; k < n; ++k)
        {
          line[k] = level.values[level.index(i, j, k)];
          touched |= zone.values[level.index(i, j, k)] != 0;
        }
        if (!touched)
          continue;
        running_extreme(line, before, after, first, once);
        running_extreme(once, after, before, second, twice);
        for (int k = 0; k < n; ++k)
          if (zone.values[level.index(i, j, k)])
            level.values[level.index(i, j, k)] = twice[k];
      }
  }
}

std::vector<float> gaussian_weights(double sigma)
{
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<float> weights(2 * radius + 1);
  float sum = 0.0F;
  for (int o = -radius; o <= radius; ++o)
    sum += weights[o + radius] = static_cast<float>(std::exp(-0.5 * o * o / (sigma * sigma)));
  for (float& w : weights)
    w /= sum;
  return weights;
}

void convolve_axis(ScalarGrid& grid, int axis, const std::vector<float>& weights)
{
  const int radius = static_cast<int>(weights.size()) / 2, n = grid.size[axis];
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::ptrdiff_t strides[3] = {1, grid.size.x(),
                                     static_cast<std::ptrdiff_t>(grid.size.x()) * grid.size.y()};
#pragma omp parallel
  {
    std::vector<float> line(n);
#pragma omp for schedule(static)
    for (int b = 0; b < grid.size[v]; ++b)
      for (int a = 0; a < grid.size[u]; ++a)
      {
        float* first = &grid.values[a * strides[u] + b * strides[v]];
        for (int q = 0; q < n; ++q)
          line[q] = first[q * strides[axis]];
        for (int q = 0; q < n; ++q)
        {
          float sum = 0.0F;
          for (int o = -radius; o <= radius; ++o)
            sum += weights[o + radius] * line[std::clamp(q + o, 0, n - 1)];
          first[q * strides[axis]] = sum;
        }
      }
  }
}

} // namespace

BinaryMask streak_zone(const ScalarGrid& hu)
{
  const Lattice lattice = lattice_of(hu);
  const BinaryMask metal =
      mask_where(lattice, [&](std::size_t s) { return hu.values[s] > metal_hu; });
  const std::vector<char> slices =
      widened(slices_with_metal(metal), static_cast<int>(std::lround(2.0 / lattice.spacing)));
  if (std::find(slices.begin(), slices.end(), 1) == slices.end())
    return BinaryMask(lattice);
  const ScalarGrid distance = distance_to(metal);
  const std::size_t slice = static_cast<std::size_t>(lattice.size.x()) * lattice.size.y();
  return mask_where(lattice,
                    [&](std::size_t s) { return slices[s / slice] && distance.values[s] < reach; });
}

void remove_streaks(ScalarGrid& distance, const BinaryMask& zone, double length, double stub)
{
  ScalarGrid opened = distance;
  filter_along_s(opened, zone, length, std::greater<float>(), std::less<float>());
  opened = signed_distance(opened);
  for (std::size_t s = 0; s < distance.values.size(); ++s)
    if (zone.values[s])
      distance.values[s] =
          std::max(distance.values[s], opened.values[s] - static_cast<float>(stub));
}

void fill_streaks(ScalarGrid& distance, const BinaryMask& zone, double length, double stub)
{
  ScalarGrid closed = distance;
  filter_along_s(closed, zone, length, std::less<float>(), std::greater<float>());
  closed = signed_distance(closed);
  for (std::size_t s = 0; s < distance.values.size(); ++s)
    if (zone.values[s])
      distance.values[s] =
          std::min(distance.values[s], closed.values[s] + static_cast<float>(stub));
}

void smooth_near_changes(ScalarGrid& distance, const ScalarGrid& before, double sigma)
{
  const float changed = 0.25F, near_surface = 4.0F;
  const ScalarGrid to_change =
      distance_to(mask_where(lattice_of(distance),
                             [&](std::size_t s)
                             {
                               return std::abs(distance.values[s] - before.values[s]) > changed &&
                                      std::abs(distance.values[s]) < near_surface;
                             }));
  ScalarGrid smooth = distance;
  // Far values say nothing about the surface; clipping keeps sharp corners from spreading.
  for (float& v : smooth.values)
    v = std::clamp(v, -1.5F * near_surface, 1.5F * near_surface);
  const std::vector<float> weights = gaussian_weights(sigma / distance.spacing);
  for (int axis = 0; axis < 3; ++axis)
    convolve_axis(smooth, axis, weights);
  const double full = sigma, none = 2.0 * sigma;
  for (std::size_t s = 0; s < distance.values.size(); ++s)
    if (std::abs(distance.values[s]) < near_surface)
    {
      const double weight = std::clamp((none - to_change.values[s]) / (none - full), 0.0, 1.0);
      distance.values[s] += static_cast<float>(weight) * (smooth.values[s] - distance.values[s]);
    }
}

} // namespace f2b
