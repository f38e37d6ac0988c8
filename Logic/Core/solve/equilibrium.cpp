#include "Core/solve/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace f2b
{
namespace
{

/// Beyond it the tangent changes so much in one step that an exact one promises little.
constexpr double near_mm = 0.1;

double largest(const Eigen::MatrixXd& step)
{
  return step.size() ? step.lpNorm<Eigen::Infinity>() : 0;
}

double largest(const std::vector<Vec3>& motion)
{
  double length = 0;
  for (const Vec3& m : motion)
    length = std::max(length, m.lpNorm<Eigen::Infinity>());
  return length;
}

} // namespace

/// A state on its way to the target.
struct EquilibriumSolver::Walk
{
  std::vector<Vec3>& accepted; ///< the last equilibrium
  const std::vector<Vec3>& target;
  EquilibriumSummary& summary;
  int iterations_left;
  std::vector<Vec3> x = accepted;
  double remaining = 1;    ///< share of the load that x does not carry yet
  bool is_near = true;     ///< x is an equilibrium or close to one
  bool is_thrown = false;  ///< x is so far off that its exact tangent leads nowhere
  double last_step = 0;    ///< share of the whole load that the last step put on
  double longest_step = 1; ///< that a step may put on
  double told = 0;

  void accept()
  {
    accepted = x;
    summary.load_reached = 1 - remaining;
    longest_step *= 2;
  }
  /// Back to the last equilibrium, to leave it in half the step; false if that is too short.
  bool retreat(double shortest_step)
  {
    x = accepted;
    remaining = 1 - summary.load_reached;
    is_near = true;
    is_thrown = false;
    longest_step = last_step / 2;
    return longest_step > shortest_step;
  }
};

/// How boldly the load is put on.
struct EquilibriumSolver::Pace
{
  double least_volume_ratio; ///< of any quadrature point in one load step
  bool settles;              ///< an equilibrium is found after each load step
  int patience;              ///< Newton iterations in which x must come near an equilibrium
};

void EquilibriumSummary::add(const EquilibriumSummary& other)
{
  termination = other.termination;
  load_steps += other.load_steps;
  newton_iterations += other.newton_iterations;
  load_reached = other.load_reached;
  smallest_dilatation = other.smallest_dilatation;
  last_step_mm = other.last_step_mm;
  steps_mm.insert(steps_mm.end(), other.steps_mm.begin(), other.steps_mm.end());
  residuals_n.insert(residuals_n.end(), other.residuals_n.begin(), other.residuals_n.end());
  effort.add(other.effort);
}

EquilibriumSolver::EquilibriumSolver(ElasticModel& model, EquilibriumOptions options)
    : m_model(model), m_options(options), m_tangents(model)
{
}

std::vector<Vec3> EquilibriumSolver::moved(const std::vector<Vec3>& x, const Eigen::VectorXd& step,
                                           double scale) const
{
  std::vector<Vec3> result = x;
  const auto& controls = m_model.unknown_controls();
  for (std::size_t i = 0; i < controls.size(); ++i)
    result[static_cast<std::size_t>(controls[i])] +=
        scale * step.segment<3>(3 * static_cast<Eigen::Index>(i));
  return result;
}

/// A step with a share of the motion of what is prescribed.
std::vector<Vec3> EquilibriumSolver::stepped(const std::vector<Vec3>& x,
                                             const std::vector<Vec3>& motion,
                                             const Eigen::VectorXd& correction,
                                             const Eigen::VectorXd& response, double share) const
{
  std::vector<Vec3> result = moved(x, correction + share * response, 1);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] += share * motion[i];
  return result;
}

double EquilibriumSolver::energy(const std::vector<Vec3>& x)
{
  const TimedPart time(m_tangents.effort().energy);
  ++m_tangents.effort().energy_evaluations;
  return m_model.energy(x);
}

/// Whether no quadrature point shrinks below a share of its volume `before`, or grows as much.
bool EquilibriumSolver::keeps_volume(const std::vector<double>& before, const std::vector<Vec3>& x,
                                     double share)
{
  const TimedPart time(m_tangents.effort().energy);
  const std::vector<double> after = m_model.dilatations(x);
  for (std::size_t q = 0; q < after.size(); ++q)
    if (!(after[q] > share * before[q] && share * after[q] < before[q]))
      return false;
  return true;
}

