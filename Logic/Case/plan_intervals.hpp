#pragma once

#include "Core/inverse/plan_uncertainty.hpp"

#include <nlohmann/json.hpp>

/// How does a plan say how sure it is?
namespace f2b
{

/// For every fragment by name, half of the 90 % interval of each of its coordinates (pitch, roll,
/// yaw, hinge in degrees; right, anterior, superior in mm), with the shares of its causes as
/// standard deviations. A coordinate at a bound says so.
nlohmann::json intervals_json(const MovementSpace& space,
                              const std::vector<CoordinateUncertainty>& uncertainty,
                              const std::vector<Eigen::Index>& at_bounds);
/// Rows such as "mid-face", "pitch +-1.1, roll +-0.4, yaw +-0.5 degrees; right +-0.6, anterior +-0.5,
/// superior +-0.6 mm; most of it from registration" (with plus-minus signs); empty without intervals.
std::vector<std::pair<std::string, std::string>> interval_rows(const nlohmann::json& plan);
/// What the intervals assume, with units in the keys.
nlohmann::json to_json(const UncertaintySources& sources);

} // namespace f2b
