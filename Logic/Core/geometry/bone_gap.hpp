#pragma once

#include "Core/geometry/bone_overlap.hpp"

/// How wide does a cut open when its two sides move apart?
namespace f2b
{

/// Widths at right angles to the cut, beyond the kerf: 0 where the sawn faces are as far apart as
/// the saw left them. Only where they still face each other: a part that slides along its cut
/// leaves a step, not a gap.
struct BoneGap
{
  double cut_mm2 = 0;      ///< common cut at rest
  double facing_share = 0; ///< of it that still faces the other part after the movement, [0, 1]
  double mean_mm = 0;      ///< over that share; where the faces close or overlap it counts as 0
  double max_mm = 0;
  double volume_mm3 = 0;
  Vec3 widest = Vec3::Zero(); ///< on the other part's face, after the movement [mm, RAS]
};

/// The gap along the common cut of two parts; all 0 where they have none.
BoneGap gap_between(const CutBone& cut, const MovedPart& part, const MovedPart& other);

} // namespace f2b
