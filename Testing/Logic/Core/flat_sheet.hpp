#pragma once

#include "Core/geometry/vectors.hpp"

#include <cmath>
#include <functional>

/// A sheet over the plane of R and S, seen from +A, symmetric about R = 0 whatever lies on it.
namespace f2b::testing
{

/// \param cells    along a side, even
/// \param size_mm  of a side
/// \param forward  height above the plane at (right, up) [mm]
inline TriangleMesh make_sheet(
    int cells, double size_mm,
    const std::function<double(double, double)>& forward = [](double, double) { return 0.0; })
{
  TriangleMesh sheet;
  const double step = size_mm / cells;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
    {
      const double r = (i - cells / 2) * step, s = (j - cells / 2) * step;
      sheet.points.push_back({r, forward(r, s), s});
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
    {
      const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      // diagonals mirror each other; +A is outside
      if (i < cells / 2)
      {
        sheet.triangles.push_back({a, c, d});
        sheet.triangles.push_back({a, d, b});
      }
      else
      {
        sheet.triangles.push_back({a, c, b});
        sheet.triangles.push_back({b, c, d});
      }
    }
  return sheet;
}

} // namespace f2b::testing
