#pragma once

#include "Imaging/binary_mask.hpp"

/// Where, roughly, is the head in the CT, and what around it is holder, couch, cloth or air?
namespace f2b
{

/// The whole head on a 2 mm lattice. A fine segmentation of a part of it asks here for what can be
/// known only from the whole: which air is outside, which cavities are inside.
struct HeadMask
{
  ScalarGrid head;         ///< signed distance to the head without its holder, airways open [mm]
  BinaryMask outer_air;    ///< air farther from the closed head than the head closing radius
  BinaryMask outside_bone; ///< well farther from bone than its closing radius, not in the cranium
  BinaryMask bone;         ///< samples of the head above the bone threshold
};

struct HeadMaskOptions
{
  double skin_threshold_hu = -220;
  double bone_threshold_hu = 240;
  double head_closing_mm = 5;
  double bone_closing_mm = 8;
  double opening_mm = 3;            ///< bridges thinner than twice this do not belong to the head
  double largest_appendage_ml = 30; ///< an ear may be thin; a larger thin thing is holder or cloth
};

/// \param hu  the whole CT on a lattice of about 2 mm
HeadMask find_head(const ScalarGrid& hu, const HeadMaskOptions& options);

} // namespace f2b
