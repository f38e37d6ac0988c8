#pragma once

#include <Rendering/framing.hpp>
#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

/// Which pictures of a plan are there? One function each; all need a living OffscreenDisplay.
///
/// Every picture of the face, and every one of the bones, frames all states (before, target,
/// predicted; at rest, planned) alike: what differs between two of them has really moved.
/// Comparisons are several panels of `panel_size` side by side, all at one scale.
namespace f2b
{

enum class FaceState
{
  Before,
  Target,
  Predicted,
};

enum class BoneState
{
  Before,
  After,
};

Image face_picture(const PlanScene& scene, FaceState state, View view, PixelSize size);
/// Before | target | predicted, those that there are.
Image face_comparison(const PlanScene& scene, View view, PixelSize panel_size);

/// Length of the wished displacement on the skin. Needs a target or its displacement array.
Image target_region_picture(const PlanScene& scene, PixelSize panel_size);
/// Signed distance between predicted and target on the predicted skin. Needs has_distance().
Image distance_map_picture(const PlanScene& scene, PixelSize panel_size);

/// What these cuts leave of the target, on the predicted skin. Needs has_unreachable().
Image reachability_picture(const PlanScene& scene, PixelSize panel_size);
/// The regions of the face on the skin before. Needs has_regions().
Image regions_picture(const PlanScene& scene, PixelSize panel_size);

Image bones_picture(const PlanScene& scene, BoneState state, View view, PixelSize size);
/// Before | after.
Image bones_comparison(const PlanScene& scene, View view, PixelSize panel_size);

/// The planned bones through the predicted face (the face before, if nothing is predicted).
Image face_over_bones_picture(const PlanScene& scene, PixelSize panel_size);

} // namespace f2b
