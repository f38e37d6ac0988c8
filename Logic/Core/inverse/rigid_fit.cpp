#include "Core/inverse/rigid_fit.hpp"

#include "Core/error.hpp"
#include "Core/inverse/skin_sensitivity.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

/// One run of the fit: the model with its fragments, and the current state.
class Fit
{
public:
  Fit(const FaceModel& face, const SkinTarget& target, const RigidFitOptions& options)
      : m_face(face), m_target(target), m_options(options),
        m_model(face.tissue, face.materials, held_controls(face.tissue, Held::BoneAndFragments)),
        m_solver(m_model, options.equilibrium), m_motions(rest_motions(face)),
        m_x(face.tissue.rest())
  {
    m_weight.resize(m_face.skin_area.size());
    for (std::size_t v = 0; v < m_weight.size(); ++v)
      m_weight[v] = face.skin.vertices[v].prism < 0 ? 0 : face.skin_area[v] * target.weight[v];
  }

  RigidFitResult run(const Progress& progress);

private:
  double objective(const std::vector<Vec3>& x) const;
  void normal_equations(Eigen::MatrixXd& H, Eigen::VectorXd& g);
  Eigen::VectorXd damped_step(const Eigen::MatrixXd& H, const Eigen::VectorXd& g) const;
  bool try_step(const Eigen::VectorXd& step);
  bool small(const RigidFitIteration& iteration) const
  {
    return iteration.translation_mm < m_options.translation_tolerance_mm &&
           iteration.rotation_rad < m_options.rotation_tolerance_rad;
  }
  RigidFitIteration measure(const Eigen::VectorXd& step) const;
  void require_sensitivity(const Eigen::MatrixXd& H) const;
  bool descend(const Eigen::MatrixXd& H, const Eigen::VectorXd& g);

  const FaceModel& m_face;
  const SkinTarget& m_target;
  const RigidFitOptions& m_options;
  ElasticModel m_model;
  EquilibriumSolver m_solver;
  std::vector<RigidMotion> m_motions;
  std::vector<Vec3> m_x;
  std::vector<double> m_weight; ///< area times target weight per reference-skin vertex
  double m_objective = 0;
  double m_damping = 0;
  RigidFitResult m_result;
};

double Fit::objective(const std::vector<Vec3>& x) const
{
  const std::vector<Vec3> u = m_face.skin.displacement(x);
  double sum = 0;
  for (std::size_t v = 0; v < u.size(); ++v)
    sum += 0.5 * m_weight[v] * (u[v] - m_target.displacement[v]).squaredNorm();
  return sum;
}

void Fit::normal_equations(Eigen::MatrixXd& H, Eigen::VectorXd& g)
{
  const auto columns = skin_sensitivity(m_face, m_solver, m_x, m_motions);
  const std::vector<Vec3> u = m_face.skin.displacement(m_x);
  const auto n = static_cast<Eigen::Index>(columns.size());
  H = Eigen::MatrixXd::Zero(n, n);
  g = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const auto& ci = columns[static_cast<std::size_t>(i)];
    for (std::size_t v = 0; v < u.size(); ++v)
      g[i] += m_weight[v] * ci[v].dot(u[v] - m_target.displacement[v]);
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const auto& cj = columns[static_cast<std::size_t>(j)];
      for (std::size_t v = 0; v < u.size(); ++v)
        H(i, j) += m_weight[v] * ci[v].dot(cj[v]);
      H(j, i) = H(i, j);
    }
  }
}

void Fit::require_sensitivity(const Eigen::MatrixXd& H) const
{
  double loaded = 0;
  for (const double w : m_weight)
    loaded += w;
  for (std::size_t f = 0; f < m_motions.size(); ++f)
  {
    const auto first = static_cast<Eigen::Index>(6 * f + 3);
    const double response = H.diagonal().segment(first, 3).maxCoeff();
    if (!(loaded > 0) || response < 1e-10 * loaded)
      throw Error("fragment '" + m_face.tissue.mesh().fragments[f] + "'",
                  "moving it does not move the skin of the target",
                  "give the fragment soft-tissue contact (smaller release margin, other cut), or "
                  "widen the target's mask");
  }
}

/// Marquardt's step: the diagonal of H scaled by the damping.
Eigen::VectorXd Fit::damped_step(const Eigen::MatrixXd& H, const Eigen::VectorXd& g) const
{
  Eigen::MatrixXd damped = H;
  damped.diagonal() *= 1 + m_damping;
  return -damped.ldlt().solve(g);
}

bool Fit::try_step(const Eigen::VectorXd& step)
{
  std::vector<RigidMotion> motions = m_motions;
  for (std::size_t f = 0; f < motions.size(); ++f)
  {
    const auto first = static_cast<Eigen::Index>(6 * f);
    motions[f] = motions[f].followed_by(step.segment<3>(first), step.segment<3>(first + 3));
  }
  std::vector<Vec3> x = m_x;
  const EquilibriumSummary solve =
      m_solver.move_to(x, with_fragments_moved(m_face.tissue, motions));
  m_result.equilibrium.add(solve);
  if (!solve.converged())
    return false;
  const double trial = objective(x);
  if (!(trial < m_objective))
    return false;
  m_objective = trial;
  m_motions = std::move(motions);
  m_x = std::move(x);
  return true;
}

RigidFitIteration Fit::measure(const Eigen::VectorXd& step) const
{
  RigidFitIteration iteration;
  iteration.objective = m_objective;
  for (Eigen::Index i = 0; i < step.size(); i += 6)
  {
    iteration.rotation_rad = std::max(iteration.rotation_rad, step.segment<3>(i).norm());
    iteration.translation_mm = std::max(iteration.translation_mm, step.segment<3>(i + 3).norm());
  }
  return iteration;
}

/// Tries steps of growing damping until one lowers the objective; false if none does.
bool Fit::descend(const Eigen::MatrixXd& H, const Eigen::VectorXd& g)
{
  for (int attempt = 0; attempt < 8; ++attempt)
  {
    const Eigen::VectorXd step = damped_step(H, g);
    m_result.iterations.push_back(measure(step));
    if (small(m_result.iterations.back()))
      return false;
    if (try_step(step))
    {
      m_damping = m_damping < 1e-6 ? 0 : m_damping / 10;
      return true;
    }
    m_damping = m_damping == 0 ? 1e-2 : m_damping * 10;
  }
  return false;
}

RigidFitResult Fit::run(const Progress& progress)
{
  m_objective = objective(m_x);
  m_result.equilibrium = m_solver.relax(m_x);
  m_result.termination = RigidFitTermination::MaxIterations;
  for (int i = 0; i < m_options.max_iterations; ++i)
  {
    progress("fitting the fragments", 1 - 1 / (1 + 0.5 * i));
    Eigen::MatrixXd H;
    Eigen::VectorXd g;
    normal_equations(H, g);
    if (i == 0)
      require_sensitivity(H);
    if (descend(H, g))
      continue;
    const bool converged = small(m_result.iterations.back());
    m_result.termination = converged ? RigidFitTermination::Converged
                           : i > 0   ? RigidFitTermination::NoFurtherDescent
                                     : RigidFitTermination::EquilibriumLost;
    break;
  }
  m_result.motions = m_motions;
  m_result.skin_displacement = m_face.skin.displacement(m_x);
  m_result.x = std::move(m_x);
  return std::move(m_result);
}

} // namespace

RigidFitResult fit_fragments(const FaceModel& face, const SkinTarget& target,
                             const RigidFitOptions& options, const Progress& progress)
{
  return Fit(face, target, options).run(progress);
}

} // namespace f2b
