#pragma once

#include "Core/assembly/elastic_model.hpp"
#include "Core/progress.hpp"

#include <functional>
#include <string>

/// Where does the tissue come to rest when bone moves or springs pull?
namespace f2b
{

struct EquilibriumOptions
{
  int max_newton_iterations = 25;  ///< in one load step
  double step_tolerance_mm = 1e-8; ///< converged when the largest Newton step is below [mm]
  double smallest_load_step = 1.0 / 64;
  int max_total_iterations = 120; ///< of one move, over all its load steps: then it is given up
};

enum class Termination
{
  Converged,
  LoadStepTooSmall, ///< no admissible state was found even for the smallest load step, or within
                    ///< the iterations that one move is given
};

/// What a solve did.
struct EquilibriumSummary
{
  Termination termination = Termination::Converged;
  int load_steps = 0;
  int newton_iterations = 0;
  int factorizations = 0;
  double load_reached = 0;      ///< share of the load that an accepted state carries, in [0, 1]
  double last_step_mm = 0;      ///< largest component of the last Newton step
  std::vector<double> steps_mm; ///< of every Newton iteration, for convergence plots

  bool converged() const { return termination == Termination::Converged; }
  void add(const EquilibriumSummary& other);
};

/// Newton's method with line search and load stepping for one model.
///
/// A step is accepted only if it inverts no element and lowers the energy. Where the tangent is
/// not positive definite it is shifted until it is; at a converged state it never is shifted.
class EquilibriumSolver
{
public:
  EquilibriumSolver(ElasticModel& model, EquilibriumOptions options);

  /// Moves prescribed nodes from where they are in `x` to where `target` says, in as few load
  /// steps as possible, and brings the unknown nodes to equilibrium.
  ///
  /// \param x       positions of all nodes; in: an equilibrium, out: the last accepted state [mm]
  /// \param target  position of every prescribed node; those of unknown nodes are not used [mm]
  [[nodiscard]] EquilibriumSummary move_to(std::vector<Vec3>& x, const std::vector<Vec3>& target);

  /// Brings the unknown nodes to equilibrium with the prescribed nodes where they are; also after
  /// the model's springs have changed.
  [[nodiscard]] EquilibriumSummary relax(std::vector<Vec3>& x);

  /// Motions of the unknown nodes that follow small motions of prescribed nodes, by the tangent of
  /// the last converged state. Each motion has one vector per node [mm].
  std::vector<std::vector<Vec3>> respond(const std::vector<std::vector<Vec3>>& motions);

  /// Is told the share of the load that is carried, in [0, 1]; may throw to cancel.
  void set_progress(std::function<void(double)> progress) { m_progress = std::move(progress); }


private:
  bool newton(std::vector<Vec3>& x, EquilibriumSummary& summary);
  Eigen::VectorXd newton_step(const Eigen::VectorXd& forces, EquilibriumSummary& summary);
  bool line_search(std::vector<Vec3>& x, const Eigen::VectorXd& forces,
                   const Eigen::VectorXd& step);
  std::vector<Vec3> moved(const std::vector<Vec3>& x, const Eigen::VectorXd& step,
                          double scale) const;
  std::vector<Vec3> predict(const std::vector<Vec3>& x, const std::vector<Vec3>& target,
                            double share);
  void factorize(EquilibriumSummary& summary);

  ElasticModel& m_model;
  EquilibriumOptions m_options;
  Cholesky m_cholesky;
  std::function<void(double)> m_progress;
  double m_shift = 0; ///< that made the last indefinite tangent positive definite
  bool m_analyzed = false;
  bool m_factor_is_current = false; ///< of the tangent at the state that the last solve returned
};

} // namespace f2b
