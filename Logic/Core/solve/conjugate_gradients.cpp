#include "Core/solve/conjugate_gradients.hpp"

#include <cmath>

namespace f2b
{
namespace
{

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

Row dots(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.cwiseProduct(b).colwise().sum().array();
}

/// a / b, zero for columns that have converged to nothing left.
Row quotients(const Row& a, const Row& b)
{
  return (b > 0).select(a / b, 0.0);
}

/// Whether the mean rate so far, or twice as many digits a step, would come too late. Conjugate
/// gradients get faster as they go, hence the benefit of the doubt.
bool too_slow(double reduction, int iterations, const CgOptions& options)
{
  if (iterations < 4)
    return false;
  const double digits = std::log10(reduction) / iterations;
  return !(digits < 0) || std::log10(options.tolerance) / digits > 2.0 * options.max_iterations;
}

} // namespace

CgResult conjugate_gradients(const LinearMap& product, const LinearMap& preconditioner,
                             const Eigen::MatrixXd& right_hand_sides, const CgOptions& options)
{
  CgResult result;
  result.x = Eigen::MatrixXd::Zero(right_hand_sides.rows(), right_hand_sides.cols());
  Eigen::MatrixXd r = right_hand_sides, z = preconditioner(r), p = z;
  Row rz = dots(r, z);
  const Row beginning = rz;
  while ((rz > options.tolerance * options.tolerance * beginning).any())
  {
    if (result.iterations >= options.max_iterations ||
        too_slow(result.reduction, result.iterations, options))
    {
      result.termination = CgTermination::IterationLimit;
      return result;
    }
    const Eigen::MatrixXd q = product(p);
    const Row curvature = dots(p, q);
    if (((curvature <= 0) && (rz > 0)).any())
    {
      result.termination = CgTermination::NegativeCurvature;
      return result;
    }
    ++result.iterations;
    const Row length = quotients(rz, curvature);
    result.x += p * length.matrix().asDiagonal();
    r -= q * length.matrix().asDiagonal();
    z = preconditioner(r);
    const Row next = dots(r, z);
    p = z + p * quotients(next, rz).matrix().asDiagonal();
    rz = next;
    result.reduction = std::sqrt(quotients(rz, beginning).maxCoeff());
  }
  return result;
}

} // namespace f2b
