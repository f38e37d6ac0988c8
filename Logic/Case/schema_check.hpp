#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace f2b
{

/// Throws Error with the first fault that a JSON Schema finds in a document, in one line.
/// \param source  the document's file, for the message
void check_against_schema(const nlohmann::json& document, const nlohmann::json& schema,
                          const std::string& source);

} // namespace f2b
