#pragma once

#include "Imaging/head_mask.hpp"

/// Where are the face, the bone and the closed bone, better than to a sample, in a part of the
/// head?
namespace f2b
{

struct TissueSurfaceOptions
{
  double skin_threshold_hu = -220;
  double bone_threshold_hu = 240;
  double head_closing_mm = 5;
  double bone_closing_mm = 8;
  double smallest_bone_ml = 0.5;
};

/// Distance to the face [mm]: the isosurface of the CT but for the holder, the shut openings and
/// the filled cavities.
ScalarGrid face_distance(const ScalarGrid& hu, const HeadMask& head,
                         const TissueSurfaceOptions& options);

/// Distance to the bone [mm], without streaks and small pieces.
ScalarGrid bone_distance(const ScalarGrid& hu, const HeadMask& head,
                         const TissueSurfaceOptions& options);

/// Distance to the bone together with the air of sinuses, nose, mouth and pharynx, closed and with
/// its cavities filled [mm]: what lies between it and the face is soft tissue.
ScalarGrid closed_bone_distance(const ScalarGrid& hu, const ScalarGrid& skin,
                                const ScalarGrid& bone, const HeadMask& head,
                                const TissueSurfaceOptions& options);

} // namespace f2b
