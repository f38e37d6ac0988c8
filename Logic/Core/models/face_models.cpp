#include "Core/models/face_models.hpp"

#include "Core/error.hpp"
#include "Core/inverse/face_model.hpp"
#include "Core/mesh/split_prisms.hpp"

namespace f2b
{
namespace
{

constexpr std::pair<FaceModelKind, const char*> names[] = {{FaceModelKind::Lfem, "lfem"},
                                                           {FaceModelKind::Mtm, "mtm"},
                                                           {FaceModelKind::Nfem, "nfem"},
                                                           {FaceModelKind::NfmEm, "nfm-em"}};

MaterialSet linearized(const MaterialSet& materials)
{
  MaterialSet linear{materials.name, {}};
  for (std::size_t t = 0; t < linear.laws.size(); ++t)
    linear.laws[t] =
        LinearElastic{shear_modulus(materials.laws[t]), bulk_modulus(materials.laws[t])};
  return linear;
}

/// A stiffness that is the same everywhere: one factorisation, one solve with the forces that the
/// movement puts on the unknowns where they rest.
Eigen::VectorXd solve_once(ElasticModel& model, const std::vector<Vec3>& rest,
                           const std::vector<Vec3>& movement, SolveEffort& effort)
{
  {
    const TimedPart timed(effort.assembly);
    (void)model.linearize(rest);
    effort.linearizations = 1;
  }
  const Eigen::VectorXd load = -model.coupling(movement);
  if (load.size() == 0)
    return load;
  Cholesky cholesky;
  {
    const TimedPart timed(effort.analysis);
    cholesky.analyze(model.stiffness(), 3);
    effort.analyses = 1;
  }
  {
    const TimedPart timed(effort.factorization);
    if (!cholesky.factorize(model.stiffness()))
      throw Error("model lfem", "the linear stiffness is not positive definite",
                  "mesh at another density, or hold more of the tissue", ErrorKind::Numerical);
    effort.factorizations = 1;
    effort.factorization_flops = cholesky.flops();
    effort.factor_peak_bytes = cholesky.peak_bytes();
  }
  const TimedPart timed(effort.back_solving);
  effort.back_solves = 1;
  return cholesky.solve(load);
}

std::vector<Vec3> solve_linear(const Discretization& tissue, const ForwardProblem& problem,
                               FaceModelResult& result)
{
  const MaterialSet laws = linearized(problem.materials);
  ElasticModel model(tissue, laws, held_controls(tissue, Held::BoneAndFragments));
  EquilibriumSummary& summary = result.equilibrium;
  const TimedPart timed(summary.effort.total);
  const std::vector<Vec3> movement = fragment_displacements(problem);
  const Eigen::VectorXd motion = solve_once(model, tissue.rest(), movement, summary.effort);
  std::vector<Vec3> x = tissue.rest();
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] += movement[n];
  const auto& unknown = model.unknown_controls();
  for (std::size_t i = 0; i < unknown.size(); ++i)
    x[static_cast<std::size_t>(unknown[i])] += motion.segment<3>(3 * static_cast<Eigen::Index>(i));
  summary.load_steps = summary.newton_iterations = 1;
  summary.load_reached = 1;
  return x;
}

std::vector<Vec3> relax_tensors(const MixedMesh& tets, const ForwardProblem& problem,
                                const RelaxationOptions& options, const Progress& progress,
                                FaceModelResult& result)
{
  SolveEffort& effort = result.equilibrium.effort;
  const TimedPart timed(effort.total);
  std::optional<MassTensors> tensors;
  {
    const TimedPart timed_assembly(effort.assembly);
    tensors.emplace(tets, problem.materials);
  }
  std::vector<Vec3> x = fragment_displacements(problem);
  result.relaxation =
      relax(*tensors, x, held_nodes(tets, Held::BoneAndFragments), options, progress);
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] += tets.X[n];
  return x;
}

std::vector<Vec3> solve_nonlinear(const Discretization& tissue, const SkinInterpolation& skin,
                                  const ForwardProblem& problem, const EquilibriumOptions& options,
                                  const Progress& progress, FaceModelResult& result)
{
  Prediction prediction =
      predict_face({tissue, problem.materials, skin, {}, {}}, problem.motions, options, progress);
  result.equilibrium = prediction.summary;
  result.skin_displacement = std::move(prediction.skin_displacement);
  result.stability = examine_stability(tissue, problem.materials, prediction.x);
  return std::move(prediction.x);
}

} // namespace

const char* name_of(FaceModelKind model)
{
  for (const auto& [kind, name] : names)
    if (kind == model)
      return name;
  return "";
}

std::optional<FaceModelKind> face_model_named(std::string_view name)
{
  for (const auto& [kind, known] : names)
    if (name == known)
      return kind;
  return std::nullopt;
}

FaceModelResult predict_with(FaceModelKind model, const ForwardProblem& problem,
                             const SkinMap& skin, const FaceModelOptions& options,
                             const Progress& progress)
{
  progress("predicting the face", 0);
  FaceModelResult result;
  if (model == FaceModelKind::NfmEm)
  {
    const Discretization tissue(problem.mesh, mixed_elements);
    result.x = solve_nonlinear(tissue, SkinInterpolation(tissue, skin), problem,
                               options.equilibrium, progress, result);
    result.x.resize(problem.mesh.X.size());
    return result;
  }
  const MixedMesh tets = split_prisms(problem.mesh);
  const ForwardProblem on_tets = {tets, problem.materials, problem.motions};
  const Discretization tissue(tets);
  // the nodes are the same, so the prisms' faces carry the reference skin
  const SkinInterpolation interpolation(Discretization(problem.mesh), skin);
  if (model == FaceModelKind::Nfem)
  {
    result.x =
        solve_nonlinear(tissue, interpolation, on_tets, options.equilibrium, progress, result);
    return result;
  }
  result.x = model == FaceModelKind::Mtm
                 ? relax_tensors(tets, on_tets, options.relaxation, progress, result)
                 : solve_linear(tissue, on_tets, result);
  result.skin_displacement = interpolation.displacement(result.x);
  return result;
}

} // namespace f2b
