#include "Core/solve/cholesky.hpp"

#include "Core/solve/light_factor.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <new>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace f2b
{
namespace
{

static_assert(sizeof(SuiteSparse_long) == sizeof(long));

/// CHOLMOD reads the matrix in place and promises not to write to it.
cholmod_sparse view_of(const SymmetricMatrix& matrix)
{
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.size);
  view.nzmax = matrix.row.size();
  view.p = const_cast<long*>(matrix.column_start.data());
  view.i = const_cast<long*>(matrix.row.data());
  view.x = const_cast<double*>(matrix.value.data());
  view.stype = -1;
  view.itype = CHOLMOD_LONG;
  view.xtype = matrix.value.empty() ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

/// The pattern of blocks: of each block its first column, and of that each first row.
SymmetricMatrix pattern_of_blocks(const SymmetricMatrix& matrix, int block)
{
  SymmetricMatrix blocks;
  blocks.size = matrix.size / block;
  blocks.column_start.push_back(0);
  for (long c = 0; c < blocks.size; ++c)
  {
    const auto column = static_cast<std::size_t>(block * c);
    for (long i = matrix.column_start[column]; i < matrix.column_start[column + 1]; ++i)
      if (const long row = matrix.row[static_cast<std::size_t>(i)]; row % block == 0)
        blocks.row.push_back(row / block);
    blocks.column_start.push_back(static_cast<long>(blocks.row.size()));
  }
  return blocks;
}

/// CHOLMOD opens four OpenMP threads whatever the machine and waits for them in a loop, which
/// takes the cores from the BLAS: with one thread the factorisation takes two thirds of the time.
class OneOpenMpThread
{
public:
  OneOpenMpThread() { omp_set_max_active_levels(0); }
  ~OneOpenMpThread() { omp_set_max_active_levels(m_levels); }
  OneOpenMpThread(const OneOpenMpThread&) = delete;
  OneOpenMpThread& operator=(const OneOpenMpThread&) = delete;

private:
  int m_levels = omp_get_max_active_levels();
};

} // namespace

struct Cholesky::Factor
{
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  SymmetricMatrix permuted; ///< the matrix in the factor's order
  std::vector<long> source; ///< where in the matrix each of its entries is
  std::optional<LightFactor> light;
  bool light_is_current = false; ///< it holds the last factorisation's numbers

  Factor()
  {
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
    common.quick_return_if_not_posdef = 1;
    // Wider supernodes than by default, as today's BLAS is slow on narrow ones: a third more
    // entries, but half the time.
    const std::size_t widths[] = {24, 64, 160};
    const double zeros[] = {0.8, 0.1, 0.05};
    std::copy(std::begin(widths), std::end(widths), std::begin(common.nrelax));
    std::copy(std::begin(zeros), std::end(zeros), std::begin(common.zrelax));
  }
  ~Factor()
  {
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_finish(&common);
  }
  void check_memory() const
  {
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
  }
  std::vector<long> order(const SymmetricMatrix& matrix, int block);
  void permute_pattern(const SymmetricMatrix& matrix);
};

/// METIS on the graph of the blocks: less work, and better orders, than on that of all rows.
std::vector<long> Cholesky::Factor::order(const SymmetricMatrix& matrix, int block)
{
  const SymmetricMatrix blocks = pattern_of_blocks(matrix, block);
  cholmod_sparse view = view_of(blocks);
  std::vector<long> block_order(static_cast<std::size_t>(blocks.size));
  cholmod_l_metis(&view, nullptr, 0, 0, block_order.data(), &common);
  check_memory();
  std::vector<long> rows;
  rows.reserve(static_cast<std::size_t>(matrix.size));
  for (const long b : block_order)
    for (int i = 0; i < block; ++i)
      rows.push_back(block * b + i);
  return rows;
}

/// So that every factorisation only has to fetch its values.
void Cholesky::Factor::permute_pattern(const SymmetricMatrix& matrix)
{
  const auto size = static_cast<std::size_t>(matrix.size);
  const long* permutation = static_cast<const long*>(factor->Perm);
  std::vector<long> place(size);
  for (std::size_t k = 0; k < size; ++k)
    place[static_cast<std::size_t>(permutation[k])] = static_cast<long>(k);
  const auto for_each_entry = [&](const auto& visit)
  {
    for (std::size_t c = 0; c < size; ++c)
      for (long i = matrix.column_start[c]; i < matrix.column_start[c + 1]; ++i)
      {
        const auto [column, row] = std::minmax(
            place[c], place[static_cast<std::size_t>(matrix.row[static_cast<std::size_t>(i)])]);
        visit(static_cast<std::size_t>(column), row, i);
      }
  };
  permuted.size = matrix.size;
  permuted.column_start.assign(size + 1, 0);
  for_each_entry([&](std::size_t column, long, long) { ++permuted.column_start[column + 1]; });
  std::partial_sum(permuted.column_start.begin(), permuted.column_start.end(),
                   permuted.column_start.begin());
  std::vector<std::pair<long, long>> entries(matrix.row.size()); // row, source
  std::vector<long> next(permuted.column_start.begin(), permuted.column_start.end() - 1);
  for_each_entry(
      [&](std::size_t column, long row, long i) {
        entries[static_cast<std::size_t>(next[column]++)] = {row, i};
      });
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t c = 0; c < size; ++c)
    std::sort(entries.begin() + permuted.column_start[c],
              entries.begin() + permuted.column_start[c + 1]);
  permuted.row.resize(entries.size());
  permuted.value.resize(entries.size());
  source.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    std::tie(permuted.row[i], source[i]) = entries[i];
}

