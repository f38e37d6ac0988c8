#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Core/geometry/surface_points.hpp"

/// How must a surface move rigidly to lie on another one, of which parts may be missing?
///
/// The other surface is given by its signed distance d. Gauss-Newton on the motion (R, t) minimises
/// the mean over the points of `1 - c s^2 / (d^2 + s^2)`, d at the moved point: the robust function
/// of S. Geman and D. McClure (1985), with c the cosine between the moved normal and the slope of
/// d, 0 where they point apart, so that the two sides of a thin wall are not mistaken for each
/// other. The scale s falls from `first_scale_mm` to `last_scale_mm`, which widens the basin
/// (graduated non-convexity: A. Blake and A. Zisserman, Visual Reconstruction, 1987).
namespace f2b
{

struct SurfaceFitOptions
{
  double first_scale_mm = 8;
  double last_scale_mm = 0.5;
  int iterations_per_scale = 12;
};

struct SurfaceFit
{
  RigidMotion motion;
  double cost = 1;         ///< at the last scale, in [0, 1]; 1: nothing fits
  double inlier_share = 0; ///< of the points: within three last scales, normals alike
  double rms_mm = 0;       ///< distance of those points
  /// Least mean square of what a motion of unit length (rotations times the points' radius of
  /// gyration) changes in the distances: 1/6 where all directions are held alike, 0 where the
  /// surface can slide on itself.
  double least_hold = 0;
};

/// Fits from one start.
/// \param distance  negative inside; points outside its box count as not fitting
SurfaceFit fit_surface(const std::vector<SurfaceSample>& points, const ScalarGrid& distance,
                       const RigidMotion& start, const SurfaceFitOptions& options = {});

/// The fits from several starts, the best first; equal ones in the order of their starts.
std::vector<SurfaceFit> fit_surface_from(const std::vector<RigidMotion>& starts,
                                         const std::vector<SurfaceSample>& points,
                                         const ScalarGrid& distance,
                                         const SurfaceFitOptions& options = {});

/// Largest distance between the places to which two motions take a set of points [mm].
double largest_difference(const RigidMotion& a, const RigidMotion& b,
                          const std::vector<SurfaceSample>& points);

/// Angle between the rotations of two motions [rad].
double angle_between(const RigidMotion& a, const RigidMotion& b);

} // namespace f2b
