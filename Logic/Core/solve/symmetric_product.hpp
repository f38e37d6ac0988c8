#pragma once

#include "Core/solve/cholesky.hpp"

/// What is a symmetric matrix times vectors?
namespace f2b
{

/// Products with matrices of one pattern, in parallel. Every entry of the result is summed in the
/// same order whatever the number of threads.
class SymmetricProduct
{
public:
  /// Reads the pattern; later matrices have the same.
  void analyze(const SymmetricMatrix& matrix);
  /// A x, one vector per column.
  Eigen::MatrixXd operator()(const SymmetricMatrix& matrix, const Eigen::MatrixXd& x) const;

private:
  // The stored column c holds row c from its diagonal on; what lies left of it is listed here.
  std::vector<long> m_left_start;  ///< per row
  std::vector<long> m_left_column; ///< ascending in a row
  std::vector<long> m_left_entry;  ///< its place in SymmetricMatrix::value
};

} // namespace f2b
