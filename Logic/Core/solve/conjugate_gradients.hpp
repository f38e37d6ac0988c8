#pragma once

#include <Eigen/Core>

#include <functional>

/// How is a system solved with the factor of a similar one?
namespace f2b
{

using LinearMap = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

enum class CgTermination
{
  Converged,
  IterationLimit,    ///< reached, or seen coming from the rate so far
  NegativeCurvature, ///< the matrix is not positive definite
};

struct CgOptions
{
  double tolerance = 1e-10; ///< of the preconditioned residual norm, relative to its beginning
  int max_iterations = 30;
};

struct CgResult
{
  CgTermination termination = CgTermination::Converged;
  int iterations = 0;
  double reduction = 1; ///< of the residual norm, the worst of all right-hand sides
  Eigen::MatrixXd x;    ///< the solutions so far
};

/// Preconditioned conjugate gradients for several right-hand sides at once, one per column.
///
/// \param product         x -> A x, A symmetric
/// \param preconditioner  r -> M^-1 r, M symmetric positive definite
[[nodiscard]] CgResult conjugate_gradients(const LinearMap& product,
                                           const LinearMap& preconditioner,
                                           const Eigen::MatrixXd& right_hand_sides,
                                           const CgOptions& options);

} // namespace f2b
