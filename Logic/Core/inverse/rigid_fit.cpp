#include "Core/inverse/rigid_fit.hpp"

#include "Core/error.hpp"
#include "Core/inverse/box_step.hpp"
#include "Core/inverse/skin_sensitivity.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

/// One run of the fit: the model with its fragments, and the current state.
class Fit
{
public:
  Fit(const FaceModel& face, const SkinTarget& target, const RigidFitOptions& options,
      const RigidFitResult* start)
      : m_face(face), m_options(options), m_space(movement_space(face, options)),
        m_residual(skin_residual(face, target, options.wish_weight())),
        m_model(face.tissue, face.materials, held_controls(face.tissue, Held::BoneAndFragments)),
        m_solver(m_model, options.equilibrium), m_q(start ? start->q : m_space.start()),
        m_x(start ? start->x : face.tissue.rest())
  {
    assert(m_q.size() == m_space.size() && m_x.size() == face.tissue.control_count());
  }

  RigidFitResult run(const Progress& progress);

private:
  /// Gauss-Newton's, and how far each coordinate may go.
  struct Quadratic
  {
    Eigen::MatrixXd H;
    Eigen::VectorXd g, least, most;

    /// Leaves a coordinate where it is.
    void hold(Eigen::Index k)
    {
      hold_coordinate(H, k);
      g[k] = least[k] = most[k] = 0;
    }
  };

  double wish_weight() const { return m_options.wish_weight(); }
  double objective(const Eigen::VectorXd& q, const std::vector<Vec3>& x) const;
  Quadratic quadratic();
  void hold_unseen(const std::vector<std::vector<Vec3>>& columns);
  bool is_held(Eigen::Index k) const;
  Eigen::VectorXd damped_step(const Quadratic& model) const;
  EquilibriumSummary settle(const Eigen::VectorXd& q, std::vector<Vec3>& x);
  /// Share of the step that the tissue could follow; 1 also where it does not lower the objective.
  double try_step(const Eigen::VectorXd& step, bool& accepted);
  bool small(const RigidFitIteration& iteration) const
  {
    return iteration.translation_mm < m_options.translation_tolerance_mm &&
           iteration.rotation_rad < m_options.rotation_tolerance_rad;
  }
  RigidFitIteration measure(const Eigen::VectorXd& step) const;
  void require_sensitivity(const Eigen::MatrixXd& H) const;
  bool descend(const Quadratic& model);
  void tighten(const RigidFitIteration& step);
  bool refine();
  std::vector<Eigen::Index> held_back(const Quadratic& model) const;

  const FaceModel& m_face;
  const RigidFitOptions& m_options;
  MovementSpace m_space;
  SkinResidual m_residual;
  ElasticModel m_model;
  EquilibriumSolver m_solver;
  Eigen::VectorXd m_q;
  std::vector<Vec3> m_x;
  double m_objective = 0;
  double m_damping = 0;
  double m_exactness_mm = 1e-4; ///< of the equilibria at present
  bool m_is_exact = false;      ///< so are the current one and all to come
  bool m_converged = false;
  RigidFitResult m_result;
};

double Fit::objective(const Eigen::VectorXd& q, const std::vector<Vec3>& x) const
{
  return m_residual.objective(m_face.skin.displacement(x)) +
         0.5 * wish_weight() * m_space.wishes(q).squaredNorm();
}

/// Decided once, of the first columns: what a fragment moves hardly changes on the way.
void Fit::hold_unseen(const std::vector<std::vector<Vec3>>& columns)
{
  const std::vector<double> all(m_face.skin_area.size(), 1.0);
  m_result.held_fragments =
      unseen_fragments(m_space, m_q, moved_skin(columns, m_residual.weight()),
                       moved_skin(columns, fit_weights(m_face, {{}, all, {}})));
}

bool Fit::is_held(Eigen::Index k) const
{
  const std::vector<int>& held = m_result.held_fragments;
  return std::find(held.begin(), held.end(),
                   m_space.coordinates()[static_cast<std::size_t>(k)].fragment) != held.end();
}

