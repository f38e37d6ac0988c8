#include "Core/geometry/scalar_grid.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

double ScalarGrid::value(const Vec3& point_ras) const
{
  const Vec3 p = (point_ras - origin) / spacing;
  int base[3];
  double f[3];
  for (int a = 0; a < 3; ++a)
  {
    const double clamped = std::clamp(p[a], 0.0, static_cast<double>(size[a] - 1));
    base[a] = std::min(static_cast<int>(clamped), std::max(size[a] - 2, 0));
    f[a] = clamped - base[a];
  }
  const int dx = size[0] > 1, dy = size[1] > 1, dz = size[2] > 1;
  auto at = [&](int i, int j, int k)
  {
    return static_cast<double>(values[index(base[0] + i * dx, base[1] + j * dy, base[2] + k * dz)]);
  };
  auto along_x = [&](int j, int k) { return at(0, j, k) * (1 - f[0]) + at(1, j, k) * f[0]; };
  auto along_y = [&](int k) { return along_x(0, k) * (1 - f[1]) + along_x(1, k) * f[1]; };
  return along_y(0) * (1 - f[2]) + along_y(1) * f[2];
}

Vec3 ScalarGrid::gradient(const Vec3& point_ras) const
{
  const double h = 0.5 * spacing;
  Vec3 g;
  for (int a = 0; a < 3; ++a)
  {
    const Vec3 step = h * Vec3::Unit(a);
    g[a] = (value(point_ras + step) - value(point_ras - step)) / (2 * h);
  }
  return g;
}

unsigned char LabelGrid::nearest(const Vec3& point_ras) const
{
  const Vec3 p = (point_ras - origin) / spacing;
  int n[3];
  for (int a = 0; a < 3; ++a)
    n[a] = std::clamp(static_cast<int>(std::lround(p[a])), 0, size[a] - 1);
  return values[index(n[0], n[1], n[2])];
}

} // namespace f2b
