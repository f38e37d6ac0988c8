#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace f2b
{

/// `NAME:right,anterior,superior,pitch,roll,yaw` as the case file's movements; throws Error.
nlohmann::json movements_from_arguments(const std::vector<std::string>& arguments);

} // namespace f2b
