#include "Core/solve/symmetric_product.hpp"

#include "Core/geometry/vectors.hpp"

#include <cassert>
#include <numeric>

namespace f2b
{
namespace
{

/// A column of 3 x 3 blocks, from the diagonal down. Its three columns of numbers begin with the
/// lower triangle of the diagonal block, so that each has one number less than the one before.
class BlockColumn
{
public:
  BlockColumn(const SymmetricMatrix& matrix, std::size_t column)
      : m_row(matrix.row.data() + matrix.column_start[3 * column])
  {
    for (std::size_t k = 0; k < 3; ++k)
      m_value[k] = matrix.value.data() + matrix.column_start[3 * column + k] - static_cast<long>(k);
    m_blocks = (matrix.column_start[3 * column + 1] - matrix.column_start[3 * column]) / 3;
  }
  long blocks() const { return m_blocks; }
  long row(long place) const { return m_row[3 * place]; }
  Mat3 diagonal() const
  {
    Mat3 block;
    for (int c = 0; c < 3; ++c)
      for (int r = c; r < 3; ++r)
        block(r, c) = block(c, r) = m_value[static_cast<std::size_t>(c)][r];
    return block;
  }
  /// y += B x
  void multiply(long place, const double* x, Vec3& y) const
  {
    for (std::size_t c = 0; c < 3; ++c)
      y += x[c] * Eigen::Map<const Vec3>(m_value[c] + 3 * place);
  }
  /// y += B^T x
  void multiply_transposed(long place, const double* x, Vec3& y) const
  {
    const Eigen::Map<const Vec3> at(x);
    for (std::size_t c = 0; c < 3; ++c)
      y[static_cast<Eigen::Index>(c)] += at.dot(Eigen::Map<const Vec3>(m_value[c] + 3 * place));
  }

private:
  const long* m_row;
  const double* m_value[3]; ///< where row 0 of the diagonal block would be
  long m_blocks;
};

} // namespace

void SymmetricProduct::analyze(const SymmetricMatrix& matrix)
{
  assert(matrix.size % 3 == 0);
  const auto columns = static_cast<std::size_t>(matrix.size / 3);
  const auto for_each_left = [&](const auto& visit)
  {
    for (std::size_t c = 0; c < columns; ++c)
    {
      const BlockColumn column(matrix, c);
      for (long place = 1; place < column.blocks(); ++place)
        visit(static_cast<std::size_t>(column.row(place) / 3), c, place);
    }
  };
  m_left_start.assign(columns + 1, 0);
  for_each_left([&](std::size_t row, std::size_t, long) { ++m_left_start[row + 1]; });
  std::partial_sum(m_left_start.begin(), m_left_start.end(), m_left_start.begin());
  m_left.resize(m_left_start.back());
  std::vector<std::size_t> next(m_left_start.begin(), m_left_start.end() - 1);
  for_each_left(
      [&](std::size_t row, std::size_t column, long place) {
        m_left[next[row]++] = {static_cast<int>(column), static_cast<int>(place)};
      });
}

Eigen::MatrixXd SymmetricProduct::operator()(const SymmetricMatrix& matrix,
                                             const Eigen::MatrixXd& x) const
{
  Eigen::MatrixXd y(x.rows(), x.cols());
#pragma omp parallel for schedule(static)
  for (long r = 0; r < matrix.size / 3; ++r)
  {
    const auto row = static_cast<std::size_t>(r);
    const BlockColumn own(matrix, row);
    for (Eigen::Index k = 0; k < x.cols(); ++k)
    {
      const double* xk = x.data() + k * x.rows();
      Vec3 sum = own.diagonal() * Eigen::Map<const Vec3>(xk + 3 * r);
      for (std::size_t i = m_left_start[row]; i < m_left_start[row + 1]; ++i)
        BlockColumn(matrix, static_cast<std::size_t>(m_left[i].column))
            .multiply(m_left[i].place, xk + 3 * m_left[i].column, sum);
      for (long place = 1; place < own.blocks(); ++place)
        own.multiply_transposed(place, xk + own.row(place), sum);
      y.col(k).segment<3>(3 * r) = sum;
    }
  }
  return y;
}

} // namespace f2b
