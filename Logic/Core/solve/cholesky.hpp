#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

/// What solves the tangent system?
namespace f2b
{

/// A symmetric matrix by its lower triangle in compressed columns, rows ascending in a column.
struct SymmetricMatrix
{
  long size = 0;
  std::vector<long> column_start; ///< size + 1
  std::vector<long> row;
  std::vector<double> value;
};

/// Sparse Cholesky factorisation: CHOLMOD, supernodal, METIS ordering.
///
/// The ordering and symbolic factor are kept as long as the pattern stays the same. CHOLMOD's
/// Supernodal module is GPL-2+ (see README.md).
class Cholesky
{
public:
  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// Orders and factorises symbolically.
  /// \param block  so many successive rows have the same pattern, but for the diagonal: they are
  ///               ordered as one
  void analyze(const SymmetricMatrix& matrix, int block = 1);
  /// Numeric factorisation of a matrix with the analysed pattern; false if not positive definite.
  [[nodiscard]] bool factorize(const SymmetricMatrix& matrix);
  /// Solves for several right-hand sides, one per column. The last factorisation succeeded.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;
  /// The same in single precision, in less than half the time: to precondition with. The first
  /// after a factorisation copies the factor.
  Eigen::MatrixXd precondition(const Eigen::MatrixXd& right_hand_sides);

  /// Floating-point operations of one numeric factorisation, and entries of the factor.
  double flops() const;
  double entries() const;
  /// The most memory that analysis and factors have held at one time.
  double peak_bytes() const;

private:
  struct Factor;
  std::unique_ptr<Factor> m_factor;
};

} // namespace f2b
