#include "Core/sculpting/line_of_sight.hpp"

#include <cmath>

namespace f2b
{
namespace
{

constexpr double least_sine = 0.0872; // of 5 degrees

} // namespace

std::optional<double> along_axis(const LineOfSight& line, const Vec3& point, const Vec3& axis)
{
  const double cosine = axis.dot(line.direction);
  const double sine2 = 1 - cosine * cosine;
  if (sine2 < least_sine * least_sine)
    return {};
  const Vec3 between = line.origin - point;
  return (axis.dot(between) - cosine * line.direction.dot(between)) / sine2;
}

std::optional<Vec3> on_plane(const LineOfSight& line, const Vec3& point, const Vec3& normal)
{
  const double towards = normal.dot(line.direction);
  if (std::abs(towards) < least_sine)
    return {};
  const double at = normal.dot(point - line.origin) / towards;
  if (at < 0)
    return {};
  return line.origin + at * line.direction;
}

double angle_about(const Vec3& centre, const Vec3& axis, const Vec3& from, const Vec3& to)
{
  const Vec3 a = from - centre, b = to - centre;
  const Vec3 flat_a = a - axis.dot(a) * axis, flat_b = b - axis.dot(b) * axis;
  if (flat_a.norm() < 1e-9 || flat_b.norm() < 1e-9)
    return 0;
  return std::atan2(axis.dot(flat_a.cross(flat_b)), flat_a.dot(flat_b));
}

} // namespace f2b
