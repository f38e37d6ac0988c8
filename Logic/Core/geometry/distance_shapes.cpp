#include "Core/geometry/distance_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

double sign(double value)
{
  return value < 0 ? -1.0 : 1.0;
}

double clamp01(double value)
{
  return std::clamp(value, 0.0, 1.0);
}

double segment_distance2(const Vec3& from_start, const Vec3& edge)
{
  return (edge * clamp01(edge.dot(from_start) / edge.squaredNorm()) - from_start).squaredNorm();
}

double triangle_distance2(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const Vec3 from_a = point - a, from_b = point - b, from_c = point - c;
  const Vec3 normal = ab.cross(bc);
  const bool above_face = ab.cross(normal).dot(from_a) <= 0 && bc.cross(normal).dot(from_b) <= 0 &&
                          ca.cross(normal).dot(from_c) <= 0;
  if (above_face)
    return std::pow(normal.dot(from_a), 2) / normal.squaredNorm();
  return std::min({segment_distance2(from_a, ab), segment_distance2(from_b, bc),
                   segment_distance2(from_c, ca)});
}

} // namespace

double Ellipsoid::distance(const Vec3& point) const
{
  // |q| is 1 on the surface; (|q| - 1) over its gradient's magnitude is the distance to first
  // order.
  const Vec3 q = (axes.transpose() * (point - centre)).cwiseQuotient(semi_axes);
  const double scaled = q.norm();
  const double slope = q.cwiseQuotient(semi_axes).norm();
  return slope > 1e-9 ? scaled * (scaled - 1) / slope : -semi_axes.minCoeff();
}

double Capsule::distance(const Vec3& point) const
{
  // In the plane of the axis and the point the side is a straight line tangent to both circles.
  const Vec3 axis = end - start;
  const Vec3 from_start = point - start;
  const double l2 = axis.squaredNorm();
  const double taper = start_radius - end_radius;
  const double side2 = l2 - taper * taper;
  const double y = from_start.dot(axis);
  const double z = y - l2;
  const double x2 = (from_start * l2 - axis * y).squaredNorm();
  const double y2 = y * y * l2;
  const double z2 = z * z * l2;
  const double k = sign(taper) * taper * taper * x2;
  if (sign(z) * side2 * z2 > k)
    return std::sqrt(x2 + z2) / l2 - end_radius;
  if (sign(y) * side2 * y2 < k)
    return std::sqrt(x2 + y2) / l2 - start_radius;
  return (std::sqrt(x2 * side2 / l2) + y * taper) / l2 - start_radius;
}

BoundingSphere Capsule::bound() const
{
  return {0.5 * (start + end), 0.5 * (end - start).norm() + std::max(start_radius, end_radius)};
}

double Tube::distance(const Vec3& point) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    nearest = std::min(nearest,
                       Capsule{points[i], radii[i], points[i + 1], radii[i + 1]}.distance(point));
  return nearest;
}

BoundingSphere Tube::bound() const
{
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points)
    centre += p / static_cast<double>(points.size());
  double reach = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    reach = std::max(reach, (points[i] - centre).norm() + radii[i]);
  return {centre, reach};
}

double RoundedBox::distance(const Vec3& point) const
{
  const Vec3 local = axes.transpose() * (point - centre);
  const Vec3 q = local.cwiseAbs() - (half_size - Vec3::Constant(rounding));
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - rounding;
}

double Ring::distance(const Vec3& point) const
{
  const Vec3 local = axes.transpose() * (point - centre);
  const Eigen::Vector2d q = local.head<2>().cwiseQuotient(semi_axes);
  const double scaled = q.norm();
  const double slope = q.cwiseQuotient(semi_axes).norm();
  const double in_plane = slope > 1e-9 ? scaled * (scaled - 1) / slope : -semi_axes.minCoeff();
  return std::hypot(in_plane, local.z()) - tube_radius;
}

double Sheet::distance(const Vec3& point) const
{
  return std::sqrt(
             std::min(triangle_distance2(point, a, b, c), triangle_distance2(point, a, c, d))) -
         radius;
}

BoundingSphere Sheet::bound() const
{
  const Vec3 centre = 0.25 * (a + b + c + d);
  double reach = 0;
  for (const Vec3& corner : {a, b, c, d})
    reach = std::max(reach, (corner - centre).norm());
  return {centre, reach + radius};
}

Mat3 turned(double pitch, double roll, double yaw)
{
  const double degree = std::acos(-1.0) / 180;
  return (Eigen::AngleAxisd(yaw * degree, Vec3::UnitZ()) *
          Eigen::AngleAxisd(roll * degree, Vec3::UnitY()) *
          Eigen::AngleAxisd(pitch * degree, Vec3::UnitX()))
      .toRotationMatrix();
}

double smooth_union(double a, double b, double blend)
{
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - (blend > 0 ? overlap * overlap / (4 * blend) : 0.0);
}

double smooth_intersection(double a, double b, double blend)
{
  return -smooth_union(-a, -b, blend);
}

double smooth_subtraction(double from, double cut, double blend)
{
  return smooth_intersection(from, -cut, blend);
}

} // namespace f2b
