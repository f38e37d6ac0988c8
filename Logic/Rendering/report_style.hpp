#pragma once

namespace f2b
{

/// Style sheet of a report: dark on light, one column, system fonts only; small tables and pictures
/// do not break across pages, which are numbered.
extern const char* const report_style;

} // namespace f2b
