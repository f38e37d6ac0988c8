#pragma once

#include "Rendering/report_document.hpp"
#include "Rendering/texts.hpp"

#include <nlohmann/json.hpp>

/// What do the sections of a report have in common?
namespace f2b
{

/// Titled by the text `column.KEY`.
ReportColumn report_column(const std::string& key, const Texts& texts,
                           const std::string& unit = "");
struct ReportHead
{
  const char* key;
  const char* unit = "";
};
/// An empty table with columns as report_column titles them.
ReportTable report_table(const std::string& id, const std::string& caption,
                         const std::vector<ReportHead>& columns, const Texts& texts);
/// Those that gave a plan; a warning tells of the others.
std::vector<std::string> methods_of(const nlohmann::json& plan);
/// A word of Core in the report's language.
std::string word(const std::string& english, const Texts& texts);
std::string joined(const nlohmann::json& words, const char* between = ", ");

} // namespace f2b
