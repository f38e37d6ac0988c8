#pragma once

#include "Core/assembly/elastic_model.hpp"
#include "Core/solve/cholesky.hpp"
#include "Core/solve/conjugate_gradients.hpp"
#include "Core/solve/solve_effort.hpp"
#include "Core/solve/symmetric_product.hpp"

#include <optional>

/// How do the unknowns answer forces, by the tangent at one state?
namespace f2b
{

/// Solves with the tangents of one model, in as few factorisations as pay off.
///
/// A factor is kept when the state changes: it then preconditions conjugate gradients on the
/// current tangent, which costs a back-solve an iteration, until that would cost more than a new
/// factor. Costs are counted in operations, never measured, so that decisions are reproducible.
class TangentSolver
{
public:
  explicit TangentSolver(ElasticModel& model) : m_model(model) {}

  /// Linearises the model at x; what follows refers to this state. Returns the forces there [N].
  /// \param tangent  that will be needed first
  const Eigen::VectorXd& linearize(const std::vector<Vec3>& x, Tangent tangent = Tangent::Exact);
  /// Forces from a small motion of what is prescribed, by the exact or the positive tangent [N].
  Eigen::VectorXd coupling(const std::vector<Vec3>& motion, Tangent tangent);

  /// Solves with the exact tangent; nothing if it is not positive definite.
  /// \param tolerance  relative
  /// \param to_come    tolerance that all solves from here to the end of the task add up to: if the
  ///                   old factor would be too slow for that, a new one is made at once
  std::optional<Eigen::MatrixXd> solve(const Eigen::MatrixXd& right_hand_sides, double tolerance,
                                       double to_come = 1);
  /// The same without a new factor; nothing also if that would take too many iterations.
  std::optional<Eigen::MatrixXd> solve_by_old_factor(const Eigen::MatrixXd& right_hand_sides,
                                                     double tolerance);
  /// Solves with the positive tangent.
  Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& right_hand_sides);

  /// The model's springs or the like have changed: nothing that was linearised holds any more.
  void forget_state() { m_at.clear(); }
  /// What was spent since the last call.
  SolveEffort take_effort();
  SolveEffort& effort() { return m_effort; }

private:
  enum class Factor
  {
    None,
    Old,      ///< of another state
    Exact,    ///< of the exact tangent here
    Positive, ///< of the positive tangent here
  };
  void assemble(Tangent tangent);
  bool factorize();
  bool factorize_shifted();
  int worth_iterations(Eigen::Index columns) const;
  Eigen::MatrixXd back_solve(const Eigen::MatrixXd& right_hand_sides);

  ElasticModel& m_model;
  Cholesky m_cholesky;
  SymmetricProduct m_product;
  std::vector<Vec3> m_at; ///< the state
  Eigen::VectorXd m_forces;
  Tangent m_assembled = Tangent::Exact; ///< what the model's stiffness is at present
  Factor m_factor = Factor::None;
  double m_digits_an_iteration = 0; ///< that conjugate gradients won with the factor last
  bool m_indefinite = false;        ///< the exact tangent here, as far as is known
  bool m_analyzed = false;
  SolveEffort m_effort;
};

} // namespace f2b
