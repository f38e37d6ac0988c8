#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

#include <string>
#include <vector>

/// How do the upper and the lower teeth meet?
///
/// The occlusal plane passes through U1, U6_R and U6_L and moves with them. The mid-sagittal plane
/// passes through N at right angles to the mean direction of the pairs Or and Zy (Zy if it is
/// there): upper face, at rest, so that a moved or asymmetric jaw does not shift it. Landmarks are
/// tips of teeth, so all figures are as exact as those were placed. Frame RAS, mm.
namespace f2b
{

struct Bite
{
  double overjet_mm = 0;        ///< U1 in front of L1, along the occlusal plane; negative: behind
  double overbite_mm = 0;       ///< L1 above U1, across it; negative: open bite
  double dental_midline_mm = 0; ///< L1 to the patient's right of U1
  double upper_midline_mm = 0;  ///< U1 to the right of the mid-sagittal plane
  double lower_midline_mm = 0;  ///< L1 to the right of it
};

/// A plane of the head at rest; its normal points to the patient's right.
struct MidSagittalPlane
{
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitX();
};

/// Landmarks that a bite needs and that are not given: U1, U6_R, U6_L, L1, N, Or_R, Or_L.
std::vector<std::string> missing_for_bite(const Landmarks& landmarks);

/// The landmarks on teeth: U1, U6_R, U6_L, L1.
const std::vector<std::string>& tooth_landmarks();

/// Throws Error naming a landmark that is not there; so do the functions below.
MidSagittalPlane mid_sagittal_plane(const Landmarks& rest);
Bite bite(const Landmarks& landmarks, const MidSagittalPlane& mid_sagittal);

/// A point in the bone that carries a tooth: 10 mm from its tip, U1 towards A, L1 towards B (across
/// the occlusal plane where those are not given, and for U6). The tips themselves may touch the
/// other jaw's teeth.
Vec3 bone_of_tooth(const Landmarks& landmarks, const std::string& tooth);

} // namespace f2b
