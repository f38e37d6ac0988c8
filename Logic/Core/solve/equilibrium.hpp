#pragma once

#include "Core/assembly/elastic_model.hpp"
#include "Core/solve/tangent_solver.hpp"

#include <functional>

/// Where does the tissue come to rest when bone moves or springs pull?
namespace f2b
{

struct EquilibriumOptions
{
  int max_newton_iterations = 25;       ///< on the way to one equilibrium
  double step_tolerance_mm = 1e-8;      ///< converged when less than that is left to go [mm]
  double smallest_load_step = 1.0 / 64; ///< share of the load, below which a move is given up
  int max_total_iterations = 120;       ///< of one move: then it is given up
};

enum class Termination
{
  Converged,
  TissueCollapses, ///< a further share of the load, however small, would crush or invert elements
  EquilibriumLost, ///< Newton's method finds no equilibrium, or only without a stable tangent
  IterationLimit,  ///< max_total_iterations
};

/// What a solve did.
struct EquilibriumSummary
{
  Termination termination = Termination::Converged;
  int load_steps = 0;        ///< shares in which the load was put on
  int newton_iterations = 0; ///< tangents solved with, those of load steps included
  double load_reached = 0;   ///< share of the load that the last equilibrium carries, in [0, 1]
  double smallest_dilatation = 1;  ///< det F of the most compressed point of that equilibrium
  double last_step_mm = 0;         ///< largest component of the last Newton step
  std::vector<double> steps_mm;    ///< of every Newton iteration, for convergence plots
  std::vector<double> residuals_n; ///< norm of the unbalanced forces before each of these steps
  SolveEffort effort;

  bool converged() const { return termination == Termination::Converged; }
  void add(const EquilibriumSummary& other);
};

/// Newton's method for one model, with the load put on as the steps allow.
///
/// While load is left, a step solves for the unknowns with as much of the remaining motion as
/// shrinks no element to less than a third of its volume; only with all of it on, Newton's method
/// with a line search on the energy converges. Where the exact tangent is not positive definite
/// the positive one takes its place, so a step always lowers the energy. If that fails, the way is
/// walked again in smaller shares with an equilibrium after each; a share that leads to none is
/// halved. A state with an inverted quadrature point is never accepted.
class EquilibriumSolver
{
public:
  EquilibriumSolver(ElasticModel& model, EquilibriumOptions options);

  /// Moves what is prescribed from where it is in `x` to where `target` says, and brings the
  /// unknowns to equilibrium.
  ///
  /// \param x       control vectors; in: an equilibrium, out: the last equilibrium reached, also
  ///                when the progress throws [mm]
  /// \param target  of everything prescribed; those of unknowns are not used [mm]
  [[nodiscard]] EquilibriumSummary move_to(std::vector<Vec3>& x, const std::vector<Vec3>& target);

  /// Brings the unknowns to equilibrium with what is prescribed where it is; also after the
  /// model's springs have changed.
  [[nodiscard]] EquilibriumSummary relax(std::vector<Vec3>& x);

  /// For the solves from now on: rough ones on the way to an exact one.
  void set_step_tolerance(double mm) { m_options.step_tolerance_mm = mm; }

  /// Motions of the unknowns that follow small motions of what is prescribed, at an equilibrium
  /// `x`, by its exact tangent. Each motion has one vector per control vector [mm].
  /// \param tolerance  relative, of the solves
  std::vector<std::vector<Vec3>> respond(const std::vector<Vec3>& x,
                                         const std::vector<std::vector<Vec3>>& motions,
                                         double tolerance = 1e-10);
  /// Motions of the unknowns that balance small forces on them, one column each [N], at `x`; what
  /// is prescribed stays. One vector per control vector [mm].
  std::vector<std::vector<Vec3>> yield_to(const std::vector<Vec3>& x, const Eigen::MatrixXd& forces,
                                          double tolerance = 1e-10);

  /// Is told at every Newton iteration how far a solve has come, in [0, 1]; may throw to cancel.
  void set_progress(std::function<void(double)> progress) { m_progress = std::move(progress); }

private:
  struct Walk;
  struct Pace;
  /// Of Newton's method.
  struct Step
  {
    double length_mm; ///< its largest component, as it was solved for
    bool is_whole;    ///< by the exact tangent and not shortened
  };

  Termination walk(Walk& walk, const Pace& pace);
  bool advance(Walk& walk, const Pace& pace);
  double largest_share(const Walk& walk, const Pace& pace, const std::vector<Vec3>& motion,
                       const Eigen::VectorXd& correction, const Eigen::VectorXd& response);
  Eigen::MatrixXd load_directions(Walk& walk, const std::vector<Vec3>& motion);
  bool newton(Walk& walk, double tolerance_mm, int patience);
  std::optional<Eigen::MatrixXd> exact_step(const Walk& walk, const Eigen::VectorXd& load,
                                            double forcing);
  std::optional<Step> newton_iteration(Walk& walk, double forcing);
  double line_search(Walk& walk, const Eigen::VectorXd& forces, const Eigen::VectorXd& step,
                     bool extend);
  double energy(const std::vector<Vec3>& x);
  bool keeps_volume(const std::vector<double>& before, const std::vector<Vec3>& x, double share);
  std::vector<Vec3> moved(const std::vector<Vec3>& x, const Eigen::VectorXd& step,
                          double scale) const;
  std::vector<Vec3> stepped(const std::vector<Vec3>& x, const std::vector<Vec3>& motion,
                            const Eigen::VectorXd& correction, const Eigen::VectorXd& response,
                            double share) const;
  std::vector<std::vector<Vec3>> answers_to(const Eigen::MatrixXd& loads, double tolerance);
  void tell(Walk& walk) const;
  void finish(EquilibriumSummary& summary, const std::vector<Vec3>& x);

  ElasticModel& m_model;
  EquilibriumOptions m_options;
  TangentSolver m_tangents;
  std::function<void(double)> m_progress;
};

} // namespace f2b
