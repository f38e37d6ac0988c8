#include "Core/solve/tangent_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace f2b
{

const Eigen::VectorXd& TangentSolver::linearize(const std::vector<Vec3>& x, Tangent tangent)
{
  if (x == m_at)
    return m_forces;
  m_at = x;
  m_indefinite = false;
  if (m_factor != Factor::None)
    m_factor = Factor::Old;
  assemble(tangent);
  return m_forces;
}

void TangentSolver::assemble(Tangent tangent)
{
  const TimedPart time(m_effort.assembly);
  ++m_effort.linearizations;
  m_forces = m_model.linearize(m_at, tangent);
  m_assembled = tangent;
}

Eigen::VectorXd TangentSolver::coupling(const std::vector<Vec3>& motion, Tangent tangent)
{
  if (m_assembled != tangent)
    assemble(tangent);
  const TimedPart time(m_effort.assembly);
  return m_model.coupling(motion);
}

/// Numeric factorisation of what is assembled; false if it is not positive definite.
bool TangentSolver::factorize()
{
  if (!m_analyzed)
  {
    const TimedPart time(m_effort.analysis);
    m_cholesky.analyze(m_model.stiffness(), 3);
    m_product.analyze(m_model.stiffness());
    m_analyzed = true;
    ++m_effort.analyses;
  }
  const TimedPart time(m_effort.factorization);
  ++m_effort.factorizations;
  m_effort.factorization_flops += m_cholesky.flops();
  m_factor = Factor::None;
  if (!m_cholesky.factorize(m_model.stiffness()))
    return false;
  m_effort.factor_peak_bytes = std::max(m_effort.factor_peak_bytes, m_cholesky.peak_bytes());
  m_factor = m_assembled == Tangent::Exact ? Factor::Exact : Factor::Positive;
  m_digits_an_iteration = std::numeric_limits<double>::infinity();
  return true;
}

/// For a positive tangent that rounding, or a part that hangs on nothing, makes singular.
bool TangentSolver::factorize_shifted()
{
  SymmetricMatrix shifted = m_model.stiffness();
  double largest = 0;
  for (const double value : shifted.value)
    largest = std::max(largest, std::abs(value));
  double added = 0;
  for (const double shift : {1e-8 * largest, 1e-6 * largest, 1e-4 * largest})
  {
    for (std::size_t c = 0; c + 1 < shifted.column_start.size(); ++c)
      shifted.value[static_cast<std::size_t>(shifted.column_start[c])] += shift - added;
    added = shift;
    const TimedPart time(m_effort.factorization);
    ++m_effort.factorizations;
    m_effort.factorization_flops += m_cholesky.flops();
    if (m_cholesky.factorize(shifted))
    {
      m_factor = Factor::Positive;
      return true;
    }
  }
  return false;
}

Eigen::MatrixXd TangentSolver::back_solve(const Eigen::MatrixXd& right_hand_sides)
{
  const TimedPart time(m_effort.back_solving);
  ++m_effort.back_solves;
  return m_cholesky.solve(right_hand_sides);
}

/// The iterations that cost as much as a factorisation. A back-solve reads each entry of the
/// factor twice at the speed of memory, while a factorisation computes at the speed of BLAS: about
/// 50 operations in the time of one entry; further right-hand sides cost a quarter each.
int TangentSolver::worth_iterations(Eigen::Index columns) const
{
  const double factorization = m_cholesky.flops() / (50 * m_cholesky.entries());
  const double iteration = 1 + 0.25 * static_cast<double>(columns - 1);
  return std::clamp(static_cast<int>(factorization / iteration), 4, 40);
}

std::optional<Eigen::MatrixXd>
TangentSolver::solve_by_old_factor(const Eigen::MatrixXd& right_hand_sides, double tolerance)
{
  if (right_hand_sides.rows() == 0)
    return right_hand_sides;
  if (m_factor == Factor::None || m_indefinite)
    return std::nullopt;
  if (m_factor == Factor::Exact)
    return back_solve(right_hand_sides);
  if (m_assembled != Tangent::Exact)
    assemble(Tangent::Exact);
  const LinearMap product = [this](const Eigen::MatrixXd& x)
  {
    const TimedPart time(m_effort.products);
    return m_product(m_model.stiffness(), x);
  };
  const LinearMap preconditioner = [this](const Eigen::MatrixXd& r)
  {
    const TimedPart time(m_effort.back_solving);
    ++m_effort.back_solves;
    return m_cholesky.precondition(r);
  };
  CgResult result = conjugate_gradients(product, preconditioner, right_hand_sides,
                                        {tolerance, worth_iterations(right_hand_sides.cols())});
  m_effort.cg_iterations += result.iterations;
  if (result.iterations > 0)
    m_digits_an_iteration = -std::log10(result.reduction) / result.iterations;
  if (result.termination == CgTermination::Converged)
    return std::move(result.x);
  m_indefinite = result.termination == CgTermination::NegativeCurvature;
  return std::nullopt;
}

std::optional<Eigen::MatrixXd> TangentSolver::solve(const Eigen::MatrixXd& right_hand_sides,
                                                    double tolerance, double to_come)
{
  const double digits = -std::log10(std::min(tolerance, to_come));
  const bool slow = m_factor == Factor::Old &&
                    digits > m_digits_an_iteration * worth_iterations(right_hand_sides.cols());
  if (!slow)
    if (auto solution = solve_by_old_factor(right_hand_sides, tolerance))
      return solution;
  if (m_indefinite)
    return std::nullopt;
  if (m_assembled != Tangent::Exact)
    assemble(Tangent::Exact);
  m_indefinite = !factorize();
  if (m_indefinite)
    return std::nullopt;
  return back_solve(right_hand_sides);
}

Eigen::MatrixXd TangentSolver::solve_positive(const Eigen::MatrixXd& right_hand_sides)
{
  if (m_factor != Factor::Positive && right_hand_sides.rows() > 0)
  {
    if (m_assembled != Tangent::Positive)
      assemble(Tangent::Positive);
    if (!factorize() && !factorize_shifted())
      throw std::runtime_error("the stiffness of the mesh is not a number");
  }
  return right_hand_sides.rows() ? back_solve(right_hand_sides) : right_hand_sides;
}

SolveEffort TangentSolver::take_effort()
{
  SolveEffort spent;
  std::swap(spent, m_effort);
  return spent;
}

} // namespace f2b
