#pragma once

#include <Eigen/Core>

#include <vector>

/// How is a Cholesky factor applied quickly where seven digits are enough?
namespace f2b
{

/// The structure of a supernodal factor L of P A P^T = L L^T, as CHOLMOD keeps it. Columns of one
/// supernode have the same rows below them; a supernode's block is dense, columns one after the
/// other. Supernodes are in postorder.
struct SupernodalFactor
{
  long size = 0, supernodes = 0;
  const long* first_column = nullptr; ///< per supernode and one past the last
  const long* first_row = nullptr;    ///< per supernode and one past the last, into `row`
  const long* first_value = nullptr;  ///< per supernode, into the factor's numbers
  const long* row = nullptr;          ///< the supernode's own columns first, then those below
  const long* permutation = nullptr;  ///< column k of L is column permutation[k] of A
};

/// A copy of a factor in single precision, to precondition with.
///
/// Applying a factor is as slow as memory: half the bytes are half the time. Subtrees of the
/// elimination tree that do not meet are done in parallel; which ones depends on the factor only,
/// so results are the same bit for bit for every number of threads.
class LightFactor
{
public:
  /// Without numbers; the structure outlives it.
  explicit LightFactor(const SupernodalFactor& factor);

  /// \param values  of the factor
  void copy(const double* values);
  /// About A^-1 b, one right-hand side per column.
  Eigen::MatrixXd apply(const Eigen::MatrixXd& right_hand_sides) const;

private:
  struct Supernode
  {
    long column, columns, rows; ///< rows: all of the block
    std::size_t value, row;
    long source; ///< where its block is in the factor
  };
  struct Range
  {
    std::size_t begin, end; ///< supernodes
  };

  void choose_subtrees();
  template <class Vectors>
  void apply(Vectors& x) const;
  template <class Vectors>
  void forward(const Range& range, long end_column, Vectors& own, Vectors& above) const;
  template <class Vectors>
  void backward(const Range& range, Vectors& x) const;
  long column_end(const Range& range) const;

  std::vector<Supernode> m_supernodes;
  long m_tallest = 0; ///< most rows below a supernode
  std::vector<int> m_rows;
  std::vector<float> m_values;
  std::vector<long> m_permutation;
  std::vector<Range> m_subtrees; ///< disjoint, in order
  std::vector<Range> m_top;      ///< what is in no subtree, in order
};

} // namespace f2b
