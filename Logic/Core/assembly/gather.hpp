#pragma once

#include "Core/assembly/element_loops.hpp"
#include "Core/solve/cholesky.hpp"

#include <cstdint>

/// Where do the forces and stiffness blocks of elements go in the system of the unknowns?
namespace f2b
{

/// Control vectors that are coupled with one another: an element's or a patch's.
struct Clique
{
  const int* controls = nullptr;
  int count = 0;
};

/// Sums of element results per unknown and per pair of unknowns.
///
/// Every sum has one owner and a fixed order, so that results do not depend on the number of
/// threads. Slots and blocks are numbered clique by clique in the order of the constructor.
class Gather
{
public:
  Gather() = default;
  /// \param unknown_of_control  number of a control vector among the unknown ones, or -1
  /// \param unknown_count       of unknown control vectors
  Gather(const std::vector<Clique>& elements, const std::vector<Clique>& patches,
         const std::vector<int>& unknown_of_control, long unknown_count);

  /// Lower triangle of the system, with the pattern of all pairs and zero values.
  SymmetricMatrix empty_matrix() const;
  /// \param slots  3 numbers per slot of the elements
  Eigen::VectorXd forces(const std::vector<double>& slots) const;
  /// \param blocks  9 numbers per block of the elements, see `block_index`
  void stiffness(const std::vector<double>& blocks, const PatchStiffness& patches,
                 SymmetricMatrix& matrix) const;

private:
  /// A pair of a patch's slots: its block is the product of their vectors.
  struct SlotPair
  {
    std::uint32_t a, b;
  };
  void collect_slots(const std::vector<Clique>& elements, const std::vector<int>& unknown);
  void collect_products(const std::vector<Clique>& patches);
  void collect_pairs(const std::vector<Clique>& elements, const std::vector<Clique>& patches,
                     const std::vector<int>& unknown);
  Mat3 pair_sum(std::size_t pair, const double* blocks, const PatchStiffness& patches) const;

  long m_unknowns = 0;
  std::vector<std::uint32_t> m_slot_start; ///< per unknown, into m_slots
  std::vector<std::uint32_t> m_slots;
  std::vector<int> m_column_start;         ///< per unknown, into the pairs: diagonal pair first
  std::vector<int> m_row;                  ///< per pair, ascending in a column
  std::vector<std::uint32_t> m_pair_start; ///< per pair, into m_codes
  std::vector<std::uint32_t> m_codes;      ///< twice the number of a block, plus 1 if transposed
  std::size_t m_element_blocks = 0;        ///< blocks from here on are products
  std::vector<SlotPair> m_products;
};

} // namespace f2b
