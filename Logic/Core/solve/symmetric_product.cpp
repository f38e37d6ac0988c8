#include "Core/solve/symmetric_product.hpp"

namespace f2b
{

void SymmetricProduct::analyze(const SymmetricMatrix& matrix)
{
  const auto size = static_cast<std::size_t>(matrix.size);
  m_left_start.assign(size + 1, 0);
  for (std::size_t c = 0; c < size; ++c)
    for (long i = matrix.column_start[c] + 1; i < matrix.column_start[c + 1]; ++i)
      ++m_left_start[static_cast<std::size_t>(matrix.row[static_cast<std::size_t>(i)]) + 1];
  for (std::size_t r = 0; r < size; ++r)
    m_left_start[r + 1] += m_left_start[r];
  m_left_column.resize(static_cast<std::size_t>(m_left_start.back()));
  m_left_entry.resize(m_left_column.size());
  std::vector<long> next(m_left_start.begin(), m_left_start.end() - 1);
  for (std::size_t c = 0; c < size; ++c)
    for (long i = matrix.column_start[c] + 1; i < matrix.column_start[c + 1]; ++i)
    {
      const auto row = static_cast<std::size_t>(matrix.row[static_cast<std::size_t>(i)]);
      const auto at = static_cast<std::size_t>(next[row]++);
      m_left_column[at] = static_cast<long>(c);
      m_left_entry[at] = i;
    }
}

Eigen::MatrixXd SymmetricProduct::operator()(const SymmetricMatrix& matrix,
                                             const Eigen::MatrixXd& x) const
{
  Eigen::MatrixXd y(x.rows(), x.cols());
#pragma omp parallel for schedule(static)
  for (long r = 0; r < matrix.size; ++r)
  {
    const auto row = static_cast<std::size_t>(r);
    for (Eigen::Index k = 0; k < x.cols(); ++k)
    {
      const double* xk = x.data() + k * x.rows();
      double sum = 0;
      for (long i = m_left_start[row]; i < m_left_start[row + 1]; ++i)
      {
        const auto at = static_cast<std::size_t>(i);
        sum += matrix.value[static_cast<std::size_t>(m_left_entry[at])] * xk[m_left_column[at]];
      }
      for (long i = matrix.column_start[row]; i < matrix.column_start[row + 1]; ++i)
        sum +=
            matrix.value[static_cast<std::size_t>(i)] * xk[matrix.row[static_cast<std::size_t>(i)]];
      y(r, k) = sum;
    }
  }
  return y;
}

} // namespace f2b
