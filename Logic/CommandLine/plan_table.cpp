#include "CommandLine/plan_table.hpp"

#include "Case/plan_findings.hpp"
#include "Case/plan_intervals.hpp"
#include "Core/geometry/movement_words.hpp"

#include <cstdio>
#include <vector>

namespace f2b
{
namespace
{

using nlohmann::json;

template <class... Values>
void print(std::string& text, const char* format, Values... values)
{
  char line[256];
  std::snprintf(line, sizeof line, format, values...);
  text += line;
}

void add_movements(std::string& text, const std::string& method, const json& fragments)
{
  print(text, "\nMovement of the bone fragments, %s\n", method.c_str());
  print(text, "  %-16s %-18s %12s  %s\n", "Region", "Axis", "Displacement", "Direction");
  for (const json& f : fragments)
  {
    const json& t = f.at("translation_mm");
    const json& r = f.at("rotation_deg");
    const Vec3 translation(t.at("right"), t.at("anterior"), t.at("superior"));
    const RotationDegrees rotation{r.at("pitch"), r.at("roll"), r.at("yaw")};
    for (const MovementRow& row : describe_movement(translation, rotation))
    {
      std::string amount = amount_text(row);
      // the degree sign is two bytes but one column
      const int width = row.unit == MovementUnit::Degree ? 13 : 12;
      print(text, "  %-16s %-18s %*s  %s\n", f.at("name").get<std::string>().c_str(),
            row.axis.c_str(), width, amount.c_str(), row.direction.c_str());
    }
    const json& c = f.at("reference_point_ras");
    print(text, "  of the fragment's area centroid at R %.1f, A %.1f, S %.1f mm\n",
          c[0].get<double>(), c[1].get<double>(), c[2].get<double>());
  }
}

void add_errors(std::string& text, const json& methods, const char* key, const char* title)
{
  static const char* columns[] = {"mean", "sd",  "variance", "median",
                                  "p90",  "p95", "max",      "signed_mean"};
  print(text, "\n%s\n  %-15s", title, "");
  for (const char* column : columns)
    print(text, "%9s", column == std::string("signed_mean") ? "signed" : column);
  print(text, "%9s%9s\n", "<1 mm", "<2 mm");
  for (const auto& [name, method] : methods.items())
  {
    if (!method.contains(key))
      continue;
    const json& e = method.at(key);
    print(text, "  %-15s", name.c_str());
    for (const char* column : columns)
      print(text, "%9.3f", e.at(column).get<double>());
    print(text, "%7.1f %%%7.1f %%\n", 100 * e.at("under_1mm").get<double>(),
          100 * e.at("under_2mm").get<double>());
  }
}

void add_rows(std::string& text, const char* title,
              const std::vector<std::pair<std::string, std::string>>& rows)
{
  if (rows.empty())
    return;
  text += std::string("\n") + title + "\n";
  for (const auto& [key, value] : rows)
    text += "  " + key + ": " + value + "\n";
}

} // namespace

std::string plan_table(const json& plan)
{
  std::string text;
  const json& mesh = plan.at("mesh");
  print(text, "Mesh: %d prisms, %d tetrahedra, %d nodes\n", mesh.at("prisms").get<int>(),
        mesh.at("tets").get<int>(), mesh.at("nodes").get<int>());
  for (const char* method : {"rigid-fit", "virtual-force"})
    if (plan.at("methods").contains(method))
      add_movements(text, method, plan.at("methods").at(method).at("fragments"));
  add_errors(text, plan.at("methods"), "skin_error_mm", "Predicted face against the target [mm]");
  add_errors(text, plan.at("methods"), "load_residual_mm",
             "What the virtual force itself leaves [mm]");
  text += "\nWhat these cuts reach\n";
  for (const json& sentence : plan.at("reachability").at("sentences"))
    text += "  " + sentence.get<std::string>() + "\n";
  add_rows(text, "How sure the movement is (90 % intervals), rigid-fit", interval_rows(plan));
  add_rows(text, "The cuts after the movement, rigid-fit", cut_rows(plan));
  add_rows(text, "The bite, rigid-fit", bite_rows(plan));
  text += "\n";
  for (const json& warning : plan.at("warnings"))
    text += "Warning: " + warning.get<std::string>() + "\n";
  print(text, "\n%.1f s in all, %.1f GiB at most. Research software, not a medical device.\n",
        plan.at("timing_s").at("total").get<double>(), plan.at("peak_rss_mb").get<double>() / 1024);
  return text;
}

} // namespace f2b