/// Half of what is told is the load, half the digits of the final steps.
void EquilibriumSolver::tell(Walk& walk) const
{
  if (!m_progress)
    return;
  double digits = 0;
  if (walk.remaining == 0 && !walk.summary.steps_mm.empty())
    digits = std::log(std::clamp(walk.summary.last_step_mm, m_options.step_tolerance_mm, 1.0)) /
             std::log(std::min(0.5, m_options.step_tolerance_mm));
  walk.told = std::max(walk.told, 0.5 * (1 - walk.remaining) + 0.5 * digits);
  m_progress(walk.told);
}

/// Takes the longest of the steps 1, 1/2, 1/4, ... that lowers the energy enough and crushes
/// nothing. A step by the positive tangent is short where the exact one is indefinite, as in
/// buckling: then 2, 4 and 8 are tried as well, as long as the energy falls. Returns the share of
/// the step that was taken, 0 if there is none.
double EquilibriumSolver::line_search(Walk& walk, const Eigen::VectorXd& forces,
                                      const Eigen::VectorXd& step, bool extend)
{
  const double before = energy(walk.x);
  const double slope = forces.dot(step);
  const std::vector<double> volumes = m_model.dilatations(walk.x);
  // below this, a difference of two energies is rounding
  const double noise = 1e-12 * std::abs(before) + 1e-300;
  for (double scale = 1; scale > 1e-4; scale /= 2)
  {
    std::vector<Vec3> trial = moved(walk.x, step, scale);
    double reached = energy(trial);
    if (!(reached <= before + 1e-4 * scale * slope + noise && keeps_volume(volumes, trial, 0.1)))
      continue;
    double taken = scale;
    for (double longer = 2; extend && scale == 1 && longer <= 8; longer *= 2)
    {
      std::vector<Vec3> farther = moved(walk.x, step, longer);
      const double there = energy(farther);
      if (!(there < reached - noise && keeps_volume(volumes, farther, 0.1)))
        break;
      trial = std::move(farther);
      reached = there;
      taken = longer;
    }
    walk.x = std::move(trial);
    return taken;
  }
  return 0;
}

/// By the exact tangent as far as it can be trusted: thrown far off, the state has elements that are
/// about to be put right, and the positive tangent leads there better.
std::optional<Eigen::MatrixXd>
EquilibriumSolver::exact_step(const Walk& walk, const Eigen::VectorXd& load, double forcing)
{
  if (walk.is_thrown)
    return std::nullopt;
  if (!walk.is_near)
    return m_tangents.solve_by_old_factor(load, forcing);
  const double left = m_options.step_tolerance_mm / std::min(walk.summary.last_step_mm, near_mm);
  return m_tangents.solve(load, forcing, left);
}

/// Nothing if no step lowers the energy.
std::optional<EquilibriumSolver::Step> EquilibriumSolver::newton_iteration(Walk& walk,
                                                                           double forcing)
{
  tell(walk);
  const Eigen::VectorXd forces =
      m_tangents.linearize(walk.x, walk.is_thrown ? Tangent::Positive : Tangent::Exact);
  const auto exact = exact_step(walk, -forces, forcing);
  Eigen::VectorXd step = exact ? *exact : m_tangents.solve_positive(-forces);
  const double length = largest(step);
  EquilibriumSummary& summary = walk.summary;
  ++summary.newton_iterations;
  --walk.iterations_left;
  summary.last_step_mm = length;
  summary.steps_mm.push_back(length);
  summary.residuals_n.push_back(forces.norm());
  if (!std::isfinite(length))
    return std::nullopt;
  if (length < m_options.step_tolerance_mm)
  {
    walk.x = moved(walk.x, step, 1);
    return Step{length, true};
  }
  const double share = line_search(walk, forces, step, !exact);
  walk.is_thrown = !exact && share < 1;
  if (share > 0)
    return Step{length, exact && share == 1};
  if (!exact)
    return std::nullopt;
  step = m_tangents.solve_positive(-forces);
  if (line_search(walk, forces, step, true) > 0)
    return Step{std::max(largest(step), near_mm), false};
  return std::nullopt;
}

