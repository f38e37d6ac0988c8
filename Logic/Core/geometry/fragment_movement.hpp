#pragma once

#include "Core/geometry/osteotomy.hpp"
#include "Core/geometry/surface_fit.hpp"

/// How did a cut fragment really move, by the bone of a post-operative CT?
namespace f2b
{

struct FragmentMovement
{
  SurfaceFit fit; ///< of the fragment's surface, cut faces left out, to the post-operative bone
  /// The best fit that lies more than 1 mm elsewhere: its cost (1 if there is none) and how far.
  double rival_cost = 1;
  double rival_mm = 0;

  /// May the found place be a wrong one? Another fits almost as well, or only a small part fits.
  bool doubtful() const { return rival_cost < 1.1 * fit.cost || fit.inlier_share < 0.4; }
};

/// Surface of a fragment that is the bone's own, not a saw's [mm, RAS].
/// \param bone   pre-operative signed distance, negative inside
/// \param label  first_fragment + index
std::vector<SurfaceSample> fragment_surface(const ScalarGrid& bone, const BonePartition& partition,
                                           unsigned char label, std::size_t at_most = 4000);

/// Fits a fragment to the post-operative bone, from the planned movement, from rest, and from 4 mm
/// and 5 degrees around both; the best wins.
///
/// \param postoperative_bone  signed distance in the frame of the pre-operative CT [mm]
/// \param planned             where to start; its reference point is kept
/// Throws Error (Numerical) if under a fifth of the fragment finds bone to lie on.
FragmentMovement measure_fragment_movement(const std::vector<SurfaceSample>& fragment,
                                           const ScalarGrid& postoperative_bone,
                                           const RigidMotion& planned,
                                           const std::string& fragment_name);

} // namespace f2b
