#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace f2b
{

/// A plan.json as the terminal shows it: Table 2 of the paper per method, and the errors side by
/// side.
std::string plan_table(const nlohmann::json& plan);

} // namespace f2b
