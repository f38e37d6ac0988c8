#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Core/inverse/skin_error.hpp"

#include <nlohmann/json.hpp>

#include <string>

/// How are movements of fragments and distances of faces written in a case's results?
namespace f2b
{

/// `matrix_ras` maps rest to moved points, row by row; angles in degrees.
nlohmann::json motion_json(const std::string& fragment, const RigidMotion& motion);
/// The movement that motion_json wrote.
RigidMotion motion_from(const nlohmann::json& fragment);

nlohmann::json error_json(const SkinError& error);

} // namespace f2b
