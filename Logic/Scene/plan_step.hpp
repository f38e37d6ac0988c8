#pragma once

#include "Case/verbs.hpp"
#include "Scene/node_edits.hpp"
#include "Scene/scene_settings.hpp"

#include <memory>

/// How is one step of a plan done, away from the nodes?
namespace f2b
{

/// Steps beside those of vtkMRMLFaceToBonePlanNode.
enum ExtraStep
{
  run_step = 100,
  export_step = 101,
};

/// What a step needs to know; holds no node, so that any thread may do it.
struct StepRequest
{
  int step = 0; ///< of vtkMRMLFaceToBonePlanNode, or an ExtraStep
  Path folder;
  nlohmann::json document; ///< what the nodes ask for, paths absolute
  Path source;             ///< of the document
  SuggestOptions suggest;
  ExportOptions exported;
  ReportOptions report;
  std::shared_ptr<NodeEdits> edits;
};

/// Where the settings of nodes come from.
struct SettingsOrigin
{
  Path name; ///< for messages
  Path file; ///< relative paths start in its folder; may not exist
};

/// Reads settings and edits off the nodes, in the thread that owns the scene. Throws Error where
/// something is missing or wrong.
StepRequest prepare_step(const CaseNodes& nodes, int step, const SettingsOrigin& origin);

/// Does a step; throws as the verbs do.
void compute_step(const StepRequest& request, const Progress& progress, const CommitHook& hook);

} // namespace f2b
