#include "Core/models/face_models.hpp"

#include "Core/mesh/split_prisms.hpp"

#include <cassert>
#include <chrono>

namespace f2b
{
namespace
{

constexpr std::pair<FaceModelKind, const char*> names[] = {{FaceModelKind::Lfem, "lfem"},
                                                           {FaceModelKind::Mtm, "mtm"},
                                                           {FaceModelKind::Nfem, "nfem"},
                                                           {FaceModelKind::NfmEm, "nfm-em"}};

/// Seconds since it was last asked.
class LapTimer
{
public:
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - m_begin).count();
    m_begin = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

MaterialSet linearized(const MaterialSet& materials)
{
  MaterialSet linear{materials.name, {}};
  for (std::size_t t = 0; t < linear.laws.size(); ++t)
    linear.laws[t] =
        LinearElastic{shear_modulus(materials.laws[t]), bulk_modulus(materials.laws[t])};
  return linear;
}

/// Rest plus the movement of the fragments, for all control vectors.
std::vector<Vec3> target_of(const Discretization& tissue, const std::vector<Vec3>& displacement)
{
  std::vector<Vec3> target = tissue.rest();
  for (std::size_t n = 0; n < displacement.size(); ++n)
    target[n] += displacement[n];
  return target;
}

/// The node positions of linear elasticity: the forces that the movement puts on the free nodes
/// where they rest, and one solve with the stiffness there, which is the same everywhere.
std::vector<Vec3> solve_linear(const Discretization& tissue, const ForwardProblem& problem,
                               FaceModelResult& result, LapTimer& timer)
{
  const MaterialSet laws = linearized(problem.materials);
  ElasticModel model(tissue, laws, tissue.control_flags(held_nodes(problem.mesh)));
  std::vector<Vec3> x = tissue.rest();
  (void)model.linearize(x);
  result.setup_seconds = timer.lap();
  const std::vector<Vec3> u = fragment_displacements(problem);
  Cholesky cholesky;
  Eigen::MatrixXd motion = -model.coupling(u);
  if (motion.size() > 0)
  {
    cholesky.analyze(model.stiffness());
    // held somewhere and of positive moduli, a linear stiffness is positive definite
    [[maybe_unused]] const bool definite = cholesky.factorize(model.stiffness());
    assert(definite);
    motion = cholesky.solve(motion);
  }
  const auto& unknown = model.unknown_controls();
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] += u[n];
  for (std::size_t i = 0; i < unknown.size(); ++i)
    x[static_cast<std::size_t>(unknown[i])] +=
        motion.col(0).segment<3>(3 * static_cast<Eigen::Index>(i));
  result.equilibrium.load_steps = result.equilibrium.newton_iterations =
      result.equilibrium.factorizations = 1;
  result.equilibrium.load_reached = 1;
  return x;
}

std::vector<Vec3> relax_tensors(const MixedMesh& tets, const ForwardProblem& problem,
                                const FaceModelOptions& options, const Progress& progress,
                                FaceModelResult& result, LapTimer& timer)
{
  const MassTensors tensors(tets, problem.materials);
  std::vector<Vec3> x = fragment_displacements(problem);
  result.setup_seconds = timer.lap();
  result.relaxation = relax(tensors, x, held_nodes(tets), options.relaxation, progress);
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] += tets.X[n];
  return x;
}

std::vector<Vec3> solve_nonlinear(const Discretization& tissue, const ForwardProblem& problem,
                                  const FaceModelOptions& options, const Progress& progress,
                                  FaceModelResult& result, LapTimer& timer)
{
  ElasticModel model(tissue, problem.materials, tissue.control_flags(held_nodes(problem.mesh)));
  EquilibriumSolver solver(model, options.equilibrium);
  solver.set_progress([&](double share) { progress("predicting the face", share); });
  result.setup_seconds = timer.lap();
  std::vector<Vec3> x = tissue.rest();
  result.equilibrium = solver.move_to(x, target_of(tissue, fragment_displacements(problem)));
  return x;
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
  LapTimer timer;
  FaceModelResult result;
  if (model == FaceModelKind::NfmEm)
  {
    const Discretization tissue(problem.mesh, {SkinElement::Smooth, Dilatation::Averaged});
    result.x = solve_nonlinear(tissue, problem, options, progress, result, timer);
    result.skin_displacement = SkinInterpolation(tissue, skin).displacement(result.x);
    result.x.resize(problem.mesh.X.size());
  }
  else
  {
    const MixedMesh tets = split_prisms(problem.mesh);
    const ForwardProblem on_tets = {tets, problem.materials, problem.motions};
    const Discretization tissue(tets);
    result.x = model == FaceModelKind::Mtm
                   ? relax_tensors(tets, on_tets, options, progress, result, timer)
               : model == FaceModelKind::Lfem
                   ? solve_linear(tissue, on_tets, result, timer)
                   : solve_nonlinear(tissue, on_tets, options, progress, result, timer);
    // the nodes are the same, so the prisms' faces carry the reference skin
    result.skin_displacement =
        SkinInterpolation(Discretization(problem.mesh), skin).displacement(result.x);
  }
  result.solve_seconds = timer.lap();
  return result;
}

} // namespace f2b
