#include "Core/solve/equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

void EquilibriumSummary::add(const EquilibriumSummary& other)
{
  termination = other.termination;
  load_steps += other.load_steps;
  newton_iterations += other.newton_iterations;
  factorizations += other.factorizations;
  load_reached = other.load_reached;
  last_step_mm = other.last_step_mm;
  steps_mm.insert(steps_mm.end(), other.steps_mm.begin(), other.steps_mm.end());
}

EquilibriumSolver::EquilibriumSolver(ElasticModel& model, EquilibriumOptions options)
    : m_model(model), m_options(options)
{
}

std::vector<Vec3> EquilibriumSolver::moved(const std::vector<Vec3>& x, const Eigen::VectorXd& step,
                                           double scale) const
{
  std::vector<Vec3> result = x;
  const auto& nodes = m_model.unknown_controls();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result[static_cast<std::size_t>(nodes[i])] +=
        scale * step.segment<3>(3 * static_cast<Eigen::Index>(i));
  return result;
}

/// Factorises the current stiffness, adding to its diagonal while it is not positive definite.
void EquilibriumSolver::factorize(EquilibriumSummary& summary)
{
  if (!m_analyzed)
    m_cholesky.analyze(m_model.stiffness());
  m_analyzed = true;
  ++summary.factorizations;
  if (m_cholesky.factorize(m_model.stiffness()))
    return;
  SymmetricMatrix shifted = m_model.stiffness();
  auto diagonal = [&](long c) -> double&
  {
    return shifted
        .value[static_cast<std::size_t>(shifted.column_start[static_cast<std::size_t>(c)])];
  };
  double largest = 0;
  for (long c = 0; c < shifted.size; ++c)
    largest = std::max(largest, std::abs(diagonal(c)));
  double added = 0;
  for (double shift = std::max(1e-4 * largest, 0.2 * m_shift);; shift *= 5)
  {
    for (long c = 0; c < shifted.size; ++c)
      diagonal(c) += shift - added;
    added = shift;
    ++summary.factorizations;
    if (m_cholesky.factorize(shifted))
      break;
  }
  m_shift = added;
}

/// Takes the longest of the steps 1, 1/2, 1/4, ... that is admissible.
bool EquilibriumSolver::line_search(std::vector<Vec3>& x, const Eigen::VectorXd& forces,
                                    const Eigen::VectorXd& step)
{
  const double energy = m_model.energy(x);
  const double slope = forces.dot(step);
  // below this, a difference of two energies is rounding
  const double noise = 1e-13 * std::abs(energy) + 1e-300;
  for (double scale = 1; scale > 1e-4; scale /= 2)
  {
    std::vector<Vec3> trial = moved(x, step, scale);
    const double trial_energy = m_model.energy(trial);
    if (trial_energy <= energy + 1e-4 * scale * slope + noise)
    {
      x = std::move(trial);
      return true;
    }
  }
  return false;
}

bool EquilibriumSolver::newton(std::vector<Vec3>& x, EquilibriumSummary& summary)
{
  m_factor_is_current = false;
  for (int iteration = 0; iteration < m_options.max_newton_iterations; ++iteration)
  {
    const Eigen::VectorXd forces = m_model.linearize(x);
    const Eigen::VectorXd step = newton_step(forces, summary);
    ++summary.newton_iterations;
    summary.last_step_mm = step.size() ? step.lpNorm<Eigen::Infinity>() : 0;
    summary.steps_mm.push_back(summary.last_step_mm);
    if (!std::isfinite(summary.last_step_mm))
      return false;
    if (summary.last_step_mm < m_options.step_tolerance_mm)
    {
      x = moved(x, step, 1);
      m_factor_is_current = true;
      return true;
    }
    if (!line_search(x, forces, step))
      return false;
  }
  return false;
}

Eigen::VectorXd EquilibriumSolver::newton_step(const Eigen::VectorXd& forces,
                                               EquilibriumSummary& summary)
{
  if (forces.size() == 0)
    return forces;
  factorize(summary);
  return -m_cholesky.solve(forces);
}

/// First guess after a share of the way to the target, by the current tangent; the factor is
/// current.
std::vector<Vec3> EquilibriumSolver::predict(const std::vector<Vec3>& x,
                                             const std::vector<Vec3>& target, double share)
{
  std::vector<Vec3> motion(x.size(), Vec3::Zero());
  for (std::size_t node = 0; node < x.size(); ++node)
    if (m_model.is_prescribed(static_cast<int>(node)))
      motion[node] = share * (target[node] - x[node]);
  std::vector<Vec3> result = x;
  const std::vector<Vec3> response = respond({motion}).front();
  for (std::size_t node = 0; node < x.size(); ++node)
    result[node] += m_model.is_prescribed(static_cast<int>(node)) ? motion[node] : response[node];
  return result;
}

EquilibriumSummary EquilibriumSolver::relax(std::vector<Vec3>& x)
{
  EquilibriumSummary summary;
  std::vector<Vec3> trial = x;
  if (newton(trial, summary))
  {
    x = std::move(trial);
    summary.load_reached = 1;
  }
  else
    summary.termination = Termination::LoadStepTooSmall;
  return summary;
}

EquilibriumSummary EquilibriumSolver::move_to(std::vector<Vec3>& x, const std::vector<Vec3>& target)
{
  EquilibriumSummary summary;
  if (!m_factor_is_current)
  {
    summary = relax(x);
    if (!summary.converged())
      return summary;
    summary.load_reached = 0;
  }
  double step = 1;
  while (summary.load_reached < 1)
  {
    if (m_progress)
      m_progress(summary.load_reached);
    step = std::min(step, 1 - summary.load_reached);
    // shares of what remains: the prescribed nodes are at `load_reached` of the way in x
    std::vector<Vec3> trial = predict(x, target, step / (1 - summary.load_reached));
    const bool admissible = std::isfinite(m_model.energy(trial));
    if (admissible && newton(trial, summary))
    {
      x = std::move(trial);
      summary.load_reached = step >= 1 - summary.load_reached ? 1 : summary.load_reached + step;
      ++summary.load_steps;
      step *= 2;
      continue;
    }
    step /= 2;
    if (step < m_options.smallest_load_step ||
        summary.newton_iterations > m_options.max_total_iterations)
    {
      summary.termination = Termination::LoadStepTooSmall;
      return summary;
    }
    if (!m_factor_is_current)
    {
      m_model.linearize(x);
      factorize(summary);
      m_factor_is_current = true;
    }
  }
  return summary;
}

std::vector<std::vector<Vec3>>
EquilibriumSolver::respond(const std::vector<std::vector<Vec3>>& motions)
{
  Eigen::MatrixXd loads(m_model.unknown_count(), static_cast<Eigen::Index>(motions.size()));
  for (std::size_t m = 0; m < motions.size(); ++m)
    loads.col(static_cast<Eigen::Index>(m)) = -m_model.coupling(motions[m]);
  const Eigen::MatrixXd answers = loads.rows() ? m_cholesky.solve(loads) : loads;
  const auto& nodes = m_model.unknown_controls();
  std::vector<std::vector<Vec3>> responses;
  for (std::size_t m = 0; m < motions.size(); ++m)
  {
    std::vector<Vec3> response(motions[m].size(), Vec3::Zero());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      response[static_cast<std::size_t>(nodes[i])] =
          answers.col(static_cast<Eigen::Index>(m)).segment<3>(3 * static_cast<Eigen::Index>(i));
    responses.push_back(std::move(response));
  }
  return responses;
}

} // namespace f2b
