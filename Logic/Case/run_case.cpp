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

void report(CaseSession& session)
{
  report_case(session, {});
}

/// Only here is it known how long everything took.
void tell_total_time(const Path& plan_file, double report_seconds, double total_seconds)
{
  nlohmann::json plan = read_json(plan_file);
  plan["timing_s"]["report"] = report_seconds;
  plan["timing_s"]["total"] = total_seconds;
  write_json(plan_file, plan);
}

} // namespace

void run_case(const nlohmann::json& document, const Path& source, const Path& folder,
              const Progress& progress, const CommitHook& hook)
{
  static const Step steps[] = {{segment_case, 0, 0.12}, {cut_case, 0.12, 0.15},
                               {mesh_case, 0.15, 0.3},  {target_case, 0.3, 0.4},
                               {plan_case, 0.4, 0.92},  {report, 0.92, 1}};
  const Stopwatch watch;
  const CaseSettings settings = parse_settings(document, source);
  require_cuts(settings);
  require_target(settings);
  require_inputs_elsewhere(settings, folder);
  CaseFolder destination(folder);
  destination.set_commit_hook(hook);
  destination.require_replaceable(case_file_names(), "segment");
  CaseChange change(destination);
  {
    CaseSession session(change.folder(), document, source);
    double before_last = 0;
    for (const Step& step : steps)
    {
      before_last = watch.seconds();
      session.progress = [&](std::string_view what, double fraction)
      { progress(what, step.begin + fraction * (step.end - step.begin)); };
      step.verb(session);
    }
    tell_total_time(change.folder() / "plan.json", watch.seconds() - before_last, watch.seconds());
  }
  change.commit("segment");
}

} // namespace f2b
