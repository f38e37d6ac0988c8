#include "Core/assembly/gather.hpp"

#include <numeric>

namespace f2b
{
namespace
{

std::size_t index(int i)
{
  return static_cast<std::size_t>(i);
}

/// Calls visit(column, row, code) for each block of the lower triangle that two unknowns share.
template <class Visit>
void for_each_block(const std::vector<Clique>& cliques, const std::vector<int>& unknown,
                    std::uint32_t& block, const Visit& visit)
{
  for (const Clique& clique : cliques)
    for (int b = 0; b < clique.count; ++b)
      for (int a = b; a < clique.count; ++a, ++block)
      {
        const int row = unknown[index(clique.controls[a])];
        const int column = unknown[index(clique.controls[b])];
        if (row < 0 || column < 0)
          continue;
        if (row >= column)
          visit(column, row, 2 * block);
        else
          visit(row, column, 2 * block + 1);
      }
}

/// Turns counts in entries 1, 2, ... into where each run begins.
template <class Number>
void accumulate(std::vector<Number>& counts)
{
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

} // namespace

Gather::Gather(const std::vector<Clique>& elements, const std::vector<Clique>& patches,
               const std::vector<int>& unknown_of_control, long unknown_count)
    : m_unknowns(unknown_count)
{
  collect_slots(elements, unknown_of_control);
  collect_products(patches);
  collect_pairs(elements, patches, unknown_of_control);
}

void Gather::collect_slots(const std::vector<Clique>& elements, const std::vector<int>& unknown)
{
  m_slot_start.assign(static_cast<std::size_t>(m_unknowns) + 1, 0);
  for (const Clique& clique : elements)
    for (int i = 0; i < clique.count; ++i)
      if (const int u = unknown[index(clique.controls[i])]; u >= 0)
        ++m_slot_start[index(u) + 1];
  accumulate(m_slot_start);
  m_slots.resize(m_slot_start.back());
  std::vector<std::uint32_t> next(m_slot_start.begin(), m_slot_start.end() - 1);
  std::uint32_t slot = 0;
  for (const Clique& clique : elements)
    for (int i = 0; i < clique.count; ++i, ++slot)
      if (const int u = unknown[index(clique.controls[i])]; u >= 0)
        m_slots[next[index(u)]++] = slot;
}

void Gather::collect_products(const std::vector<Clique>& patches)
{
  std::uint32_t first = 0;
  for (const Clique& clique : patches)
  {
    const auto n = static_cast<std::uint32_t>(clique.count);
    for (std::uint32_t b = 0; b < n; ++b)
      for (std::uint32_t a = b; a < n; ++a)
        m_products.push_back({first + a, first + b});
    first += n;
  }
}

/// Blocks are sorted into their columns by counting, then by row inside each column.
void Gather::collect_pairs(const std::vector<Clique>& elements, const std::vector<Clique>& patches,
                           const std::vector<int>& unknown)
{
  auto for_all = [&](const auto& visit)
  {
    std::uint32_t block = 0;
    for_each_block(elements, unknown, block, visit);
    m_element_blocks = block;
    for_each_block(patches, unknown, block, visit);
  };
  const auto unknowns = static_cast<std::size_t>(m_unknowns);
  std::vector<std::uint32_t> start(unknowns + 1, 0);
  for_all([&](int column, int, std::uint32_t) { ++start[index(column) + 1]; });
  accumulate(start);
  std::vector<std::uint64_t> keys(start.back()); // row, then code
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for_all([&](int column, int row, std::uint32_t code)
          { keys[next[index(column)]++] = static_cast<std::uint64_t>(row) << 32 | code; });

  m_column_start.assign(unknowns + 1, 0);
#pragma omp parallel for schedule(dynamic, 256)
  for (long c = 0; c < m_unknowns; ++c)
  {
    const auto column = static_cast<std::size_t>(c);
    std::sort(keys.begin() + start[column], keys.begin() + start[column + 1]);
    for (std::size_t i = start[column]; i < start[column + 1]; ++i)
      m_column_start[column + 1] += i == start[column] || keys[i] >> 32 != keys[i - 1] >> 32;
  }
  accumulate(m_column_start);

  m_codes.resize(keys.size());
  m_row.reserve(index(m_column_start.back()));
  m_pair_start.reserve(index(m_column_start.back()) + 1);
  for (std::size_t column = 0; column < unknowns; ++column)
    for (std::size_t i = start[column]; i < start[column + 1]; ++i)
    {
      m_codes[i] = static_cast<std::uint32_t>(keys[i]);
      if (i > start[column] && keys[i] >> 32 == keys[i - 1] >> 32)
        continue;
      m_row.push_back(static_cast<int>(keys[i] >> 32));
      m_pair_start.push_back(static_cast<std::uint32_t>(i));
    }
  m_pair_start.push_back(start.back());
}

SymmetricMatrix Gather::empty_matrix() const
{
  SymmetricMatrix matrix;
  matrix.size = 3 * m_unknowns;
  matrix.column_start.push_back(0);
  matrix.row.reserve(9 * m_row.size()); // three more than needed per diagonal pair
  for (long u = 0; u < m_unknowns; ++u)
    for (int c = 0; c < 3; ++c)
    {
      const int begin = m_column_start[static_cast<std::size_t>(u)];
      for (int p = begin; p < m_column_start[static_cast<std::size_t>(u) + 1]; ++p)
        for (int r = p == begin ? c : 0; r < 3; ++r)
          matrix.row.push_back(3L * m_row[index(p)] + r);
      matrix.column_start.push_back(static_cast<long>(matrix.row.size()));
    }
  matrix.value.assign(matrix.row.size(), 0.0);
  return matrix;
}

Eigen::VectorXd Gather::forces(const std::vector<double>& slots) const
{
  Eigen::VectorXd total = Eigen::VectorXd::Zero(3 * m_unknowns);
#pragma omp parallel for schedule(static)
  for (long u = 0; u < m_unknowns; ++u)
    for (std::size_t s = m_slot_start[static_cast<std::size_t>(u)];
         s < m_slot_start[static_cast<std::size_t>(u) + 1]; ++s)
      total.segment<3>(3 * u) +=
          Eigen::Map<const Vec3>(&slots[3 * static_cast<std::size_t>(m_slots[s])]);
  return total;
}

Mat3 Gather::pair_sum(std::size_t pair, const double* blocks, const PatchStiffness& patches) const
{
  // blocks of a pair lie far apart: ask for those of the pairs to come while adding these
  constexpr std::size_t ahead = 12;
  Mat3 sum = Mat3::Zero();
  for (std::size_t i = m_pair_start[pair]; i < m_pair_start[pair + 1]; ++i)
  {
    if (i + ahead < m_codes.size())
      if (const std::size_t next = m_codes[i + ahead] / 2; next < m_element_blocks)
      {
        __builtin_prefetch(blocks + 9 * next);
        __builtin_prefetch(blocks + 9 * next + 8);
      }
    const std::size_t block = m_codes[i] / 2;
    const bool transposed = m_codes[i] % 2;
    if (block >= m_element_blocks)
    {
      const SlotPair slots = m_products[block - m_element_blocks];
      const auto a = transposed ? slots.b : slots.a, b = transposed ? slots.a : slots.b;
      sum += patches.scaled[a] * patches.slope[b].transpose();
      continue;
    }
    const Eigen::Map<const Mat3> K(blocks + 9 * block);
    if (transposed)
      sum += K.transpose();
    else
      sum += K;
  }
  return sum;
}

/// A pair lies at the same place in each of its three scalar columns, but for the diagonal pair at
/// their heads, which loses one entry from column to column.
void Gather::stiffness(const std::vector<double>& blocks, const PatchStiffness& patches,
                       SymmetricMatrix& matrix) const
{
#pragma omp parallel for schedule(static)
  for (long u = 0; u < m_unknowns; ++u)
  {
    double* columns[3];
    for (int c = 0; c < 3; ++c)
      columns[c] = matrix.value.data() + matrix.column_start[static_cast<std::size_t>(3 * u + c)];
    const int begin = m_column_start[static_cast<std::size_t>(u)];
    for (int p = begin; p < m_column_start[static_cast<std::size_t>(u) + 1]; ++p)
    {
      const Mat3 sum = pair_sum(index(p), blocks.data(), patches);
      for (int c = 0; c < 3; ++c)
        for (int r = p == begin ? c : 0; r < 3; ++r)
          *columns[c]++ = sum(r, c);
    }
  }
}

} // namespace f2b