Cholesky::Cholesky() : m_factor(std::make_unique<Factor>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::analyze(const SymmetricMatrix& matrix, int block)
{
  assert(matrix.size % block == 0);
  Factor& f = *m_factor;
  std::vector<long> order = f.order(matrix, block);
  cholmod_sparse view = view_of(matrix);
  cholmod_l_free_factor(&f.factor, &f.common);
  f.factor = cholmod_l_analyze_p(&view, order.data(), nullptr, 0, &f.common);
  f.check_memory();
  assert(f.factor);
  f.permute_pattern(matrix);
  f.light.reset();
}

bool Cholesky::factorize(const SymmetricMatrix& matrix)
{
  Factor& f = *m_factor;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < f.source.size(); ++i)
    f.permuted.value[i] = matrix.value[static_cast<std::size_t>(f.source[i])];
  cholmod_sparse view = view_of(f.permuted);
  f.light_is_current = false;
  double shift[] = {0, 0};
  const OneOpenMpThread one;
  cholmod_l_super_numeric(&view, nullptr, shift, f.factor, &f.common);
  f.check_memory();
  return f.common.status == CHOLMOD_OK && f.factor->minor == static_cast<std::size_t>(matrix.size);
}

Eigen::MatrixXd Cholesky::solve(const Eigen::MatrixXd& right_hand_sides) const
{
  cholmod_dense b{};
  b.nrow = static_cast<std::size_t>(right_hand_sides.rows());
  b.ncol = static_cast<std::size_t>(right_hand_sides.cols());
  b.nzmax = b.nrow * b.ncol;
  b.d = b.nrow;
  b.x = const_cast<double*>(right_hand_sides.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const OneOpenMpThread one;
  cholmod_dense* x = cholmod_l_solve(CHOLMOD_A, m_factor->factor, &b, &m_factor->common);
  m_factor->check_memory();
  assert(x);
  Eigen::MatrixXd solution = Eigen::Map<Eigen::MatrixXd>(
      static_cast<double*>(x->x), right_hand_sides.rows(), right_hand_sides.cols());
  cholmod_l_free_dense(&x, &m_factor->common);
  return solution;
}

Eigen::MatrixXd Cholesky::precondition(const Eigen::MatrixXd& right_hand_sides)
{
  Factor& f = *m_factor;
  assert(f.factor->is_super && f.factor->xtype == CHOLMOD_REAL);
  if (!f.light)
    f.light.emplace(SupernodalFactor{
        static_cast<long>(f.factor->n), static_cast<long>(f.factor->nsuper),
        static_cast<const long*>(f.factor->super), static_cast<const long*>(f.factor->pi),
        static_cast<const long*>(f.factor->px), static_cast<const long*>(f.factor->s),
        static_cast<const long*>(f.factor->Perm)});
  if (!f.light_is_current)
    f.light->copy(static_cast<const double*>(f.factor->x));
  f.light_is_current = true;
  return f.light->apply(right_hand_sides);
}

double Cholesky::flops() const
{
  return m_factor->common.fl;
}

double Cholesky::entries() const
{
  return m_factor->common.lnz;
}

double Cholesky::peak_bytes() const
{
  return static_cast<double>(m_factor->common.memory_usage);
}

} // namespace f2b
