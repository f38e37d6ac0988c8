#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace f2b
{

/// A suggest.json as the terminal shows it: the cuts by rank, what was not possible, and what
/// decided.
std::string suggestion_table(const nlohmann::json& suggestion);

} // namespace f2b
