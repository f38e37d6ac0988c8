#include "Core/solve/light_factor.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

/// No subtree holds more than this share of the factor's entries, so that two threads, or four,
/// are never far apart.
constexpr double largest_share = 0.08;

} // namespace

LightFactor::LightFactor(const SupernodalFactor& f)
    : m_rows(f.row, f.row + f.first_row[f.supernodes]),
      m_permutation(f.permutation, f.permutation + f.size)
{
  std::size_t values = 0;
  for (long s = 0; s < f.supernodes; ++s)
  {
    const Supernode node = {f.first_column[s],
                            f.first_column[s + 1] - f.first_column[s],
                            f.first_row[s + 1] - f.first_row[s],
                            values,
                            static_cast<std::size_t>(f.first_row[s]),
                            f.first_value[s]};
    m_supernodes.push_back(node);
    m_tallest = std::max(m_tallest, node.rows - node.columns);
    values += static_cast<std::size_t>(node.columns * node.rows);
  }
  m_values.resize(values);
  choose_subtrees();
}

void LightFactor::copy(const double* values)
{
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t s = 0; s < m_supernodes.size(); ++s)
  {
    const Supernode& node = m_supernodes[s];
    std::copy_n(values + node.source, node.columns * node.rows,
                m_values.begin() + static_cast<long>(node.value));
  }
}

void LightFactor::choose_subtrees()
{
  const std::size_t count = m_supernodes.size();
  std::vector<int> node_of_column(m_permutation.size());
  for (std::size_t s = 0; s < count; ++s)
    for (long c = 0; c < m_supernodes[s].columns; ++c)
      node_of_column[static_cast<std::size_t>(m_supernodes[s].column + c)] = static_cast<int>(s);
  // in postorder a subtree is a run of supernodes that ends at its root
  std::vector<double> entries(count, 0);
  std::vector<std::size_t> begin(count), parent(count, count);
  for (std::size_t s = 0; s < count; ++s)
    begin[s] = s;
  double total = 0;
  for (std::size_t s = 0; s < count; ++s)
  {
    const Supernode& node = m_supernodes[s];
    const double own = static_cast<double>(node.columns * node.rows);
    entries[s] += own;
    total += own;
    if (node.rows == node.columns)
      continue;
    const int above = m_rows[node.row + static_cast<std::size_t>(node.columns)];
    parent[s] = static_cast<std::size_t>(node_of_column[static_cast<std::size_t>(above)]);
    entries[parent[s]] += entries[s];
    begin[parent[s]] = std::min(begin[parent[s]], begin[s]);
  }
  const auto is_small = [&](std::size_t s) { return entries[s] <= largest_share * total; };
  std::size_t done = 0;
  for (std::size_t s = 0; s < count; ++s)
    if (is_small(s) && (parent[s] == count || !is_small(parent[s])))
    {
      if (begin[s] > done)
        m_top.push_back({done, begin[s]});
      m_subtrees.push_back({begin[s], s + 1});
      done = s + 1;
    }
  if (done < count)
    m_top.push_back({done, count});
}

long LightFactor::column_end(const Range& range) const
{
  const Supernode& last = m_supernodes[range.end - 1];
  return last.column + last.columns;
}

namespace
{

using Block = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

Block block(const float* values, long rows, long first, long count, long columns)
{
  return Block(values + first, count, columns, Eigen::OuterStride<>(rows));
}

// One right-hand side is what conjugate gradients have, and there the time goes. The compiler
// makes these loops for the vector units that the machine has, four columns at a time.

/// y = L x for the rows [first, rows) of a block of columns.
__attribute__((target_clones("avx2,fma", "default"))) void
multiply(const float* L, long rows, long first, long columns, const float* x, float* y)
{
  const long count = rows - first;
  std::fill_n(y, count, 0.0f);
  long j = 0;
  for (; j + 4 <= columns; j += 4)
  {
    const float* a = L + j * rows + first;
    const float *b = a + rows, *c = b + rows, *d = c + rows;
    const float xa = x[j], xb = x[j + 1], xc = x[j + 2], xd = x[j + 3];
#pragma omp simd
    for (long r = 0; r < count; ++r)
      y[r] += (a[r] * xa + b[r] * xb) + (c[r] * xc + d[r] * xd);
  }
  for (; j < columns; ++j)
  {
    const float* a = L + j * rows + first;
    const float xa = x[j];
#pragma omp simd
    for (long r = 0; r < count; ++r)
      y[r] += a[r] * xa;
  }
}

/// x -= L^T y for the rows [first, rows) of a block of columns.
__attribute__((target_clones("avx2,fma", "default"))) void
subtract_transposed(const float* L, long rows, long first, long columns, const float* y, float* x)
{
  const long count = rows - first;
  long j = 0;
  for (; j + 4 <= columns; j += 4)
  {
    const float* a = L + j * rows + first;
    const float *b = a + rows, *c = b + rows, *d = c + rows;
    float sa = 0, sb = 0, sc = 0, sd = 0;
#pragma omp simd reduction(+ : sa, sb, sc, sd)
    for (long r = 0; r < count; ++r)
    {
      sa += a[r] * y[r];
      sb += b[r] * y[r];
      sc += c[r] * y[r];
      sd += d[r] * y[r];
    }
    x[j] -= sa;
    x[j + 1] -= sb;
    x[j + 2] -= sc;
    x[j + 3] -= sd;
  }
  for (; j < columns; ++j)
  {
    const float* a = L + j * rows + first;
    float sa = 0;
#pragma omp simd reduction(+ : sa)
    for (long r = 0; r < count; ++r)
      sa += a[r] * y[r];
    x[j] -= sa;
  }
}

/// L x = b in place, L the triangle at the head of a block.
__attribute__((target_clones("avx2,fma", "default"))) void solve_lower(const float* L, long rows,
                                                                       long columns, float* x)
{
  for (long j = 0; j < columns; ++j)
  {
    const float* a = L + j * rows;
    const float xj = x[j] /= a[j];
#pragma omp simd
    for (long r = j + 1; r < columns; ++r)
      x[r] -= a[r] * xj;
  }
}

/// L^T x = b in place.
__attribute__((target_clones("avx2,fma", "default"))) void solve_upper(const float* L, long rows,
                                                                       long columns, float* x)
{
  for (long j = columns; j-- > 0;)
  {
    const float* a = L + j * rows;
    float sum = 0;
#pragma omp simd reduction(+ : sum)
    for (long r = j + 1; r < columns; ++r)
      sum += a[r] * x[r];
    x[j] = (x[j] - sum) / a[j];
  }
}

/// below = L21 x after x = L11^-1 x.
void eliminate(const float* L, long rows, long columns, float* x, Eigen::VectorXf& below)
{
  solve_lower(L, rows, columns, x);
  multiply(L, rows, columns, columns, x, below.data());
}

template <class Rows, class Vectors>
void eliminate(const float* L, long rows, long columns, Rows&& x, Vectors& below)
{
  block(L, rows, 0, columns, columns).triangularView<Eigen::Lower>().solveInPlace(x);
  below.topRows(rows - columns).noalias() = block(L, rows, columns, rows - columns, columns) * x;
}

/// x = L11^-T (x - L21^T below).
void substitute(const float* L, long rows, long columns, float* x, const Eigen::VectorXf& below)
{
  subtract_transposed(L, rows, columns, columns, below.data(), x);
  solve_upper(L, rows, columns, x);
}

template <class Rows, class Vectors>
void substitute(const float* L, long rows, long columns, Rows&& x, const Vectors& below)
{
  x.noalias() -=
      block(L, rows, columns, rows - columns, columns).transpose() * below.topRows(rows - columns);
  block(L, rows, 0, columns, columns).transpose().triangularView<Eigen::Upper>().solveInPlace(x);
}

auto rows_of(Eigen::VectorXf& x, long first, long)
{
  return x.data() + first;
}

template <class Vectors>
auto rows_of(Vectors& x, long first, long count)
{
  return x.middleRows(first, count);
}

} // namespace

