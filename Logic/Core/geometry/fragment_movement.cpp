#include "Core/geometry/fragment_movement.hpp"

#include "Core/error.hpp"

#include <cmath>

namespace f2b
{
namespace
{

/// A motion and its neighbours along and about the three axes.
void append_around(const RigidMotion& motion, std::vector<RigidMotion>& starts)
{
  constexpr double length_mm = 4, angle = 5 * 3.14159265358979323846 / 180;
  starts.push_back(motion);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
    {
      starts.push_back(motion.followed_by(Vec3::Zero(), sign * length_mm * Vec3::Unit(axis)));
      starts.push_back(motion.followed_by(sign * angle * Vec3::Unit(axis), Vec3::Zero()));
    }
}

} // namespace

std::vector<SurfaceSample> fragment_surface(const ScalarGrid& bone, const BonePartition& partition,
                                           unsigned char label, std::size_t at_most)
{
  const double on_bone = 0.2 * bone.spacing;
  return surface_points(
      part_field(bone, partition, label),
      [&](const Vec3& p) { return std::abs(bone.value(p)) < on_bone; }, at_most);
}

FragmentMovement measure_fragment_movement(const std::vector<SurfaceSample>& fragment,
                                           const ScalarGrid& postoperative_bone,
                                           const RigidMotion& planned,
                                           const std::string& fragment_name)
{
  constexpr double elsewhere_mm = 1;
  RigidMotion rest;
  rest.reference_point = planned.reference_point;
  std::vector<RigidMotion> starts;
  append_around(planned, starts);
  append_around(rest, starts);
  SurfaceFitOptions options;
  options.first_scale_mm = 4;
  const std::vector<SurfaceFit> fits =
      fit_surface_from(starts, fragment, postoperative_bone, options);

  FragmentMovement movement;
  movement.fit = fits.front();
  if (fragment.empty() || movement.fit.inlier_share < 0.2)
    throw Error("fragment '" + fragment_name + "'",
                "only " + std::to_string(std::lround(100 * movement.fit.inlier_share)) +
                    " % of its surface finds bone to lie on in the post-operative CT",
                "check that the CT shows this fragment and that its registration is right",
                ErrorKind::Numerical);
  for (const SurfaceFit& other : fits)
  {
    const double mm = largest_difference(movement.fit.motion, other.motion, fragment);
    if (mm < elsewhere_mm)
      continue;
    movement.rival_cost = other.cost;
    movement.rival_mm = mm;
    break;
  }
  return movement;
}

} // namespace f2b
