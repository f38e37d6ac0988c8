#include "Scene/plan_step.hpp"

#include "Core/error.hpp"
#include "Scene/input_files.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>

namespace f2b
{
namespace
{

using PlanNode = vtkMRMLFaceToBonePlanNode;

bool begins_case(int step)
{
  return step == PlanNode::Segment || step == run_step;
}

void segment_new(const StepRequest& request, const Progress& progress, const CommitHook& hook)
{
  require_inputs_elsewhere(parse_settings(request.document, request.source), request.folder);
  CaseSession session(request.folder, request.document, request.source, progress);
  session.folder.set_commit_hook(hook);
  segment_case(session);
}

void do_verb(CaseSession& session, const StepRequest& request)
{
  switch (request.step)
  {
  case PlanNode::Cut:
    return cut_case(session);
  case PlanNode::Mesh:
    return mesh_case(session);
  case PlanNode::Target:
    return target_case(session);
  case PlanNode::Suggest:
    return suggest_case(session, request.suggest);
  case PlanNode::Plan:
    return plan_case(session);
  case PlanNode::Predict:
    return predict_case(session);
  case PlanNode::Report:
    return report_case(session, request.report);
  case export_step:
    return export_case(session, request.exported);
  default:
    throw Error("step " + std::to_string(request.step), "there is no such step",
                "use one of vtkMRMLFaceToBonePlanNode");
  }
}

/// Whether a step reads the target that the edits have changed, and does not make it itself.
bool needs_new_target(const StepRequest& request)
{
  return request.edits && request.edits->has_target() &&
         (request.step == PlanNode::Suggest || request.step == PlanNode::Plan);
}

/// Whether a step reads the cut bone that the edits have changed.
bool needs_new_cut(const StepRequest& request)
{
  return request.edits && request.edits->has_cuts() &&
         (request.step == PlanNode::Mesh || request.step == PlanNode::Plan ||
          request.step == PlanNode::Predict);
}

} // namespace

StepRequest prepare_step(const CaseNodes& nodes, int step, const SettingsOrigin& origin)
{
  StepRequest request;
  request.step = step;
  request.folder = nodes.plan->GetCaseFolder();
  if (request.folder.empty())
    throw Error("the case folder", "it cannot be made without a name", "choose a folder");
  if (!begins_case(step) && !std::filesystem::is_directory(request.folder))
    throw Error(request.folder.string(), "there is no such case folder",
                "choose the folder where the case lies, or find skin and bone anew in this one");
  request.source = origin.name;
  request.suggest.confirm = nodes.plan->GetSuggestConfirm();
  if (nodes.plan->GetSuggestDensity() > 0)
    request.suggest.density = nodes.plan->GetSuggestDensity();
  request.report = {nodes.plan->GetReportTextsFileName(), nodes.plan->GetReportIdentity()};
  request.edits = std::make_shared<NodeEdits>();
  if (begins_case(step))
    write_input_nodes(nodes, request.folder);
  else
  {
    request.edits->collect_landmarks(request.folder, nodes);
    request.edits->collect_cuts(request.folder, nodes);
    request.edits->collect_target(request.folder, nodes);
    write_warp_nodes(nodes, request.folder);
  }
  request.document = settings_from_nodes(nodes);
  drop_empty_target(request.document);
  parse_settings(request.document, origin.name); // whether it is valid, in words
  request.document = with_absolute_paths(request.document, origin.file);
  return request;
}

void compute_step(const StepRequest& request, const Progress& progress, const CommitHook& hook)
{
  if (request.step == run_step)
    return run_case(request.document, request.source, request.folder, progress, hook);
  if (request.step == PlanNode::Segment)
    return segment_new(request, progress, hook);
  CaseSession session = CaseSession::open(request.folder, progress);
  const bool changed = !same_settings(session.document, request.document);
  if (changed)
    session.change_settings(request.document, request.source);
  session.folder.set_commit_hook(
      [&](const CaseOutlook& files)
      {
        // most steps leave the settings as they found them; an exported deck states its own
        if (changed && request.step != export_step)
          session.write_settings(files.staging);
        if (hook)
          hook(files);
      });
  if (request.edits)
    request.edits->apply(session);
  if (needs_new_cut(request))
    throw Error(request.folder.string(), "its cuts were moved since the bone was cut",
                "cut and mesh anew first");
  if (needs_new_target(request))
    target_case(session);
  do_verb(session, request);
}

} // namespace f2b