/// Solves with L for a run of supernodes. Rows from `end_column` on are not its own: what it takes
/// from them goes to `above`.
template <class Vectors>
void LightFactor::forward(const Range& range, long end_column, Vectors& own, Vectors& above) const
{
  Vectors below(m_tallest, own.cols());
  for (std::size_t s = range.begin; s < range.end; ++s)
  {
    const Supernode& node = m_supernodes[s];
    eliminate(m_values.data() + node.value, node.rows, node.columns,
              rows_of(own, node.column, node.columns), below);
    const int* rows = m_rows.data() + node.row + node.columns;
    for (long r = 0; r < node.rows - node.columns; ++r)
      (rows[r] < end_column ? own : above).row(rows[r]) -= below.row(r);
  }
}

/// Solves with L^T; what is above is known.
template <class Vectors>
void LightFactor::backward(const Range& range, Vectors& x) const
{
  Vectors below(m_tallest, x.cols());
  for (std::size_t s = range.end; s-- > range.begin;)
  {
    const Supernode& node = m_supernodes[s];
    const int* rows = m_rows.data() + node.row + node.columns;
    for (long r = 0; r < node.rows - node.columns; ++r)
      below.row(r) = x.row(rows[r]);
    substitute(m_values.data() + node.value, node.rows, node.columns,
               rows_of(x, node.column, node.columns), below);
  }
}

template <class Vectors>
void LightFactor::apply(Vectors& x) const
{
  const long size = x.rows(), subtrees = static_cast<long>(m_subtrees.size());
  std::vector<Vectors> above(m_subtrees.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (long t = 0; t < subtrees; ++t)
  {
    const auto i = static_cast<std::size_t>(t);
    above[i].setZero(size, x.cols());
    forward(m_subtrees[i], column_end(m_subtrees[i]), x, above[i]);
  }
  for (const Vectors& taken : above)
    for (const Range& top : m_top)
    {
      const long first = m_supernodes[top.begin].column, count = column_end(top) - first;
      x.middleRows(first, count) += taken.middleRows(first, count);
    }
  for (const Range& top : m_top)
    forward(top, size, x, x);
  for (std::size_t t = m_top.size(); t-- > 0;)
    backward(m_top[t], x);
#pragma omp parallel for schedule(dynamic, 1)
  for (long t = 0; t < subtrees; ++t)
    backward(m_subtrees[static_cast<std::size_t>(t)], x);
}

Eigen::MatrixXd LightFactor::apply(const Eigen::MatrixXd& b) const
{
  // a preconditioner is linear, so a scale that single precision can hold is free
  const double largest = b.size() ? b.cwiseAbs().maxCoeff() : 0;
  const double scale = largest > 0 ? largest : 1;
  // row-major: a row of all right-hand sides lies together
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> x(b.rows(), b.cols());
  for (long k = 0; k < b.rows(); ++k)
    x.row(k) = (b.row(m_permutation[static_cast<std::size_t>(k)]) / scale).cast<float>();
  if (b.cols() == 1)
  {
    Eigen::VectorXf one = x.col(0);
    apply(one);
    x.col(0) = one;
  }
  else
    apply(x);
  Eigen::MatrixXd solution(b.rows(), b.cols());
  for (long k = 0; k < b.rows(); ++k)
    solution.row(m_permutation[static_cast<std::size_t>(k)]) = scale * x.row(k).cast<double>();
  return solution;
}

} // namespace f2b
