#include "Case/report_results.hpp"

#include "Case/report_parts.hpp"
#include "Core/geometry/face_regions.hpp"

#include <limits>

namespace f2b
{
namespace
{

using nlohmann::json;

double number_at(const json& object, const char* key)
{
  const bool is_there = object.contains(key) && object.at(key).is_number();
  return is_there ? object.at(key).get<double>() : std::numeric_limits<double>::quiet_NaN();
}

struct ErrorFigure
{
  const char* key;
  const char* unit;
  double factor;
  int decimals;
};
constexpr ErrorFigure error_figures[] = {{"mean", "mm", 1, 2},
                                         {"sd", "mm", 1, 2},
                                         {"variance", "mm\u00b2", 1, 2},
                                         {"median", "mm", 1, 2},
                                         {"p90", "mm", 1, 2},
                                         {"p95", "mm", 1, 2},
                                         {"max", "mm", 1, 2},
                                         {"under_1mm", "%", 100, 1},
                                         {"under_2mm", "%", 100, 1},
                                         {"signed_mean", "mm", 1, 2},
                                         {"area_mm2", "mm\u00b2", 1, 0}};

std::vector<ReportColumn> error_columns(const std::string& first, const Texts& texts)
{
  std::vector<ReportColumn> columns{report_column(first, texts)};
  for (const ErrorFigure& figure : error_figures)
    columns.push_back(report_column(figure.key, texts, figure.unit));
  return columns;
}

std::vector<ReportValue> error_row(const std::string& first, const json& error)
{
  std::vector<ReportValue> row{first};
  for (const ErrorFigure& figure : error_figures)
    row.emplace_back(figure.factor * number_at(error, figure.key), figure.decimals);
  return row;
}

ReportTable errors(const json& plan, const Texts& texts)
{
  ReportTable table;
  table.id = "skin_errors";
  table.caption = texts("table.skin-errors");
  table.columns = error_columns("method", texts);
  for (const std::string& method : methods_of(plan))
    table.rows.push_back(error_row(method, plan.at("methods").at(method).at("skin_error_mm")));
  const json force = plan.at("methods").value("virtual-force", json::object());
  if (force.contains("load_residual_mm"))
    table.rows.push_back(error_row(texts("row.load-residual"), force.at("load_residual_mm")));
  return table;
}

ReportTable region_errors(const json& plan, const std::string& method, const Texts& texts)
{
  ReportTable table;
  table.id = "skin_errors_by_region_" + method;
  table.caption = texts("table.region-errors", {{"method", method}});
  table.columns = error_columns("region", texts);
  const json& error = plan.at("methods").at(method).at("skin_error_mm");
  for (const char* part : {"cut", "outside_cut"})
    if (error.contains(part) && error.at(part).at("area_mm2") > 0)
      table.rows.push_back(error_row(texts(std::string("row.") + part), error.at(part)));
  const json& regions = error.at("by_region");
  for (const FaceRegion region : all_face_regions())
    if (const std::string key = key_of(region); regions.contains(key))
      table.rows.push_back(error_row(texts("region." + key), regions.at(key)));
  return table;
}

ReportTable reach_table(const json& regions, const Texts& texts)
{
  ReportTable table = report_table("reachability", texts("table.reachability"),
                                   {{"region"},
                                    {"area_mm2", "mm\u00b2"},
                                    {"asked_p90", "mm"},
                                    {"asked_max", "mm"},
                                    {"left_p90", "mm"},
                                    {"left_max", "mm"},
                                    {"share_left", "%"}},
                                   texts);
  for (const FaceRegion region : all_face_regions())
    if (const std::string key = key_of(region); regions.contains(key))
    {
      const json& r = regions.at(key);
      table.rows.push_back({texts("region." + key), ReportValue(number_at(r, "area_mm2"), 0),
                            ReportValue(number_at(r.at("asked_mm"), "p90"), 2),
                            ReportValue(number_at(r.at("asked_mm"), "max"), 2),
                            ReportValue(number_at(r.at("left_mm"), "p90"), 2),
                            ReportValue(number_at(r.at("left_mm"), "max"), 2),
                            ReportValue(100 * number_at(r, "share_left"), 0)});
    }
  return table;
}

ReportTable cut_table(const json& plan, const std::string& method, const Texts& texts)
{
  ReportTable table = report_table("cuts_" + method, texts("table.cuts", {{"method", method}}),
                                   {{"between"},
                                    {"gap_mean", "mm"},
                                    {"gap_max", "mm"},
                                    {"gap_volume", "mm\u00b3"},
                                    {"facing_share", "%"},
                                    {"overlap_depth", "mm"},
                                    {"overlap_volume", "mm\u00b3"}},
                                   texts);
  for (const json& m : plan.at("methods").at(method).at("bone_contacts"))
  {
    const json& gap = m.at("gap");
    const json& overlap = m.at("overlap");
    const std::string between = m.at("between").at(0).get<std::string>() + " - " +
                                word(m.at("between").at(1).get<std::string>(), texts);
    table.rows.push_back({between, ReportValue(number_at(gap, "mean_mm"), 1),
                          ReportValue(number_at(gap, "max_mm"), 1),
                          ReportValue(number_at(gap, "volume_mm3"), 0),
                          ReportValue(100 * number_at(gap, "facing_share"), 0),
                          ReportValue(number_at(overlap, "depth_mm"), 1),
                          ReportValue(number_at(overlap, "volume_mm3"), 0)});
  }
  return table;
}

ReportTable bite_table(const json& bite, const Texts& texts)
{
  ReportTable table;
  table.id = "bite";
  table.caption = texts("table.bite");
  table.columns = {report_column("measure", texts),
                   report_column("before", texts, "mm"),
                   {"rigid-fit", "rigid-fit", "mm"},
                   {"virtual-force", "virtual-force", "mm"}};
  for (const char* key : {"overjet_mm", "overbite_mm", "lower_to_upper_midline_mm",
                          "upper_midline_mm", "lower_midline_mm"})
  {
    std::vector<ReportValue> row{texts(std::string("bite.") + key)};
    for (const char* state : {"before", "rigid-fit", "virtual-force"})
      row.emplace_back(number_at(bite.value(state, json::object()), key), 1);
    table.rows.push_back(std::move(row));
  }
  std::string carriers;
  for (const auto& [tooth, part] : bite.at("landmarks_ride_on").items())
    carriers +=
        (carriers.empty() ? "" : ", ") + tooth + ": " + word(part.get<std::string>(), texts);
  table.note = texts("note.bite", {{"carriers", carriers}});
  return table;
}

} // namespace

ReportSection error_section(const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.errors");
  section.tables.push_back(errors(plan, texts));
  for (const std::string& method : methods_of(plan))
    section.tables.push_back(region_errors(plan, method, texts));
  section.note = texts("note.errors");
  return section;
}

ReportSection reach_section(const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.reach");
  const json& reach = plan.at("reachability");
  section.points = reach.at("sentences").get<std::vector<std::string>>();
  if (!reach.at("regions").empty())
  {
    section.tables.push_back(reach_table(reach.at("regions"), texts));
    section.note = texts("note.reach");
  }
  return section;
}

ReportSection cut_section(const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.cuts");
  for (const std::string& method : methods_of(plan))
    section.tables.push_back(cut_table(plan, method, texts));
  const json& bite = plan.at("bite");
  if (bite.contains("before"))
    section.tables.push_back(bite_table(bite, texts));
  else if (bite.contains("missing_landmarks"))
    section.note = texts("note.no-bite", {{"landmarks", joined(bite.at("missing_landmarks"))}});
  return section;
}

json cephalometry_of(const json& plan)
{
  return plan.value("cephalometry", json{{"measures", json::array()}});
}

ReportSection cephalometry_section(const json& plan, const Texts& texts)
{
  const json told = cephalometry_of(plan);
  ReportSection section;
  section.heading = texts("section.cephalometry");
  ReportTable table = report_table(
      "cephalometry", texts("table.cephalometry"),
      {{"measure"}, {"unit"}, {"before"}, {"target"}, {"predicted"}, {"definition"}}, texts);
  for (const json& m : told.at("measures"))
    table.rows.push_back(
        {m.at("name").get<std::string>(), m.at("unit") == "deg" ? "\u00b0" : "mm",
         ReportValue(number_at(m, "before"), 1), ReportValue(number_at(m, "target"), 1),
         ReportValue(number_at(m, "predicted"), 1), m.at("definition").get<std::string>()});
  table.is_long = true;
  if (!told.contains("left_out"))
    section.paragraphs = {texts("note.no-cephalometry")};
  else if (!told.at("left_out").empty())
    section.paragraphs = {
        texts("note.left-out", {{"measures", joined(told.at("left_out"))},
                                {"landmarks", joined(told.at("missing_landmarks"))}})};
  if (table.rows.empty())
    return section;
  section.tables.push_back(std::move(table));
  section.note = texts("note.cephalometry");
  return section;
}

ReportSection suggestion_section(const json& suggested, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.suggestions");
  ReportTable table =
      report_table("suggestions", texts("table.suggestions"),
                   {{"cuts"}, {"reached", "%"}, {"rms_left", "mm"}, {"movement"}}, texts);
  for (const json& s : suggested.at("suggestions"))
  {
    std::string movement;
    for (const json& f : s.at("fragments"))
      movement += (movement.empty() ? "" : ". ") + f.at("name").get<std::string>() + ": " +
                  f.at("movement").get<std::string>();
    table.rows.push_back({joined(s.at("cuts"), " + "),
                          ReportValue(100 * s.at("reached").get<double>(), 0),
                          ReportValue(s.at("rms_left_mm").get<double>(), 2), movement});
  }
  table.is_long = true;
  section.tables.push_back(std::move(table));
  std::string not_possible;
  for (const json& n : suggested.at("not_possible"))
    not_possible += (not_possible.empty() ? "" : "; ") + joined(n.at("cuts"), " + ");
  section.note =
      texts("note.suggestions") +
      (not_possible.empty() ? "" : " " + texts("note.not-possible", {{"cuts", not_possible}}));
  return section;
}

} // namespace f2b