Fit::Quadratic Fit::quadratic()
{
  const auto columns = skin_columns(m_face, m_space, m_q, m_x, m_solver, m_exactness_mm);
  if (m_result.iterations.empty())
    hold_unseen(columns);
  Quadratic model;
  m_residual.normal_equations(m_face.skin.displacement(m_x), columns, model.H, model.g);
  const Eigen::MatrixXd slopes = m_space.wish_slopes(m_q);
  model.H += wish_weight() * slopes.transpose() * slopes;
  model.g += wish_weight() * slopes.transpose() * m_space.wishes(m_q);
  model.least = m_space.least() - m_q;
  model.most = m_space.most() - m_q;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
  {
    const bool is_angle = m_space.coordinates()[static_cast<std::size_t>(k)].is_angle();
    const double longest = is_angle ? m_options.longest_turn_rad : m_options.longest_step_mm;
    model.least[k] = std::clamp(model.least[k], -longest, 0.0);
    model.most[k] = std::clamp(model.most[k], 0.0, longest);
    if (is_held(k))
      model.hold(k);
  }
  return model;
}

/// A fragment whose motions move no skin that counts cannot be planned from it.
void Fit::require_sensitivity(const Eigen::MatrixXd& H) const
{
  double loaded = 0;
  for (const double w : m_residual.weight())
    loaded += w;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
  {
    const MovementSpace::Coordinate& c = m_space.coordinates()[static_cast<std::size_t>(k)];
    const double per_unit = c.is_angle() ? 1e-8 : 1e-10; // an angle moves bone by tens of mm a rad
    if (!is_held(k) && (!(loaded > 0) || !(H(k, k) > per_unit * loaded)))
      throw Error("fragment '" + m_space.names()[static_cast<std::size_t>(c.fragment)] + "'",
                  "moving it (" + std::string(c.name()) + ") does not move the skin of the target",
                  "give the fragment soft-tissue contact (smaller release margin, other cut), or "
                  "widen the target's mask");
  }
}

/// Marquardt's step: the diagonal of H scaled by the damping, within the bounds.
Eigen::VectorXd Fit::damped_step(const Quadratic& model) const
{
  Eigen::MatrixXd damped = model.H;
  damped.diagonal() *= 1 + std::max(m_damping, 1e-12);
  return box_step(damped, model.g, model.least, model.most);
}

EquilibriumSummary Fit::settle(const Eigen::VectorXd& q, std::vector<Vec3>& x)
{
  const EquilibriumSummary solve =
      m_solver.move_to(x, with_fragments_moved(m_face.tissue, m_space.motions(q)));
  m_result.equilibrium.add(solve);
  return solve;
}

double Fit::try_step(const Eigen::VectorXd& step, bool& accepted)
{
  const Eigen::VectorXd q = (m_q + step).cwiseMax(m_space.least()).cwiseMin(m_space.most());
  std::vector<Vec3> x = m_x;
  const EquilibriumSummary solve = settle(q, x);
  accepted = false;
  if (!solve.converged())
    return solve.load_reached;
  const double trial = objective(q, x);
  accepted = trial < m_objective;
  if (accepted)
  {
    m_objective = trial;
    m_q = q;
    m_x = std::move(x);
  }
  return 1;
}

RigidFitIteration Fit::measure(const Eigen::VectorXd& step) const
{
  RigidFitIteration iteration;
  iteration.objective = m_objective;
  for (std::size_t f = 0; f < m_space.fragment_count(); ++f)
  {
    Vec3 shift = Vec3::Zero(), turn = Vec3::Zero();
    for (Eigen::Index k = 0; k < m_space.size(); ++k)
    {
      const Twist twist = m_space.twists(m_q, k)[f];
      shift += step[k] * twist.v;
      turn += step[k] * twist.omega;
    }
    iteration.rotation_rad = std::max(iteration.rotation_rad, turn.norm());
    iteration.translation_mm = std::max(iteration.translation_mm, shift.norm());
  }
  return iteration;
}

/// The next equilibrium need not be more exact than a small share of the step that leads to it; but
/// so exact that the next, much shorter step still lowers the objective by more than its error.
void Fit::tighten(const RigidFitIteration& step)
{
  constexpr double radius_mm = 50; // of a fragment, about: what an angle moves
  const double length = std::max(step.translation_mm, radius_mm * step.rotation_rad);
  m_exactness_mm =
      std::clamp(1e-5 * length, m_options.equilibrium.step_tolerance_mm, m_exactness_mm);
  m_solver.set_step_tolerance(m_exactness_mm);
}

