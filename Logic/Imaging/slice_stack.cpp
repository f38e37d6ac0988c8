#include "Imaging/slice_stack.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

constexpr short nothing_hu = -1024;

/// One slice on the stack's lattice.
void place_slice(const std::vector<short>& slice, int columns, int rows, double shift_across,
                 double shift_down, const StackLattice& lattice, std::vector<float>& out)
{
  const auto value = [&](int x, int y)
  { return static_cast<float>(slice[static_cast<std::size_t>(y) * columns + x]); };
  constexpr double rim = 1e-6; // a voxel's own place is inside, whatever the rounding
  for (int y = 0; y < lattice.rows; ++y)
    for (int x = 0; x < lattice.columns; ++x)
    {
      float& to = out[static_cast<std::size_t>(y) * lattice.columns + x];
      const double u = x - lattice.before_across - shift_across,
                   v = y - lattice.before_down - shift_down;
      if (u < -rim || v < -rim || u > columns - 1 + rim || v > rows - 1 + rim)
      {
        to = nothing_hu;
        continue;
      }
      const int i = std::clamp(static_cast<int>(std::floor(u)), 0, columns - 2),
                j = std::clamp(static_cast<int>(std::floor(v)), 0, rows - 2);
      const auto a = static_cast<float>(std::clamp(u - i, 0.0, 1.0)),
                 b = static_cast<float>(std::clamp(v - j, 0.0, 1.0));
      to = (1 - b) * ((1 - a) * value(i, j) + a * value(i + 1, j)) +
           b * ((1 - a) * value(i, j + 1) + a * value(i + 1, j + 1));
    }
}

} // namespace

StackLattice stack_lattice(const std::vector<SlicePlace>& places, double step_mm, int columns,
                           int rows, double spacing_across, double spacing_down)
{
  double least_across = 0, most_across = 0, least_down = 0, most_down = 0;
  for (const SlicePlace& p : places)
  {
    least_across = std::min(least_across, p.shift_across / spacing_across);
    most_across = std::max(most_across, p.shift_across / spacing_across);
    least_down = std::min(least_down, p.shift_down / spacing_down);
    most_down = std::max(most_down, p.shift_down / spacing_down);
  }
  constexpr double rim = 1e-3; // no row for what rounding adds
  auto voxels = [](double v) { return static_cast<int>(std::ceil(v - rim)); };
  StackLattice lattice;
  lattice.step_mm = step_mm;
  lattice.planes = 1 + static_cast<std::size_t>(std::floor(
                           (places.back().position - places.front().position) / step_mm + rim));
  lattice.before_across = voxels(-least_across);
  lattice.before_down = voxels(-least_down);
  lattice.columns = columns + lattice.before_across + voxels(most_across);
  lattice.rows = rows + lattice.before_down + voxels(most_down);
  return lattice;
}

void resample_stack(const std::vector<SlicePlace>& places, const StackLattice& lattice, int columns,
                    int rows, double spacing_across, double spacing_down,
                    const std::function<void(std::size_t, short*)>& read, short* out)
{
  const std::size_t area = static_cast<std::size_t>(lattice.columns) * lattice.rows;
  std::vector<short> raw(static_cast<std::size_t>(columns) * rows);
  std::vector<float> below(area), above(area);
  auto load = [&](std::size_t s, std::vector<float>& to)
  {
    read(s, raw.data());
    place_slice(raw, columns, rows, places[s].shift_across / spacing_across,
                places[s].shift_down / spacing_down, lattice, to);
  };
  std::size_t next = 1; // `above` is this slice
  load(0, below);
  load(1, above);
  for (std::size_t k = 0; k < lattice.planes; ++k)
  {
    const double z = places.front().position + static_cast<double>(k) * lattice.step_mm;
    while (next + 1 < places.size() && places[next].position < z)
    {
      std::swap(below, above);
      load(++next, above);
    }
    const double from = places[next - 1].position, to = places[next].position;
    const auto share = static_cast<float>(std::clamp((z - from) / (to - from), 0.0, 1.0));
    for (std::size_t v = 0; v < area; ++v)
      out[k * area + v] =
          static_cast<short>(std::lround((1 - share) * below[v] + share * above[v]));
  }
}

} // namespace f2b
