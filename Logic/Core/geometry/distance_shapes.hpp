#pragma once

#include "Core/geometry/vectors.hpp"

#include <variant>
#include <vector>

/// How far is a point from a simple closed-form shape?
///
/// Signed distances [mm], negative inside. Ellipsoid and Ring are first-order estimates whose
/// gradient is near 1 close to the surface; the others are exact.
namespace f2b
{

/// A sphere that encloses a shape.
struct BoundingSphere
{
  Vec3 centre = Vec3::Zero();
  double radius = 0;
};

/// `axes` columns are the directions of the three semi-axes.
struct Ellipsoid
{
  Vec3 centre = Vec3::Zero();
  Vec3 semi_axes = Vec3::Ones();
  Mat3 axes = Mat3::Identity();

  double distance(const Vec3& point) const;
  BoundingSphere bound() const { return {centre, semi_axes.maxCoeff()}; }
};

/// The hull of two balls: a capsule when the radii are equal, tapered otherwise.
/// The smaller ball must not lie inside the larger one.
struct Capsule
{
  Vec3 start = Vec3::Zero();
  double start_radius = 1;
  Vec3 end = Vec3::Zero();
  double end_radius = 1;

  double distance(const Vec3& point) const;
  BoundingSphere bound() const;
};

/// Capsules end to end through `points`, the radius given at each of them.
struct Tube
{
  std::vector<Vec3> points;
  std::vector<double> radii;

  double distance(const Vec3& point) const;
  BoundingSphere bound() const;
};

/// A box of half edges `half_size` (its roundings included) along the columns of `axes`.
struct RoundedBox
{
  Vec3 centre = Vec3::Zero();
  Vec3 half_size = Vec3::Ones();
  double rounding = 0.5;
  Mat3 axes = Mat3::Identity();

  double distance(const Vec3& point) const;
  BoundingSphere bound() const { return {centre, half_size.norm()}; }
};

/// A tube of radius `tube_radius` around an ellipse in the plane of the first two columns of
/// `axes`; with equal semi-axes a torus.
struct Ring
{
  Vec3 centre = Vec3::Zero();
  Eigen::Vector2d semi_axes = Eigen::Vector2d::Ones();
  double tube_radius = 1;
  Mat3 axes = Mat3::Identity();

  double distance(const Vec3& point) const;
  BoundingSphere bound() const { return {centre, semi_axes.maxCoeff() + tube_radius}; }
};

/// All points within `radius` of the triangles a b c and a c d.
struct Sheet
{
  Vec3 a = Vec3::Zero(), b = Vec3::Zero(), c = Vec3::Zero(), d = Vec3::Zero();
  double radius = 1;

  double distance(const Vec3& point) const;
  BoundingSphere bound() const;
};

/// The side of a plane that its unit `normal` points away from.
struct HalfSpace
{
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();

  double distance(const Vec3& p) const { return (p - point).dot(normal); }
  BoundingSphere bound() const { return {point, 1e9}; }
};

using DistanceShape = std::variant<Ellipsoid, Capsule, Tube, RoundedBox, Ring, Sheet, HalfSpace>;

/// The rotation that turns first about R (pitch), then A (roll), then S (yaw), right-handed [deg].
Mat3 turned(double pitch, double roll, double yaw);

/// Union whose crease is filled where the two distances differ by less than `blend` [mm].
double smooth_union(double a, double b, double blend);
/// Intersection whose edge is rounded in the same way.
double smooth_intersection(double a, double b, double blend);
/// `from` without `cut`, with the edge rounded in the same way.
double smooth_subtraction(double from, double cut, double blend);

} // namespace f2b
