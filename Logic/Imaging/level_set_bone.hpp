#pragma once

#include "Imaging/head_mask.hpp"
#include "Imaging/level_set_options.hpp"
#include "Imaging/tissue_surfaces.hpp"

/// Where is the bone that a threshold misses: in noise, and where its walls are thin?
namespace f2b
{

/// Distance to the bone [mm], like `bone_distance`, by a geodesic active contour that starts from the
/// threshold of the blurred CT and from the seeds.
ScalarGrid level_set_bone(const ScalarGrid& hu, const HeadMask& head,
                          const TissueSurfaceOptions& surfaces, const LevelSetBoneOptions& options);

} // namespace f2b
