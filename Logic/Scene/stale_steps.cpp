#include "Scene/stale_steps.hpp"

#include "Bridge/json_file.hpp"
#include "Case/case_settings.hpp"
#include "Scene/plan_results.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>

#include <nlohmann/json.hpp>

namespace f2b
{
namespace
{

using nlohmann::json;
using Plan = vtkMRMLFaceToBonePlanNode;

/// What a step itself reads of the settings.
json settings_of_step(int step, const json& document)
{
  auto parts = [&](std::initializer_list<const char*> keys)
  {
    json read = json::object();
    for (const char* key : keys)
      if (document.contains(key))
        read[key] = document[key];
    return read;
  };
  json osteotomies = document.value("osteotomies", json::array());
  json movements = json::array();
  for (json& entry : osteotomies)
  {
    movements.push_back(entry.value("movement", json()));
    entry.erase("movement");
    entry.erase("fragment"); // a name that the cut gave is no other cut
  }
  switch (step)
  {
  case Plan::Segment:
    return parts(
        {"ct", "series", "grey_values", "landmarks", "thresholds", "region_ras", "segmentation"});
  case Plan::Cut:
    return {osteotomies, parts({"protected"})};
  case Plan::Mesh:
    return parts({"mesh", "skin_thickness_mm", "skin_thickness_by_region_mm"});
  case Plan::Target:
    return parts({"target"});
  case Plan::Plan:
    return {parts({"materials", "solver"}), movements};
  case Plan::Predict:
    return parts({"materials", "solver", "predict"});
  default:
    return {};
  }
}

/// The steps that rest on a step, in the order of the enumeration.
std::vector<int> resting_on(int step)
{
  switch (step)
  {
  case Plan::Segment:
    return {Plan::Cut,  Plan::Mesh,    Plan::Target, Plan::Suggest,
            Plan::Plan, Plan::Predict, Plan::Report};
  case Plan::Cut:
  case Plan::Mesh:
    return {Plan::Mesh, Plan::Plan, Plan::Predict, Plan::Report};
  case Plan::Target:
    return {Plan::Suggest, Plan::Plan, Plan::Predict, Plan::Report};
  case Plan::Plan:
    return {Plan::Predict, Plan::Report};
  case Plan::Predict:
    return {Plan::Report};
  default:
    return {};
  }
}

void mark(Plan* plan, int step)
{
  if (plan->GetStepStatus(step) == Plan::Current)
    plan->SetStepStatus(step, Plan::Stale);
}

} // namespace

void mark_stale_steps(const CaseOutlook& files, const CaseNodes& nodes)
{
  MRMLNodeModifyBlocker blocker(nodes.plan);
  set_step_statuses(files, nodes.plan);
  if (!files.has(case_settings_name))
    return;
  // paths relative or not are the same files
  const Path source = files.folder / case_settings_name;
  const json now = with_absolute_paths(settings_from_nodes(nodes), source),
             then = with_absolute_paths(
                 canonical_settings(read_json(files.file(case_settings_name))), source);
  for (int step = 0; step < Plan::Step_Last; ++step)
    if (settings_of_step(step, now) != settings_of_step(step, then))
    {
      mark(nodes.plan, step);
      for (const int later : resting_on(step))
        mark(nodes.plan, later);
    }
}

} // namespace f2b
