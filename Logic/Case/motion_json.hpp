#pragma once

#include "Core/geometry/rigid_motion.hpp"

#include <nlohmann/json.hpp>

#include <string>

/// How is a fragment's movement written in the files of a case?
namespace f2b
{

/// Name, matrix (rest to moved points, RAS), reference point, translation [mm], angles [degrees].
nlohmann::json motion_json(const std::string& name, const RigidMotion& motion);

} // namespace f2b