/// Tries steps of growing damping until one lowers the objective; false if none does.
bool Fit::descend(const Quadratic& model)
{
  // what a step promises below this is rounding of the objective
  const double noise = 1e-12 * m_objective + std::numeric_limits<double>::min();
  for (int attempt = 0; attempt < 12; ++attempt)
  {
    const Eigen::VectorXd step = damped_step(model);
    m_result.iterations.push_back(measure(step));
    const double promised = -model.g.dot(step) - 0.5 * step.dot(model.H * step);
    m_converged = m_converged || small(m_result.iterations.back()) || promised < noise;
    if (m_converged)
      return false;
    tighten(m_result.iterations.back());
    bool accepted = false;
    const double followed = try_step(step, accepted);
    if (accepted)
    {
      m_damping = m_damping < 1e-6 ? 0 : m_damping / 10;
      return true;
    }
    if (followed == 1 && refine())
      return true;
    // a step that the tissue cannot follow must become about as short as what it did follow
    const double length = step.norm();
    do
      m_damping = m_damping == 0 ? 1e-2 : m_damping * 10;
    while (m_damping < 1e12 && damped_step(model).norm() > std::max(followed, 0.1) * length);
  }
  return false;
}

/// Makes the current equilibrium as exact as it can be; false if it is.
bool Fit::refine()
{
  if (m_is_exact)
    return false;
  m_is_exact = true;
  m_exactness_mm = m_options.equilibrium.step_tolerance_mm;
  m_solver.set_step_tolerance(m_exactness_mm);
  m_result.equilibrium.add(m_solver.relax(m_x));
  m_objective = objective(m_q, m_x);
  return true;
}

/// Coordinates at a bound that the objective would fall beyond.
std::vector<Eigen::Index> Fit::held_back(const Quadratic& model) const
{
  const Eigen::VectorXd least = m_space.least(), most = m_space.most();
  std::vector<Eigen::Index> held;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
    if (is_held(k) || (m_q[k] <= least[k] && model.g[k] > 0) ||
        (m_q[k] >= most[k] && model.g[k] < 0))
      held.push_back(k);
  return held;
}

RigidFitResult Fit::run(const Progress& progress)
{
  m_result.equilibrium = m_solver.relax(m_x);
  m_solver.set_step_tolerance(m_exactness_mm);
  // bounds, or what is locked, may leave out the rest position
  const bool at_rest = with_fragments_moved(m_face.tissue, m_space.motions(m_q)) == m_x;
  const bool started = at_rest || settle(m_q, m_x).converged();
  m_objective = objective(m_q, m_x);
  m_result.termination =
      started ? RigidFitTermination::MaxIterations : RigidFitTermination::EquilibriumLost;
  for (int i = 0; started && i < m_options.max_iterations; ++i)
  {
    progress("fitting the fragments", 1 - 1 / (1 + 0.5 * i));
    const Quadratic model = quadratic();
    if (i == 0)
      require_sensitivity(model.H);
    m_result.at_bounds = held_back(model);
    if (descend(model))
      continue;
    m_result.termination = m_converged ? RigidFitTermination::Converged
                           : i > 0     ? RigidFitTermination::NoFurtherDescent
                                       : RigidFitTermination::EquilibriumLost;
    break;
  }
  if (started)
    refine();
  m_result.q = m_q;
  m_result.motions = m_space.motions(m_q);
  m_result.skin_displacement = m_face.skin.displacement(m_x);
  m_result.target_registration = m_residual.registration(m_result.skin_displacement);
  m_result.x = std::move(m_x);
  return std::move(m_result);
}

} // namespace

MovementSpace movement_space(const FaceModel& face, const RigidFitOptions& options)
{
  return {face.tissue.mesh().fragments, face.reference_points, options.rules};
}

RigidFitResult fit_fragments(const FaceModel& face, const SkinTarget& target,
                             const RigidFitOptions& options, const Progress& progress,
                             const RigidFitResult* start)
{
  return Fit(face, target, options, start).run(progress);
}

} // namespace f2b
