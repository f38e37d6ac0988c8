#pragma once

#include "Rendering/report_document.hpp"
#include "Rendering/texts.hpp"

#include <nlohmann/json.hpp>

/// What does a plan say, as sections of a report? Numbers are those of plan.json; none is computed.
namespace f2b
{

ReportSection movement_section(const nlohmann::json& plan, const Texts& texts);
ReportSection error_section(const nlohmann::json& plan, const Texts& texts);
ReportSection reach_section(const nlohmann::json& plan, const Texts& texts);
/// Gap and overlap at the cuts, and the bite.
ReportSection cut_section(const nlohmann::json& plan, const Texts& texts);
ReportSection cephalometry_section(const nlohmann::json& plan, const Texts& texts);
/// `cephalometry` of plan.json; with no measures where an older program planned.
nlohmann::json cephalometry_of(const nlohmann::json& plan);
ReportSection suggestion_section(const nlohmann::json& suggested, const Texts& texts);

} // namespace f2b
