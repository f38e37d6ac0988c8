#pragma once

#include "Core/geometry/vectors.hpp"

#include <optional>

/// What does a cursor point at when it drags something along an axis, on a plane, or around a circle?
namespace f2b
{

/// Half a line from the eye into the picture.
struct LineOfSight
{
  Vec3 origin = Vec3::Zero();
  Vec3 direction = -Vec3::UnitY(); ///< unit
};

/// Position on an axis, from `point`, that is nearest to the line [mm]. None where the two are
/// within 5 degrees of parallel: a pixel would be too long a way.
/// \param axis  unit
std::optional<double> along_axis(const LineOfSight& line, const Vec3& point, const Vec3& axis);

/// Where the line meets a plane; none where it runs within 5 degrees of it, or away from it.
std::optional<Vec3> on_plane(const LineOfSight& line, const Vec3& point, const Vec3& normal);

/// Angle [rad] about an axis, right-handed, from one point to another, both seen from `centre`; in
/// (-pi, pi]. 0 where one of them lies on the axis.
double angle_about(const Vec3& centre, const Vec3& axis, const Vec3& from, const Vec3& to);

} // namespace f2b
