#pragma once

#include "Case/case_folder.hpp"
#include "Rendering/plan_scene.hpp"

#include <nlohmann/json.hpp>

/// What of a case can be drawn?
namespace f2b
{

struct PictureNeeds
{
  bool mesh = false; ///< boundary parts and contact surfaces
  bool ct = false;
};

/// The surfaces of a case as far as its steps have been done; `segment` at least.
/// Throws Error if the case has no skin.
PlanPictures case_pictures(const CaseFolder& folder, const PictureNeeds& needs);

/// The 90 % intervals that a plan tells for a fragment, if it does.
std::optional<MovementIntervals> plan_intervals(const nlohmann::json& plan,
                                                const std::string& fragment);

} // namespace f2b