/// Steps until what is left to go is below the tolerance. A whole step by the exact tangent leaves
/// what its linear solve left and what the tangent has changed over it, which grows with the square
/// of the step; how fast, the step before it has shown.
bool EquilibriumSolver::newton(Walk& walk, double tolerance_mm, int patience)
{
  double length = walk.is_thrown ? 1 : near_mm; // of the last step
  double left_by_solve = 0;                     // of the last step, if it was whole
  bool was_whole = false;
  for (int i = 0; i < m_options.max_newton_iterations && walk.iterations_left > 0; ++i)
  {
    if (!walk.is_near && i >= patience)
      return false;
    // as tight as quadratic convergence asks for, but no tighter than the tolerance, and loose far
    // from equilibrium, where a step is a direction only
    const double forcing =
        std::clamp(std::max(0.2 * length, 0.1 * tolerance_mm / (length * length)), 1e-9, 0.2);
    const std::optional<Step> step = newton_iteration(walk, forcing);
    if (!step)
      return false;
    double change = 10; // of the tangent [1/mm]
    if (was_whole)
      change = std::max(change, 3 * (step->length_mm - left_by_solve) / (length * length));
    length = step->length_mm;
    was_whole = step->is_whole;
    left_by_solve = forcing * length;
    walk.is_near = length < near_mm;
    if (walk.is_near && was_whole && left_by_solve + change * length * length < tolerance_mm)
      return true;
  }
  return false;
}

/// How the unknowns follow the whole remaining motion, and the step to equilibrium; without it in an
/// equilibrium.
Eigen::MatrixXd EquilibriumSolver::load_directions(Walk& walk, const std::vector<Vec3>& motion)
{
  constexpr double tolerance = 0.02; // Newton's method comes after it
  Eigen::MatrixXd loads(m_model.unknown_count(), walk.x == walk.accepted ? 1 : 2);
  const Tangent tangent = walk.is_near ? Tangent::Exact : Tangent::Positive;
  loads.rightCols<1>() = -m_tangents.linearize(walk.x, tangent);
  if (walk.is_near)
  {
    loads.col(0) = -m_tangents.coupling(motion, Tangent::Exact);
    if (const auto exact = m_tangents.solve(loads, tolerance))
      return *exact;
  }
  loads.col(0) = -m_tangents.coupling(motion, Tangent::Positive);
  return m_tangents.solve_positive(loads);
}

/// The largest share of the remaining motion that a step can take; 0 if that is too little.
/// \param correction  the part of the step that takes none
double EquilibriumSolver::largest_share(const Walk& walk, const Pace& pace,
                                        const std::vector<Vec3>& motion,
                                        const Eigen::VectorXd& correction,
                                        const Eigen::VectorXd& response)
{
  const std::vector<double> volumes = m_model.dilatations(walk.x);
  double share = std::min(1.0, walk.longest_step / walk.remaining);
  for (; share == 1 || share * walk.remaining > m_options.smallest_load_step; share *= 0.9)
  {
    // a little crushing is better than another step for a small rest
    const double least = (share == 1 ? 0.5 : 1.0) * pace.least_volume_ratio;
    if (keeps_volume(volumes, stepped(walk.x, motion, correction, response, share), least))
      return share;
  }
  return 0;
}

/// Puts on as much of the remaining load as the pace allows; false if that is too little.
bool EquilibriumSolver::advance(Walk& walk, const Pace& pace)
{
  tell(walk);
  --walk.iterations_left;
  ++walk.summary.newton_iterations;
  std::vector<Vec3> motion(walk.x.size(), Vec3::Zero());
  for (std::size_t i = 0; i < motion.size(); ++i)
    if (m_model.is_prescribed(static_cast<int>(i)))
      motion[i] = walk.target[i] - walk.x[i];
  const Eigen::MatrixXd directions = load_directions(walk, motion);
  const Eigen::VectorXd response = directions.col(0);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(response.size());
  Eigen::VectorXd correction = directions.cols() > 1 ? Eigen::VectorXd(directions.col(1)) : none;
  double share = largest_share(walk, pace, motion, correction, response);
  // a state far from equilibrium may leave little room for load beside its correction
  const double alone = walk.is_near ? 0 : largest_share(walk, pace, motion, none, response);
  if (alone > 1.2 * share)
  {
    share = alone;
    correction = none;
  }
  if (share == 0)
    return false;
  walk.x = stepped(walk.x, motion, correction, response, share);
  walk.last_step = share * walk.remaining;
  walk.remaining = share == 1 ? 0 : walk.remaining * (1 - share);
  walk.is_thrown = !walk.is_near;
  walk.is_near = walk.is_near && share * largest(motion) < near_mm;
  ++walk.summary.load_steps;
  return true;
}

