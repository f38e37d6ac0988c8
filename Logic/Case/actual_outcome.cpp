#include "Case/actual_outcome.hpp"

#include "Bridge/scan_surface.hpp"
#include "Case/postoperative.hpp"
#include "Case/virtual_truth.hpp"
#include "Core/geometry/noise_field.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Meshing/isosurface.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

std::vector<Vec3> sum_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  std::vector<Vec3> sum = a;
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] += b[v];
  return sum;
}

/// A weight of one wherever something is known.
std::vector<double> weight_where(const std::vector<double>& area)
{
  std::vector<double> weight;
  for (const double a : area)
    weight.push_back(a > 0 ? 1 : 0);
  return weight;
}

} // namespace

std::vector<double> distances_to_target(const MeshedFace& face, const std::vector<Vec3>& u,
                                        const std::vector<Vec3>& target)
{
  const std::vector<Vec3>& rest = face.reference_skin.points;
  TriangleMesh wanted{sum_of(rest, target), face.reference_skin.triangles};
  return signed_distances(sum_of(rest, u), wanted.points, vertex_normals(wanted));
}

ActualOutcome virtual_outcome(const CaseSession& session, const LoadedFace& face,
                              const std::vector<RigidMotion>& motions,
                              const EvaluateOptions& options)
{
  const TruthOptions differences;
  session.progress("meshing the virtual patient", 0);
  const TruthMesh truth(session, differences, no_progress);
  const MaterialSet materials = truth_materials(face.materials, differences);
  const FaceModel model = truth.model(materials, face);
  EquilibriumOptions equilibrium = equilibrium_options(session.settings);
  equilibrium.step_tolerance_mm = std::max(equilibrium.step_tolerance_mm, 1e-5);
  const Prediction outcome = predict_face(model, motions, equilibrium, session.progress);
  require_converged(outcome.summary, "the virtual patient", {});

  ActualOutcome actual;
  actual.motions = motions;
  actual.area = model.skin_area;
  const NoiseOptions noise{options.noise_sd_mm, options.noise_correlation_mm, options.seed};
  actual.skin.displacement =
      sum_of(outcome.skin_displacement, correlated_noise(face.reference_skin.points, noise));
  actual.skin.weight = weight_where(actual.area);
  actual.distances = [&face, measured = actual.skin.displacement](const std::vector<Vec3>& u)
  { return distances_to_target(face, u, measured); };
  actual.exact_distances = [&face, exact = outcome.skin_displacement](const std::vector<Vec3>& u)
  { return distances_to_target(face, u, exact); };
  actual.document = {{"kind", "virtual patient"},
                     {"correspondence", "same vertices of the reference skin"},
                     {"differs_from_plan", mismatch_json(differences, truth, face, materials)},
                     {"skin_noise",
                      {{"sd_mm_per_component", noise.sd_mm},
                       {"correlation_length_mm", noise.correlation_mm},
                       {"seed", noise.seed}}},
                     {"solve", to_json(outcome.summary)}};
  return actual;
}

ActualOutcome postoperative_outcome(const CaseSession& session, const LoadedFace& face,
                                    const EvaluateOptions& options)
{
  const auto findings = std::make_shared<const PostoperativeFindings>(postoperative_findings(
      session, options.postoperative_ct, {options.box_ras, options.mask, {}}));
  ActualOutcome actual;
  for (const FragmentMovement& movement : findings->movements)
    actual.motions.push_back(movement.fit.motion);
  const std::vector<Vec3>& rest = face.reference_skin.points;
  const auto scan = std::make_shared<const ScanSurface>(watertight_isosurface(findings->skin));
  constexpr double reach_mm = 30;
  actual.skin = target_on_scan(scan, rest, vertex_normals(face.reference_skin), reach_mm);
  actual.skin.registration_sd_mm = 0.3; // as a scan's
  actual.area = face.skin_area;
  for (std::size_t v = 0; v < actual.area.size(); ++v)
    if (actual.skin.weight[v] <= 0)
      actual.area[v] = 0;
  actual.distances = [findings, &rest](const std::vector<Vec3>& u)
  {
    std::vector<double> distance;
    for (std::size_t v = 0; v < u.size(); ++v)
      distance.push_back(findings->skin.value(rest[v] + u[v]));
    return distance;
  };
  actual.document = {{"kind", "post-operative CT"},
                     {"correspondence", "nearest point of the post-operative skin: a lower bound"},
                     {"findings", findings->document}};
  return actual;
}

} // namespace f2b
