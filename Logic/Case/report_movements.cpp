#include "Case/case_pictures.hpp"
#include "Case/report_parts.hpp"
#include "Case/report_results.hpp"
#include "Core/geometry/movement_words.hpp"

#include <array>
#include <limits>

namespace f2b
{
namespace
{

using nlohmann::json;

/// The half width that belongs to each row of describe_movement, in the row's unit.
std::array<double, 6> half_widths(const json& plan, const std::string& fragment)
{
  std::array<double, 6> none{};
  none.fill(std::numeric_limits<double>::quiet_NaN());
  const auto intervals = plan_intervals(plan, fragment);
  if (!intervals)
    return none;
  const auto& t = intervals->translation_mm;
  const auto& r = intervals->rotation_deg;
  return {t[1], t[2], r[1], t[0], r[0], r[2]};
}

/// As the paper's Table 2.
ReportTable table2(const json& plan, const std::string& method, const Texts& texts)
{
  ReportTable table =
      report_table("movement_" + method, texts("table.movement", {{"method", method}}),
                   {{"fragment"}, {"axis"}, {"displacement"}, {"unit"}, {"direction"}}, texts);
  const bool has_intervals = method == "rigid-fit";
  if (has_intervals)
    table.columns.push_back(report_column("interval", texts));
  for (const json& f : plan.at("methods").at(method).at("fragments"))
  {
    const std::string name = f.at("name").get<std::string>();
    const json& t = f.at("translation_mm");
    const json& r = f.at("rotation_deg");
    const std::array<double, 6> half = half_widths(plan, name);
    std::size_t i = 0;
    for (const MovementRow& row : describe_movement(
             Vec3(t.at("right").get<double>(), t.at("anterior").get<double>(),
                  t.at("superior").get<double>()),
             {r.at("pitch").get<double>(), r.at("roll").get<double>(), r.at("yaw").get<double>()}))
    {
      table.rows.push_back({name, word(row.axis, texts), ReportValue(row.amount, 2),
                            row.unit == MovementUnit::Degree ? "\u00b0" : "mm",
                            word(row.direction, texts)});
      if (has_intervals)
        table.rows.back().emplace_back(half[i++], 2);
    }
  }
  return table;
}

void add_coordinates(std::vector<ReportValue>& row, const json& movement)
{
  for (const char* key : {"right", "anterior", "superior"})
    row.emplace_back(movement.at("translation_mm").at(key).get<double>(), 2);
  for (const char* key : {"pitch", "roll", "yaw"})
    row.emplace_back(movement.at("rotation_deg").at(key).get<double>(), 2);
}

/// Every coordinate of every fragment, for other programs.
ReportTable coordinates(const json& plan, const Texts& texts)
{
  ReportTable table = report_table("movements", texts("table.movements"),
                                   {{"fragment"},
                                    {"method"},
                                    {"right", "mm"},
                                    {"anterior", "mm"},
                                    {"superior", "mm"},
                                    {"pitch", "\u00b0"},
                                    {"roll", "\u00b0"},
                                    {"yaw", "\u00b0"},
                                    {"c_right", "mm"},
                                    {"c_anterior", "mm"},
                                    {"c_superior", "mm"}},
                                   texts);
  for (const std::string& method : methods_of(plan))
    for (const json& f : plan.at("methods").at(method).at("fragments"))
    {
      std::vector<ReportValue> row{f.at("name").get<std::string>(), method};
      add_coordinates(row, f);
      for (const json& c : f.at("reference_point_ras"))
        row.emplace_back(c.get<double>(), 1);
      table.rows.push_back(std::move(row));
    }
  table.note = texts("note.convention");
  return table;
}

/// The movements along and about the patient's own axes; no rows without them.
ReportTable patient_coordinates(const json& plan, const Texts& texts)
{
  ReportTable table = report_table("movements_patient", texts("table.movements_patient"),
                                   {{"fragment"},
                                    {"method"},
                                    {"right", "mm"},
                                    {"anterior", "mm"},
                                    {"superior", "mm"},
                                    {"pitch", "\u00b0"},
                                    {"roll", "\u00b0"},
                                    {"yaw", "\u00b0"}},
                                   texts);
  for (const std::string& method : methods_of(plan))
    for (const json& f : plan.at("methods").at(method).at("fragments"))
      if (f.contains("in_patient_frame"))
      {
        std::vector<ReportValue> row{f.at("name").get<std::string>(), method};
        add_coordinates(row, f.at("in_patient_frame"));
        table.rows.push_back(std::move(row));
      }
  return table;
}

} // namespace

ReportSection movement_section(const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.movement");
  for (const std::string& method : methods_of(plan))
  {
    section.tables.push_back(table2(plan, method, texts));
    section.tables.back().note = texts(std::string("note.") + method);
  }
  section.tables.push_back(coordinates(plan, texts));
  if (ReportTable own = patient_coordinates(plan, texts); !own.rows.empty())
    section.tables.push_back(std::move(own));
  section.note = texts("note.intervals");
  return section;
}

} // namespace f2b
