#pragma once

#include "Case/case_folder.hpp"

#include <nlohmann/json.hpp>

/// What do the cephalometric measures become?
namespace f2b
{

/// The measures of a planned case, one object each: `name`, `unit`, `definition`, and the numbers
/// `before`, `target` (of measures on the skin alone: the target is a face) and `predicted`
/// (rigid-fit). Landmarks of bone and teeth go with the fragment that carries them, those of the
/// skin with the nearest vertex of the reference skin. Empty where landmarks are missing.
nlohmann::json cephalometry_of(const CaseFolder& folder, const nlohmann::json& plan);

} // namespace f2b
