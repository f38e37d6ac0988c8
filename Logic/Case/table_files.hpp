#pragma once

#include "Rendering/report_document.hpp"

#include <nlohmann/json.hpp>

/// How do a report's tables reach other programs?
namespace f2b
{

/// RFC 4180, UTF-8, numbers in full; the units stand in the head.
std::string csv_of(const ReportTable& table);

/// `columns` (key, title, unit) and `rows` of strings, numbers in full and nulls.
nlohmann::json to_json(const ReportTable& table);

} // namespace f2b
