#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>

/// Which files does a case document name? It must be valid by the schema.
namespace f2b
{

/// Calls visit(path) for the text of each file that a document names.
void visit_paths(nlohmann::json& document, const std::function<void(nlohmann::json&)>& visit);
/// The same for the rules of one fragment's movement.
void visit_rule_paths(nlohmann::json& movement, const std::function<void(nlohmann::json&)>& visit);

/// The document as a case folder keeps it: files within the folder by their names in it, so that
/// the folder can be moved, all others as they are.
nlohmann::json with_folder_paths(nlohmann::json document, const std::filesystem::path& folder);

} // namespace f2b
