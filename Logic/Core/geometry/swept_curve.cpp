#include "Core/geometry/swept_curve.hpp"

#include "Core/geometry/saw_blade.hpp"
#include "Core/geometry/saw_track.hpp"

#include "Core/error.hpp"

#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

constexpr double same_place_mm = 1e-3;

std::vector<Vec3> without_repeats(const std::vector<Vec3>& points, bool closed)
{
  std::vector<Vec3> kept;
  for (const Vec3& p : points)
    if (kept.empty() || (p - kept.back()).norm() > same_place_mm)
      kept.push_back(p);
  while (closed && kept.size() > 1 && (kept.back() - kept.front()).norm() <= same_place_mm)
    kept.pop_back();
  return kept;
}

/// Centripetal Catmull-Rom between b and c, by Barry and Goldman's pyramid; s in [0, 1].
Vec3 spline(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double s)
{
  const double t0 = 0, t1 = t0 + std::sqrt((b - a).norm()), t2 = t1 + std::sqrt((c - b).norm()),
               t3 = t2 + std::sqrt((d - c).norm());
  const double t = t1 + s * (t2 - t1);
  auto mix = [t](const Vec3& p, double from, const Vec3& q, double to)
  { return Vec3(((to - t) * p + (t - from) * q) / (to - from)); };
  const Vec3 ab = mix(a, t0, b, t1), bc = mix(b, t1, c, t2), cd = mix(c, t2, d, t3);
  return mix(mix(ab, t0, bc, t2), t1, mix(bc, t1, cd, t3), t2);
}

} // namespace

std::vector<Vec3> resampled_curve(const std::vector<Vec3>& control_points, bool closed,
                                  bool straight, double spacing_mm)
{
  const std::vector<Vec3> p = without_repeats(control_points, closed);
  const auto n = static_cast<int>(p.size());
  if (n < 2)
    return p;
  auto at = [&](int i)
  {
    if (closed)
      return p[static_cast<std::size_t>((i + n) % n)];
    // beyond the ends the curve runs straight on
    if (i < 0)
      return Vec3(2 * p.front() - p[1]);
    if (i >= n)
      return Vec3(2 * p.back() - p[static_cast<std::size_t>(n - 2)]);
    return p[static_cast<std::size_t>(i)];
  };
  std::vector<Vec3> points;
  for (int i = 0; i < (closed ? n : n - 1); ++i)
  {
    const int steps =
        std::max(1, static_cast<int>(std::ceil((at(i + 1) - at(i)).norm() / spacing_mm)));
    for (int s = 0; s < steps; ++s)
    {
      const double share = double(s) / steps;
      points.push_back(straight ? Vec3(at(i) + share * (at(i + 1) - at(i)))
                                : spline(at(i - 1), at(i), at(i + 1), at(i + 2), share));
    }
  }
  if (!closed)
    points.push_back(p.back());
  return points;
}

void require_swept(const SweptCurve& curve, double kerf_mm)
{
  (void)SawTrack(curve, kerf_mm);
}

} // namespace f2b
