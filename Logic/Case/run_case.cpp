#include "Case/verbs.hpp"

#include "Bridge/json_file.hpp"

namespace f2b
{
namespace
{

/// The part of the whole run that a step takes, for one bar over all of them.
struct Step
{
  void (*verb)(CaseSession&);
  double begin, end;
};

} // namespace

void run_case(const nlohmann::json& document, const Path& source, const Path& folder,
              const Progress& progress)
{
  static const Step steps[] = {{segment_case, 0, 0.12}, {cut_case, 0.12, 0.15}, {mesh_case, 0.15, 0.3},
                               {target_case, 0.3, 0.4}, {plan_case, 0.4, 0.92}, {report_case, 0.92, 1}};
  require_inputs_elsewhere(parse_settings(document, source), folder);
  CaseFolder destination(folder);
  destination.require_replaceable(case_file_names(), "segment");
  CaseChange change(destination);
  {
    CaseSession session(change.folder(), document, source);
    for (const Step& step : steps)
    {
      session.progress = [&](std::string_view what, double fraction)
      { progress(what, step.begin + fraction * (step.end - step.begin)); };
      step.verb(session);
    }
  }
  change.commit("segment");
}

} // namespace f2b
