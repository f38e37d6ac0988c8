#include "Case/evaluation.hpp"

#include "Bridge/json_file.hpp"
#include "Case/evaluation_tables.hpp"
#include "Case/face_regions.hpp"
#include "Case/movement_rules.hpp"
#include "Case/virtual_force_case.hpp"
#include "Core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace f2b
{
namespace
{

using nlohmann::json;

/// The paper's Table 2, of the first fragment.
std::vector<RigidMotion> table_2_motions(const LoadedFace& face)
{
  constexpr double degree = 3.14159265358979323846 / 180;
  std::vector<RigidMotion> motions = rest_motions(face.model());
  motions.front().translation = {2, 11, -5};
  motions.front().rotation = rotation_from({5 * degree, 2.5 * degree, 0});
  return motions;
}

ActualOutcome outcome_of(const Evaluation& e)
{
  const EvaluateOptions& options = e.options;
  if (!options.postoperative_ct.empty())
    return postoperative_outcome(e.session, e.face, options);
  const auto motions = options.movements.empty()
                           ? table_2_motions(e.face)
                           : stated_motions(options.movements, e.face, "--movement");
  return virtual_outcome(e.session, e.face, motions, options);
}

void write_text(const Path& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
}

bool asks_for(const EvaluateOptions& options, int experiment)
{
  return std::count(options.experiments.begin(), options.experiments.end(), experiment) > 0;
}

void require_sense(const EvaluateOptions& options)
{
  if (!options.postoperative_ct.empty() && !options.movements.empty())
    throw Error("evaluate", "both a post-operative CT and a movement are given",
                "give one: the CT tells how the bone moved");
  if (options.postoperative_ct.empty() && (options.box_ras || !options.mask.empty()))
    throw Error("evaluate", "a box or mask is given, but no post-operative CT to register by it",
                "give --postoperative CT too");
}

} // namespace

Evaluation::Evaluation(CaseSession& opened, const EvaluateOptions& asked)
    : session(opened), options(asked), face(opened), parts(skin_parts(opened.folder, face)),
      change(opened.folder)
{
}

RigidFitOptions Evaluation::fit_options() const
{
  RigidFitOptions fit;
  fit.max_iterations = session.settings.max_fit_iterations;
  fit.equilibrium = equilibrium_options(session.settings);
  return fit;
}

TwoPlans plan_by_both(const Evaluation& e, const SkinTarget& target)
{
  const FaceModel model = e.face.model();
  RigidFitResult fit = fit_fragments(model, target, e.fit_options(), e.session.progress);
  return {std::move(fit),
          drag_skin(model, target, virtual_force_options(e.session), e.session.progress)};
}

std::string text_of(const SkinError& error)
{
  char text[100];
  std::snprintf(text, sizeof text, "mean %.2f, variance %.2f, at most %.2f mm", error.mean,
                error.variance, error.max);
  return text;
}

vtkSmartPointer<vtkPolyData> skin_with_distance(const MeshedFace& face,
                                                const std::vector<Vec3>& displacement,
                                                std::vector<double> distance,
                                                const std::vector<double>& area)
{
  std::vector<Vec3> points = face.reference_skin.points;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] += displacement[v];
    if (area[v] <= 0)
      distance[v] = std::nan("");
  }
  auto surface = with_points(face.skin, points);
  add_point_array(surface, MapPanel::values, distance);
  return surface;
}

void evaluate_case(CaseSession& session, const EvaluateOptions& options)
{
  require_sense(options);
  const Stopwatch watch;
  Evaluation evaluation(session, options);
  std::filesystem::create_directories(evaluation.file("x").parent_path());
  json told = {{"schema", "facetobone-evaluation/1"},
               {"name", session.settings.name},
               {"frame", "scanner RAS"},
               {"disclaimer", "research software, not a medical device"}};
  if (asks_for(options, 1) || asks_for(options, 2))
  {
    const ActualOutcome actual = outcome_of(evaluation);
    told["actual"] = actual.document;
    std::vector<Vec3> mixed_face;
    told["experiment1"] = compare_models(evaluation, actual, mixed_face);
    if (asks_for(options, 2))
      told["experiment2"] = compare_bones(evaluation, actual, mixed_face);
  }
  if (asks_for(options, 3))
    told["experiment3"] = reach_targets(evaluation);
  told["seconds"] = watch.seconds();
  write_json(evaluation.file("evaluation.json"), told);
  write_text(evaluation.file("evaluation.md"), evaluation_text(told));
  for (const auto& [name, table] : evaluation_tables(told))
    write_text(evaluation.file(name + ".csv"), to_csv(table));
  evaluation.change.commit("evaluate");
  session.progress("evaluated", 1);
}

} // namespace f2b
