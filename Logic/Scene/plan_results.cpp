#include "Scene/plan_results.hpp"

#include "Bridge/json_file.hpp"
#include "Scene/movement_text.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include <sys/stat.h>

namespace f2b
{
namespace
{

using nlohmann::json;
using Plan = vtkMRMLFaceToBonePlanNode;

json json_of(const CaseOutlook& files, const std::string& name)
{
  return files.has(name) ? read_json(files.file(name)) : json::object();
}

/// Every number below a value, under its path.
void add_figures(const json& value, const std::string& path, Plan* plan)
{
  if (value.is_number() && std::isfinite(value.get<double>()))
    plan->SetFigure(path, value.get<double>());
  else if (value.is_object())
    for (const auto& [key, member] : value.items())
      add_figures(member, path + "/" + key, plan);
}

void add_sentences(const json& list, std::vector<std::string>& sentences)
{
  if (list.is_array())
    for (const json& sentence : list)
      if (sentence.is_string())
        sentences.push_back(sentence.get<std::string>());
}

void read_movements(const json& told, int method, Plan* plan)
{
  for (const json& fragment : told.value("fragments", json::array()))
  {
    const auto name = fragment.at("name").get<std::string>();
    const SixCoordinates movement = coordinates_from(fragment);
    double reference[3];
    for (std::size_t a = 0; a < 3; ++a)
      reference[a] = fragment.at("reference_point_ras").at(a).get<double>();
    plan->SetMovement(method, name, movement.data(), reference);
    const json intervals = told.value("intervals", json::object())
                               .value("fragments", json::object())
                               .value(name, json::object());
    for (int c = 0; c < 6; ++c)
      if (intervals.contains(coordinate_keys[c]))
      {
        const double half = intervals[coordinate_keys[c]].at("half_90").get<double>();
        const double at = movement[static_cast<std::size_t>(c)];
        const double interval[2] = {at - half, at + half};
        plan->SetMovementInterval(method, name, c, interval);
      }
  }
}

/// A ranking's line: the cuts, and the share of the asked change that they reach.
std::vector<std::string> suggestion_lines(const json& suggestion)
{
  std::vector<std::string> lines;
  for (const json& entry : suggestion.value("suggestions", json::array()))
  {
    std::string cuts;
    for (const json& cut : entry.value("cuts", json::array()))
      cuts += (cuts.empty() ? "" : " + ") + cut.get<std::string>();
    char text[80];
    std::snprintf(text, sizeof text, ": %.0f %% of the change, %.2f mm left",
                  100 * entry.value("reached", 0.0), entry.value("rms_left_mm", 0.0));
    lines.push_back(cuts + text);
  }
  return lines;
}

/// When a file was written, as 2026-11-28T13:05:00Z.
std::string date_of(const Path& file)
{
  struct stat status = {};
  char text[32] = "";
  std::tm utc = {};
  if (::stat(file.c_str(), &status) == 0 && ::gmtime_r(&status.st_mtime, &utc))
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// With what the case was made, as JSON: of the plan, or of the segmentation while there is none.
std::string provenance(const CaseOutlook& files, const json& segment, const json& told)
{
  const std::string made = files.has("plan.json") ? "plan.json" : "segment.json";
  if (!files.has(made))
    return {};
  json methods = json::array();
  const json found = told.value("methods", json::object());
  for (const auto& method : found.items())
    methods.push_back(method.key());
  json versions = json::object(); // of the program that made it, which need not be this one
  for (const json& one :
       (told.contains("versions") ? told : segment).value("versions", json::array()))
    versions[one.at(0).get<std::string>()] = one.at(1);
  return json{{"date", date_of(files.file(made))},
              {"made", made},
              {"methods", methods},
              {"ct_nrrd_sha256", segment.value("ct_nrrd_sha256", "")},
              {"versions", versions}}
      .dump();
}

} // namespace

void read_results(const CaseOutlook& files, Plan* plan)
{
  MRMLNodeModifyBlocker blocker(plan);
  plan->RemoveMovements();
  plan->RemoveFigures("");
  std::vector<std::string> warnings, findings;
  const json segment = json_of(files, "segment.json"), mesh = json_of(files, "mesh.json"),
             told = json_of(files, "plan.json");
  plan->SetProvenance(provenance(files, segment, told));
  add_figures(segment, "segment", plan);
  add_figures(mesh, "mesh", plan);
  for (const char* key : {"timing_s", "reachability", "bite"})
    if (told.contains(key))
      add_figures(told[key], key, plan);
  add_sentences(segment.value("notes", json()), warnings);
  add_sentences(told.value("warnings", json()), warnings);
  for (int method = 0; method < Plan::Method_Last; ++method)
  {
    const std::string name = Plan::GetSelectedMethodAsString(method);
    const json found = told.value("methods", json::object()).value(name, json::object());
    read_movements(found, method, plan);
    for (const char* key : {"skin_error_mm", "load_residual_mm", "tissue_stretch"})
      if (found.contains(key))
        add_figures(found[key], name + "/" + key, plan);
  }
  if (told.contains("reachability") && told["reachability"].is_object())
    add_sentences(told["reachability"].value("sentences", json()), findings);
  plan->SetWarnings(warnings);
  plan->SetFindings(findings);
  plan->SetSuggestions(suggestion_lines(json_of(files, "suggest.json")));
}

void set_step_statuses(const CaseOutlook& files, Plan* plan)
{
  MRMLNodeModifyBlocker blocker(plan);
  for (int step = 0; step < Plan::Step_Last; ++step)
  {
    const std::string name = Plan::GetStepAsString(step);
    const bool done = files.has(step == Plan::Report ? "report.html" : name + ".json");
    plan->SetStepStatus(step, done ? Plan::Current : Plan::NotDone);
  }
}

} // namespace f2b
