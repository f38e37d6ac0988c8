#include "Imaging/signed_distance.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using Point = Eigen::Vector3f; ///< in samples

constexpr float nowhere = 1e4F;

/// Closest points on the zero level, one per sample, spread from the grid edges that cross it.
class ClosestPoints
{
public:
  explicit ClosestPoints(const ScalarGrid& f)
      : m_f(f), m_stride{1, f.size.x(), static_cast<std::ptrdiff_t>(f.size.x()) * f.size.y()},
        m_closest(f.count()), m_distance2(f.count(), nowhere * nowhere)
  {
    seed();
    for (int order = 0; order < 8; ++order)
      sweep(order & 1 ? -1 : 1, order & 2 ? -1 : 1, order & 4 ? -1 : 1);
  }

  float distance(std::size_t s) const { return std::sqrt(m_distance2[s]); }
  const Point& closest(std::size_t s) const { return m_closest[s]; }

private:
  void offer(std::size_t s, const Point& at, const Point& candidate)
  {
    const float d2 = (candidate - at).squaredNorm();
    if (d2 < m_distance2[s])
    {
      m_distance2[s] = d2;
      m_closest[s] = candidate;
    }
  }

  void seed()
  {
    for (int k = 0; k < m_f.size.z(); ++k)
      for (int j = 0; j < m_f.size.y(); ++j)
        for (int i = 0; i < m_f.size.x(); ++i)
          seed_edges(i, j, k);
  }

  void seed_edges(int i, int j, int k)
  {
    const int index[3] = {i, j, k};
    const std::size_t s = m_f.index(i, j, k);
    const float a = m_f.values[s];
    for (int axis = 0; axis < 3; ++axis)
    {
      if (index[axis] + 1 >= m_f.size[axis])
        continue;
      const std::size_t t = s + m_stride[axis];
      const float b = m_f.values[t];
      if ((a < 0) == (b < 0))
        continue;
      const Point from(i, j, k);
      const Point crossing = from + a / (a - b) * Point::Unit(axis);
      offer(s, from, crossing);
      offer(t, from + Point::Unit(axis), crossing);
    }
  }

  void sweep(int di, int dj, int dk)
  {
    const int nx = m_f.size.x(), ny = m_f.size.y(), nz = m_f.size.z();
    for (int kk = 0; kk < nz; ++kk)
      for (int jj = 0; jj < ny; ++jj)
      {
        const int k = dk > 0 ? kk : nz - 1 - kk, j = dj > 0 ? jj : ny - 1 - jj;
        for (int ii = 0; ii < nx; ++ii)
        {
          const int i = di > 0 ? ii : nx - 1 - ii;
          const std::size_t s = m_f.index(i, j, k);
          if (m_distance2[s] < 0.25F)
            continue;
          const Point at(i, j, k);
          if (ii > 0)
            take_over(s, at, s - di);
          if (jj > 0)
            take_over(s, at, s - dj * m_stride[1]);
          if (kk > 0)
            take_over(s, at, s - dk * m_stride[2]);
        }
      }
  }

  void take_over(std::size_t s, const Point& at, std::size_t neighbour)
  {
    if (m_distance2[neighbour] < nowhere * nowhere)
      offer(s, at, m_closest[neighbour]);
  }

  const ScalarGrid& m_f;
  std::ptrdiff_t m_stride[3];
  std::vector<Point> m_closest;
  std::vector<float> m_distance2;
};

/// Slides points along the zero level of the trilinear interpolant.
class Interpolant
{
public:
  explicit Interpolant(const ScalarGrid& f) : m_f(f) {}

  /// Value and gradient in the cell that holds p [per sample].
  float value(const Point& p, Point& gradient) const
  {
    int base[3];
    float t[3];
    for (int a = 0; a < 3; ++a)
    {
      const float inside = std::clamp(p[a], 0.0F, static_cast<float>(m_f.size[a] - 1));
      base[a] = std::min(static_cast<int>(inside), m_f.size[a] - 2);
      t[a] = inside - static_cast<float>(base[a]);
    }
    const std::ptrdiff_t dy = m_f.size.x(), dz = dy * m_f.size.y();
    const float* v = &m_f.values[m_f.index(base[0], base[1], base[2])];
    const float x00 = v[1] - v[0], x10 = v[dy + 1] - v[dy], x01 = v[dz + 1] - v[dz],
                x11 = v[dy + dz + 1] - v[dy + dz];
    const float c00 = v[0] + t[0] * x00, c10 = v[dy] + t[0] * x10, c01 = v[dz] + t[0] * x01,
                c11 = v[dy + dz] + t[0] * x11;
    const float y0 = c10 - c00, y1 = c11 - c01;
    const float c0 = c00 + t[1] * y0, c1 = c01 + t[1] * y1;
    const float x0 = x00 + t[1] * (x10 - x00), x1 = x01 + t[1] * (x11 - x01);
    gradient = Point(x0 + t[2] * (x1 - x0), y0 + t[2] * (y1 - y0), c1 - c0);
    return c0 + t[2] * (c1 - c0);
  }

  /// Moves p to the zero level along the gradient; false if it does not get there.
  bool project(Point& p) const
  {
    Point gradient;
    for (int iteration = 0; iteration < 4; ++iteration)
    {
      const float f = value(p, gradient);
      const float g2 = gradient.squaredNorm();
      if (f * f <= 1e-6F * g2)
        return true;
      if (g2 == 0.0F)
        return false;
      Point step = -f / g2 * gradient;
      const float length = step.norm();
      if (length > 0.5F)
        step *= 0.5F / length;
      p += step;
    }
    const float f = value(p, gradient);
    return f * f <= 1e-4F * gradient.squaredNorm();
  }

  /// The distance from `at` to the surface, improved from a nearby point of the surface.
  float refined_distance(const Point& at, Point closest) const
  {
    float best = (at - closest).norm();
    for (int iteration = 0; iteration < 3; ++iteration)
    {
      Point gradient;
      value(closest, gradient);
      const float g2 = gradient.squaredNorm();
      if (g2 == 0.0F)
        break;
      const Point offset = at - closest;
      Point slide = offset - offset.dot(gradient) / g2 * gradient;
      const float length = slide.norm();
      if (length > 0.7F)
        slide *= 0.7F / length;
      Point candidate = closest + slide;
      if (!project(candidate))
        break;
      const float distance = (at - candidate).norm();
      if (distance > best - 1e-4F)
        break;
      best = distance;
      closest = candidate;
    }
    return best;
  }

private:
  const ScalarGrid& m_f;
};

} // namespace

ScalarGrid signed_distance(const ScalarGrid& level_function, double accurate_band_mm)
{
  const ClosestPoints points(level_function);
  const Interpolant interpolant(level_function);
  const float h = static_cast<float>(level_function.spacing);
  const float band = static_cast<float>(accurate_band_mm) / h;
  ScalarGrid distance = level_function;
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i)
      {
        const std::size_t s = distance.index(i, j, k);
        float d = points.distance(s);
        if (d < band)
          d = interpolant.refined_distance(Point(i, j, k), points.closest(s));
        distance.values[s] = level_function.values[s] < 0 ? -d * h : d * h;
      }
  return distance;
}

} // namespace f2b
