// What does a plan cost, and the live preview of it?
//
//   plan_time CASE_FOLDER
//
// CASE_FOLDER is meshed. The target is the face that Table 2's movement gives the first fragment, and
// smaller ones the others. Prints JSON: rigid-fit from the mesh to the converged plan with its split
// and factorisations, virtual-force, and the live operator: preparation, one update, and how far its
// first-order plans are from full ones.

#include "Case/virtual_force_case.hpp"
#include "Core/inverse/live_operator.hpp"
#include "Verification/bone_error.hpp"
#include "Verification/meshed_case.hpp"

#include <ctime>

namespace f2b::verification
{
namespace
{

using nlohmann::json;

/// Table 2's of the first fragment, 3 mm for the others.
std::vector<RigidMotion> stated(const LoadedFace& face)
{
  std::vector<RigidMotion> motions = table_2_motions(face);
  for (std::size_t f = 1; f < motions.size(); ++f)
    motions[f].translation = {0, 3, f % 2 ? -1.0 : 0.5};
  return motions;
}

std::vector<Vec3> scaled(std::vector<Vec3> field, double factor)
{
  for (Vec3& v : field)
    v *= factor;
  return field;
}

json effort_json(const EquilibriumSummary& solve)
{
  return {{"split_s", time_split(solve.effort)},
          {"factorizations", solve.effort.factorizations},
          {"newton_iterations", solve.newton_iterations},
          {"cg_iterations", solve.effort.cg_iterations}};
}

/// The operator prepared at a plan, asked for targets some way off it.
json live_json(const FaceModel& model, const SkinTarget& target, const RigidFitResult& plan,
               const FragmentSurfaces& bones)
{
  const Stopwatch preparing;
  const LiveOperator live(model, {}, plan, no_progress);
  json told = {{"prepare_s", preparing.seconds()}};
  constexpr int updates = 20;
  const Stopwatch updating;
  for (int i = 0; i < updates; ++i)
    (void)live.update(scaled(target.displacement, 1 - 0.01 * i));
  told["update_ms"] = 1000 * updating.seconds() / updates;
  const auto displacement = scaled(target.displacement, 0.9);
  const LiveOperator::Answer answer = live.update(displacement);
  const RigidFitResult full =
      fit_fragments(model, {displacement, target.weight, {}}, {}, no_progress, &plan);
  told["a_tenth_off"] = {{"bone_from_full_plan_mm", bones.mean_mm(answer.motions, full.motions)},
                         {"doubt_mm", answer.doubt_mm}};
  return told;
}

json measured(const CaseSession& session)
{
  const Stopwatch loading;
  const LoadedFace face(session);
  const FaceModel model = face.model();
  const double load_s = loading.seconds();
  const std::vector<RigidMotion> truth = stated(face);
  const Prediction wanted =
      predict_face(model, truth, equilibrium_options(session.settings), no_progress);
  require_converged(wanted.summary, "target", {});
  const SkinTarget target{
      wanted.skin_displacement, std::vector<double>(wanted.skin_displacement.size(), 1.0), {}};
  const FragmentSurfaces bones(session.folder, face.mesh.fragments);

  const std::clock_t begin = std::clock();
  const Stopwatch fitting;
  const RigidFitResult plan = fit_fragments(model, target, {}, no_progress);
  json fit = effort_json(plan.equilibrium);
  fit.update({{"seconds", fitting.seconds()},
              {"processor_s", static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC},
              {"converged", plan.termination == RigidFitTermination::Converged},
              {"iterations", plan.iterations.size()},
              {"bone_error_mm", bones.mean_mm(plan.motions, truth)}});
  const Stopwatch dragging;
  const VirtualForceResult dragged =
      drag_skin(model, target, virtual_force_options(session), no_progress);
  json drag = effort_json(dragged.equilibrium);
  drag["seconds"] = dragging.seconds();
  return {{"prisms", face.mesh.prisms.size()},
          {"tets", face.mesh.tets.size()},
          {"fragments", face.mesh.fragments},
          {"load_s", load_s},
          {"rigid_fit", fit},
          {"virtual_force", drag},
          {"live", live_json(model, target, plan, bones)}};
}

} // namespace
} // namespace f2b::verification

int main(int argc, char** argv)
{
  return f2b::verification::print_of_case("plan_time", argc, argv, f2b::verification::measured);
}
