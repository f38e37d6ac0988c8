#include "Core/solve/cholesky.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <new>

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
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

} // namespace

struct Cholesky::Factor
{
  cholmod_common common;
  cholmod_factor* factor = nullptr;

  Factor()
  {
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
    common.quick_return_if_not_posdef = 1;
    // Wider supernodes than by default: a fifth more entries, but half the time, as today's BLAS
    // is slow on narrow ones (measured on 69k unknowns: 0.73 s -> 0.49 s).
    const std::size_t widths[] = {16, 48, 128};
    const double zeros[] = {0.8, 0.3, 0.1};
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
};

Cholesky::Cholesky() : m_factor(std::make_unique<Factor>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::analyze(const SymmetricMatrix& matrix)
{
  cholmod_sparse view = view_of(matrix);
  cholmod_l_free_factor(&m_factor->factor, &m_factor->common);
  m_factor->factor = cholmod_l_analyze(&view, &m_factor->common);
  m_factor->check_memory();
  assert(m_factor->factor);
}

bool Cholesky::factorize(const SymmetricMatrix& matrix)
{
  cholmod_sparse view = view_of(matrix);
  cholmod_l_factorize(&view, m_factor->factor, &m_factor->common);
  m_factor->check_memory();
  return m_factor->common.status == CHOLMOD_OK &&
         m_factor->factor->minor == static_cast<std::size_t>(matrix.size);
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
  cholmod_dense* x = cholmod_l_solve(CHOLMOD_A, m_factor->factor, &b, &m_factor->common);
  m_factor->check_memory();
  assert(x);
  Eigen::MatrixXd solution = Eigen::Map<Eigen::MatrixXd>(
      static_cast<double*>(x->x), right_hand_sides.rows(), right_hand_sides.cols());
  cholmod_l_free_dense(&x, &m_factor->common);
  return solution;
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
