#include "Imaging/binary_mask.hpp"

#include <algorithm>
#include <numeric>

namespace f2b
{
namespace
{

constexpr float far_away = 1e12F; ///< squared, in samples

/// Lower envelope of parabolas on one line (Felzenszwalb & Huttenlocher 2012).
class LineTransform
{
public:
  explicit LineTransform(int n) : m_in(n), m_apex(n), m_from(n + 1) {}

  void operator()(float* line, std::ptrdiff_t stride)
  {
    const int n = static_cast<int>(m_in.size());
    for (int q = 0; q < n; ++q)
      m_in[q] = line[q * stride];
    int last = 0;
    m_apex[0] = 0;
    m_from[0] = -far_away;
    for (int q = 1; q < n; ++q)
    {
      double s = meeting(m_apex[last], q);
      while (s <= m_from[last] && last > 0)
        s = meeting(m_apex[--last], q);
      m_apex[++last] = q;
      m_from[last] = s;
    }
    for (int q = 0, k = 0; q < n; ++q)
    {
      while (k < last && m_from[k + 1] < q)
        ++k;
      const float d = static_cast<float>(q - m_apex[k]);
      line[q * stride] = d * d + m_in[m_apex[k]];
    }
  }

private:
  double meeting(int a, int b) const
  {
    return ((m_in[b] + double(b) * b) - (m_in[a] + double(a) * a)) / (2.0 * (b - a));
  }

  std::vector<float> m_in;
  std::vector<int> m_apex;
  std::vector<double> m_from;
};

void transform_axis(ScalarGrid& grid, int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::ptrdiff_t strides[3] = {1, grid.size.x(),
                                     static_cast<std::ptrdiff_t>(grid.size.x()) * grid.size.y()};
#pragma omp parallel
  {
    LineTransform transform(grid.size[axis]);
#pragma omp for schedule(static)
    for (int b = 0; b < grid.size[v]; ++b)
      for (int a = 0; a < grid.size[u]; ++a)
        transform(&grid.values[a * strides[u] + b * strides[v]], strides[axis]);
  }
}

bool on_wall(const Lattice& lattice, int i, int j, int k)
{
  return i == 0 || j == 0 || k == 0 || i == lattice.size.x() - 1 || j == lattice.size.y() - 1 ||
         k == lattice.size.z() - 1;
}

/// Labels the part that holds `seed` and appends its size to `components`.
void flood(const BinaryMask& mask, std::size_t seed, Components& components,
           std::vector<std::size_t>& stack)
{
  const int nx = mask.lattice.size.x(), ny = mask.lattice.size.y(), nz = mask.lattice.size.z();
  const std::size_t dy = nx, dz = dy * ny;
  const int number = static_cast<int>(components.size.size()) + 1;
  std::size_t size = 0;
  char wall = 0;
  auto visit = [&](std::size_t s)
  {
    if (mask.values[s] && components.label[s] == 0)
    {
      components.label[s] = number;
      stack.push_back(s);
    }
  };
  visit(seed);
  while (!stack.empty())
  {
    const std::size_t s = stack.back();
    stack.pop_back();
    ++size;
    const int i = static_cast<int>(s % dy), j = static_cast<int>(s / dy % ny),
              k = static_cast<int>(s / dz);
    wall |= on_wall(mask.lattice, i, j, k);
    if (i > 0)
      visit(s - 1);
    if (i < nx - 1)
      visit(s + 1);
    if (j > 0)
      visit(s - dy);
    if (j < ny - 1)
      visit(s + dy);
    if (k > 0)
      visit(s - dz);
    if (k < nz - 1)
      visit(s + dz);
  }
  components.size.push_back(size);
  components.touches_wall.push_back(wall);
}

} // namespace

std::size_t BinaryMask::count() const
{
  return std::accumulate(values.begin(), values.end(), std::size_t{0});
}

ScalarGrid distance_to(const BinaryMask& mask)
{
  ScalarGrid grid = grid_on(mask.lattice, far_away);
  for (std::size_t s = 0; s < mask.values.size(); ++s)
    if (mask.values[s])
      grid.values[s] = 0.0F;
  for (int axis = 0; axis < 3; ++axis)
    transform_axis(grid, axis);
  const float h = static_cast<float>(grid.spacing);
  for (float& v : grid.values)
    v = std::min(h * std::sqrt(v), 1e6F);
  return grid;
}

int Components::largest() const
{
  return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin()) -
         (size.empty() ? 1 : 0);
}

Components components_of(const BinaryMask& mask)
{
  Components components;
  components.label.assign(mask.values.size(), 0);
  std::vector<std::size_t> stack;
  for (std::size_t s = 0; s < mask.values.size(); ++s)
    if (mask.values[s] && components.label[s] == 0)
      flood(mask, s, components, stack);
  return components;
}

BinaryMask reconstruct(const BinaryMask& seeds, const BinaryMask& mask)
{
  const Components parts = components_of(mask);
  std::vector<char> kept(parts.size.size() + 1, 0);
  for (std::size_t s = 0; s < mask.values.size(); ++s)
    if (seeds.values[s])
      kept[parts.label[s]] = 1;
  kept[0] = 0;
  return mask_where(mask.lattice, [&](std::size_t s) { return kept[parts.label[s]] != 0; });
}

BinaryMask largest_component(const BinaryMask& mask)
{
  const Components parts = components_of(mask);
  const int number = parts.largest() + 1;
  return mask_where(mask.lattice,
                    [&](std::size_t s) { return number > 0 && parts.label[s] == number; });
}

BinaryMask dilate(const BinaryMask& mask, double radius)
{
  const ScalarGrid distance = distance_to(mask);
  return mask_where(mask.lattice, [&](std::size_t s) { return distance.values[s] <= radius; });
}

BinaryMask erode(const BinaryMask& mask, double radius)
{
  const BinaryMask outside =
      mask_where(mask.lattice, [&](std::size_t s) { return mask.values[s] == 0; });
  const ScalarGrid distance = distance_to(outside);
  return mask_where(mask.lattice, [&](std::size_t s) { return distance.values[s] > radius; });
}

} // namespace f2b