/// Walks on until the target is reached or no way leads on.
Termination EquilibriumSolver::walk(Walk& walk, const Pace& pace)
{
  double settled_to_mm = std::numeric_limits<double>::infinity();
  for (;;)
  {
    const bool stepped = walk.remaining > 0 && walk.iterations_left > 0 && advance(walk, pace);
    if (stepped)
      settled_to_mm = std::numeric_limits<double>::infinity();
    if (stepped && walk.remaining > 0 && !pace.settles)
      continue;
    if (!stepped && settled_to_mm <= m_options.step_tolerance_mm)
      return Termination::TissueCollapses;
    // where no load can be put on, an approach to equilibrium may do
    const bool approach = walk.remaining > 0 && !pace.settles && settled_to_mm > near_mm;
    settled_to_mm = approach ? near_mm : m_options.step_tolerance_mm;
    if (!newton(walk, settled_to_mm, pace.patience))
    {
      if (walk.iterations_left <= 0)
        return Termination::IterationLimit;
      if (!pace.settles || !stepped || !walk.retreat(m_options.smallest_load_step))
        return Termination::EquilibriumLost;
      continue;
    }
    if (approach)
      continue;
    walk.accept();
    if (walk.remaining == 0)
      return Termination::Converged;
  }
}

void EquilibriumSolver::finish(EquilibriumSummary& summary, const std::vector<Vec3>& x)
{
  const std::vector<double> volumes = m_model.dilatations(x);
  if (!volumes.empty())
    summary.smallest_dilatation = *std::min_element(volumes.begin(), volumes.end());
  summary.effort = m_tangents.take_effort();
}

EquilibriumSummary EquilibriumSolver::move_to(std::vector<Vec3>& x, const std::vector<Vec3>& target)
{
  EquilibriumSummary summary;
  {
    const TimedPart time(m_tangents.effort().total);
    const int third = m_options.max_total_iterations / 3;
    Walk bold{x, target, summary, third};
    summary.termination = walk(bold, {0.3, false, 12});
    if (summary.termination == Termination::EquilibriumLost ||
        summary.termination == Termination::IterationLimit)
    {
      Walk careful{x, target, summary, 2 * third + bold.iterations_left};
      careful.remaining = 1 - summary.load_reached;
      careful.told = bold.told;
      summary.termination = walk(careful, {0.6, true, m_options.max_newton_iterations});
    }
  }
  finish(summary, x);
  return summary;
}

EquilibriumSummary EquilibriumSolver::relax(std::vector<Vec3>& x)
{
  EquilibriumSummary summary;
  {
    const TimedPart time(m_tangents.effort().total);
    m_tangents.forget_state();
    Walk walk{x, x, summary, m_options.max_total_iterations};
    walk.remaining = 0;
    if (newton(walk, m_options.step_tolerance_mm, m_options.max_newton_iterations))
      walk.accept();
    else
      summary.termination = Termination::EquilibriumLost;
  }
  finish(summary, x);
  return summary;
}

/// Motions of the unknowns under loads, at the state that was linearised last.
std::vector<std::vector<Vec3>> EquilibriumSolver::answers_to(const Eigen::MatrixXd& loads,
                                                             double tolerance)
{
  // an equilibrium without a positive definite tangent is none that could be kept
  const auto exact = m_tangents.solve(loads, tolerance);
  const Eigen::MatrixXd answers = exact ? *exact : m_tangents.solve_positive(loads);
  const std::vector<Vec3> none(m_model.control_count(), Vec3::Zero());
  std::vector<std::vector<Vec3>> responses;
  for (Eigen::Index m = 0; m < answers.cols(); ++m)
    responses.push_back(moved(none, answers.col(m), 1));
  return responses;
}

std::vector<std::vector<Vec3>>
EquilibriumSolver::respond(const std::vector<Vec3>& x,
                           const std::vector<std::vector<Vec3>>& motions, double tolerance)
{
  const TimedPart time(m_tangents.effort().total);
  (void)m_tangents.linearize(x);
  Eigen::MatrixXd loads(m_model.unknown_count(), static_cast<Eigen::Index>(motions.size()));
  for (std::size_t m = 0; m < motions.size(); ++m)
    loads.col(static_cast<Eigen::Index>(m)) = -m_tangents.coupling(motions[m], Tangent::Exact);
  return answers_to(loads, tolerance);
}

std::vector<std::vector<Vec3>> EquilibriumSolver::yield_to(const std::vector<Vec3>& x,
                                                           const Eigen::MatrixXd& forces,
                                                           double tolerance)
{
  const TimedPart time(m_tangents.effort().total);
  (void)m_tangents.linearize(x);
  return answers_to(forces, tolerance);
}

} // namespace f2b
