#pragma once

#include "Core/solve/cholesky.hpp"

/// What is a symmetric matrix times vectors?
namespace f2b
{

/// Products with matrices of one pattern of full 3 x 3 blocks, in parallel. Every entry of the
/// result is summed in the same order whatever the number of threads.
class SymmetricProduct
{
public:
  /// Reads the pattern; later matrices have the same.
  void analyze(const SymmetricMatrix& matrix);
  /// A x, one vector per column.
  Eigen::MatrixXd operator()(const SymmetricMatrix& matrix, const Eigen::MatrixXd& x) const;

private:
  // A column of blocks is stored from its diagonal down; what lies left of the diagonal in a row of
  // blocks is listed here.
  struct Left
  {
    int column; ///< of blocks
    int place;  ///< in that column, the diagonal is 0
  };
  std::vector<std::size_t> m_left_start; ///< per row of blocks
  std::vector<Left> m_left;              ///< columns ascending in a row
};

} // namespace f2b
