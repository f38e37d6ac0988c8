#pragma once

#include "Core/geometry/vectors.hpp"

#include <string>

/// Which surface does a saw follow along a line that is drawn on bone?
namespace f2b
{

/// A polyline swept along one direction. Positions in mm, RAS.
struct SweptCurve
{
  std::string name;
  std::vector<Vec3> points;          ///< at least two; drawn on the bone
  bool closed = false;               ///< the last point is joined to the first
  Vec3 direction = -Vec3::UnitY();   ///< unit; from the line into the bone
  double depth_mm = 20, lead_mm = 5; ///< the blade reaches so far along it, and so far against it
};

/// The points of a smooth curve (a centripetal Catmull-Rom spline, as drawn by Slicer's curves but
/// for their parametrisation) through control points, about `spacing_mm` apart; or those of straight
/// lines between them. Control points that coincide with the one before are left out.
std::vector<Vec3> resampled_curve(const std::vector<Vec3>& control_points, bool closed,
                                  bool straight, double spacing_mm);

/// Throws Error with the curve's name where a blade of this width would cut through itself: fewer
/// than two points, no depth, a turn that is too sharp, a line that comes back to itself, all as
/// seen along the direction.
void require_swept(const SweptCurve& curve, double kerf_mm);

} // namespace f2b
