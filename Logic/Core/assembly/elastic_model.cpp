#include "Core/assembly/elastic_model.hpp"

#include <algorithm>
#include <tuple>

namespace f2b
{
namespace
{

template <class Element, std::size_t N>
typename Element::Positions corner_positions(const std::vector<Vec3>& x,
                                             const std::array<int, N>& corners)
{
  typename Element::Positions p;
  for (std::size_t i = 0; i < N; ++i)
    p.col(static_cast<Eigen::Index>(i)) = x[static_cast<std::size_t>(corners[i])];
  return p;
}

/// A matrix that lies in a vector of numbers.
template <class Matrix>
Eigen::Map<Matrix> matrix_at(std::vector<double>& numbers, std::size_t offset)
{
  return Eigen::Map<Matrix>(numbers.data() + offset);
}

Mat3 spring_positions(const std::vector<Vec3>& x, const std::array<int, 6>& corners)
{
  Mat3 p;
  for (std::size_t i = 0; i < 3; ++i)
    p.col(static_cast<Eigen::Index>(i)) = x[static_cast<std::size_t>(corners[i])];
  return p;
}

} // namespace

ElasticModel::ElasticModel(const Discretization& tissue, const MaterialSet& materials,
                           std::vector<char> prescribed)
    : m_mesh(tissue.mesh()), m_materials(materials)
{
  const MixedMesh& mesh = m_mesh;
  for (const auto& tet : mesh.tets)
    m_tets.push_back(make_tet4(corner_positions<Tet4>(mesh.X, tet)));
  for (const auto& prism : mesh.prisms)
    m_prisms.push_back(make_prism6(corner_positions<Prism6>(mesh.X, prism)));
  // A node that no element uses has no stiffness: it stays where it is.
  std::vector<char> used(mesh.X.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const int node : tet)
      used[static_cast<std::size_t>(node)] = 1;
  for (const auto& prism : mesh.prisms)
    for (const int node : prism)
      used[static_cast<std::size_t>(node)] = 1;
  m_unknown_of_node.assign(mesh.X.size(), -1);
  for (std::size_t node = 0; node < mesh.X.size(); ++node)
    if (!prescribed[node] && used[node])
    {
      m_unknown_of_node[node] = static_cast<int>(m_unknown_nodes.size());
      m_unknown_nodes.push_back(static_cast<int>(node));
    }
  build_pattern();
}

void ElasticModel::set_springs(std::vector<SkinSpring> springs, double stiffness)
{
  m_springs = std::move(springs);
  m_spring_stiffness = stiffness;
}

namespace
{

/// One 3 x 3 block of one element's stiffness, on its way to a node pair.
struct BlockOfPair
{
  int column, row;
  long block; ///< offset of its first entry, times two, plus one for a prism
};

template <std::size_t N>
void list_blocks(const std::vector<std::array<int, N>>& elements,
                 const std::vector<int>& unknown_of_node, long first_offset, bool prism,
                 std::vector<BlockOfPair>& blocks)
{
  const long n = 3 * static_cast<long>(N);
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t b = 0; b < N; ++b)
      for (std::size_t a = 0; a < N; ++a)
      {
        const int row = unknown_of_node[static_cast<std::size_t>(elements[e][a])];
        const int column = unknown_of_node[static_cast<std::size_t>(elements[e][b])];
        if (column < 0 || row < column)
          continue;
        const long offset = first_offset + static_cast<long>(e) * n * n +
                            3 * static_cast<long>(b) * n + 3 * static_cast<long>(a);
        blocks.push_back({column, row, 2 * offset + prism});
      }
}

template <std::size_t N>
void list_slots(const std::vector<std::array<int, N>>& elements,
                const std::vector<int>& unknown_of_node, long first_slot,
                std::vector<std::vector<long>>& slots)
{
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t a = 0; a < N; ++a)
    {
      const int unknown = unknown_of_node[static_cast<std::size_t>(elements[e][a])];
      if (unknown >= 0)
        slots[static_cast<std::size_t>(unknown)].push_back(first_slot +
                                                           static_cast<long>(e * N + a));
    }
}

/// Scalar compressed columns from node pairs sorted by column, then row; a diagonal pair keeps its
/// lower triangle only. Returns where each pair's first scalar column begins.
std::vector<long> scalar_pattern(const std::vector<int>& rows, const std::vector<int>& columns,
                                 long node_count, SymmetricMatrix& matrix)
{
  matrix.size = 3 * node_count;
  matrix.column_start.assign(static_cast<std::size_t>(matrix.size) + 1, 0);
  std::vector<long> first(rows.size());
  std::size_t begin = 0;
  for (int column = 0; column < node_count; ++column)
  {
    std::size_t end = begin;
    while (end < columns.size() && columns[end] == column)
      ++end;
    for (int c = 0; c < 3; ++c)
    {
      for (std::size_t pair = begin; pair < end; ++pair)
      {
        if (c == 0)
          first[pair] = static_cast<long>(matrix.row.size());
        for (int r = pair == begin ? c : 0; r < 3; ++r)
          matrix.row.push_back(3L * rows[pair] + r);
      }
      matrix.column_start[3 * static_cast<std::size_t>(column) + static_cast<std::size_t>(c) + 1] =
          static_cast<long>(matrix.row.size());
    }
    begin = end;
  }
  matrix.value.assign(matrix.row.size(), 0.0);
  return first;
}

} // namespace

void ElasticModel::build_pattern()
{
  const long prism_offset = static_cast<long>(m_tets.size()) * 144;
  m_blocks.resize(static_cast<std::size_t>(prism_offset) + m_prisms.size() * 324);

  std::vector<BlockOfPair> blocks;
  list_blocks(m_mesh.tets, m_unknown_of_node, 0, false, blocks);
  list_blocks(m_mesh.prisms, m_unknown_of_node, prism_offset, true, blocks);
  std::sort(blocks.begin(), blocks.end(),
            [](const BlockOfPair& a, const BlockOfPair& b)
            { return std::tie(a.column, a.row, a.block) < std::tie(b.column, b.row, b.block); });
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (i == 0 || blocks[i].column != blocks[i - 1].column || blocks[i].row != blocks[i - 1].row)
    {
      m_pair_start.push_back(static_cast<long>(i));
      m_pair_row.push_back(blocks[i].row);
      m_pair_column.push_back(blocks[i].column);
    }
    m_pair_blocks.push_back(blocks[i].block);
  }
  m_pair_start.push_back(static_cast<long>(blocks.size()));
  m_pair_value = scalar_pattern(m_pair_row, m_pair_column,
                                static_cast<long>(m_unknown_nodes.size()), m_stiffness);

  std::vector<std::vector<long>> slots(m_unknown_nodes.size());
  list_slots(m_mesh.tets, m_unknown_of_node, 0, slots);
  list_slots(m_mesh.prisms, m_unknown_of_node, 4 * static_cast<long>(m_tets.size()), slots);
  m_node_slot_start.push_back(0);
  for (const auto& of_node : slots)
  {
    m_node_slots.insert(m_node_slots.end(), of_node.begin(), of_node.end());
    m_node_slot_start.push_back(static_cast<long>(m_node_slots.size()));
  }
}

double ElasticModel::energy(const std::vector<Vec3>& x) const
{
  std::vector<double> parts(m_tets.size() + m_prisms.size());
  const long tets = static_cast<long>(m_tets.size()), prisms = static_cast<long>(m_prisms.size());
#pragma omp parallel for schedule(static)
  for (long e = 0; e < tets; ++e)
  {
    const auto i = static_cast<std::size_t>(e);
    const auto p = corner_positions<Tet4>(x, m_mesh.tets[i]);
    parts[i] = std::visit([&](const auto& law) { return element_energy(m_tets[i], p, law); },
                          m_materials.of(m_mesh.tet_tissue[i]));
  }
#pragma omp parallel for schedule(static)
  for (long e = 0; e < prisms; ++e)
  {
    const auto i = static_cast<std::size_t>(e);
    const auto p = corner_positions<Prism6>(x, m_mesh.prisms[i]);
    parts[m_tets.size() + i] =
        std::visit([&](const auto& law) { return element_energy(m_prisms[i], p, law); },
                   m_materials.of(Tissue::Skin));
  }
  double total = 0;
  for (const double part : parts)
    total += part;
  for (const SkinSpring& spring : m_springs)
  {
    const Mat3 p = spring_positions(x, m_mesh.prisms[static_cast<std::size_t>(spring.prism)]);
    total += 0.5 * m_spring_stiffness *
             ((p * spring.mass.topLeftCorner<3, 3>()).cwiseProduct(p).sum() -
              2 * p.cwiseProduct(spring.pull.leftCols<3>()).sum() + spring.offset);
  }
  return total;
}

Eigen::VectorXd ElasticModel::gather_forces(const std::vector<double>& corner_forces) const
{
  Eigen::VectorXd total = Eigen::VectorXd::Zero(unknown_count());
  const long nodes = static_cast<long>(m_unknown_nodes.size());
#pragma omp parallel for schedule(static)
  for (long n = 0; n < nodes; ++n)
    for (long s = m_node_slot_start[static_cast<std::size_t>(n)];
         s < m_node_slot_start[static_cast<std::size_t>(n) + 1]; ++s)
      total.segment<3>(3 * n) += Eigen::Map<const Vec3>(
          &corner_forces[3 * static_cast<std::size_t>(m_node_slots[static_cast<std::size_t>(s)])]);
  return total;
}

namespace
{

/// Adds a spring's pull to its prism's top-corner forces, and its stiffness where one is wanted.
void add_spring(const SkinSpring& spring, double stiffness, const Mat3& positions, double* forces,
                double* blocks)
{
  Eigen::Map<Mat3> top(forces);
  top += stiffness * (positions * spring.mass.topLeftCorner<3, 3>() - spring.pull.leftCols<3>());
  if (!blocks)
    return;
  Eigen::Map<Eigen::Matrix<double, 18, 18>> K(blocks);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      K.block<3, 3>(3 * i, 3 * j).diagonal().array() += stiffness * spring.mass(i, j);
}

} // namespace

Eigen::VectorXd ElasticModel::forces(const std::vector<Vec3>& x) const
{
  const std::size_t tet_slots = 4 * m_tets.size();
  std::vector<double> corner(3 * (tet_slots + 6 * m_prisms.size()));
  const long tets = static_cast<long>(m_tets.size()), prisms = static_cast<long>(m_prisms.size());
#pragma omp parallel for schedule(static)
  for (long e = 0; e < tets; ++e)
  {
    const auto i = static_cast<std::size_t>(e);
    const auto p = corner_positions<Tet4>(x, m_mesh.tets[i]);
    matrix_at<Tet4::Positions>(corner, 12 * i) =
        std::visit([&](const auto& law) { return element_forces(m_tets[i], p, law); },
                   m_materials.of(m_mesh.tet_tissue[i]));
  }
#pragma omp parallel for schedule(static)
  for (long e = 0; e < prisms; ++e)
  {
    const auto i = static_cast<std::size_t>(e);
    const auto p = corner_positions<Prism6>(x, m_mesh.prisms[i]);
    matrix_at<Prism6::Positions>(corner, 3 * tet_slots + 18 * i) =
        std::visit([&](const auto& law) { return element_forces(m_prisms[i], p, law); },
                   m_materials.of(Tissue::Skin));
  }
  for (const SkinSpring& spring : m_springs)
  {
    const auto i = static_cast<std::size_t>(spring.prism);
    add_spring(spring, m_spring_stiffness, spring_positions(x, m_mesh.prisms[i]),
               &corner[3 * tet_slots + 18 * i], nullptr);
  }
  return gather_forces(corner);
}

Eigen::VectorXd ElasticModel::linearize(const std::vector<Vec3>& x)
{
  const std::size_t tet_slots = 4 * m_tets.size();
  const std::size_t prism_offset = 144 * m_tets.size();
  std::vector<double> corner(3 * (tet_slots + 6 * m_prisms.size()));
  const long tets = static_cast<long>(m_tets.size()), prisms = static_cast<long>(m_prisms.size());
#pragma omp parallel for schedule(static)
  for (long e = 0; e < tets; ++e)
  {
    const auto i = static_cast<std::size_t>(e);
    Tet4::Stiffness K;
    const auto p = corner_positions<Tet4>(x, m_mesh.tets[i]);
    matrix_at<Tet4::Positions>(corner, 12 * i) =
        std::visit([&](const auto& law) { return element_forces(m_tets[i], p, law, K); },
                   m_materials.of(m_mesh.tet_tissue[i]));
    matrix_at<Tet4::Stiffness>(m_blocks, 144 * i) = K;
  }
#pragma omp parallel for schedule(static)
  for (long e = 0; e < prisms; ++e)
  {
    const auto i = static_cast<std::size_t>(e);
    Prism6::Stiffness K;
    const auto p = corner_positions<Prism6>(x, m_mesh.prisms[i]);
    matrix_at<Prism6::Positions>(corner, 3 * tet_slots + 18 * i) =
        std::visit([&](const auto& law) { return element_forces(m_prisms[i], p, law, K); },
                   m_materials.of(Tissue::Skin));
    matrix_at<Prism6::Stiffness>(m_blocks, prism_offset + 324 * i) = K;
  }
  for (const SkinSpring& spring : m_springs)
  {
    const auto i = static_cast<std::size_t>(spring.prism);
    add_spring(spring, m_spring_stiffness, spring_positions(x, m_mesh.prisms[i]),
               &corner[3 * tet_slots + 18 * i], &m_blocks[prism_offset + 324 * i]);
  }
  gather_stiffness();
  return gather_forces(corner);
}

void ElasticModel::gather_stiffness()
{
  const long pairs = static_cast<long>(m_pair_row.size());
#pragma omp parallel for schedule(static)
  for (long p = 0; p < pairs; ++p)
  {
    const auto pair = static_cast<std::size_t>(p);
    Mat3 sum = Mat3::Zero();
    for (long i = m_pair_start[pair]; i < m_pair_start[pair + 1]; ++i)
    {
      const long code = m_pair_blocks[static_cast<std::size_t>(i)];
      const int stride = code & 1 ? 18 : 12;
      const double* block = &m_blocks[static_cast<std::size_t>(code >> 1)];
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
          sum(r, c) += block[c * stride + r];
    }
    const int column = m_pair_column[pair];
    const bool diagonal = m_pair_row[pair] == column;
    // a pair sits at the same place in each of its three scalar columns, but for the diagonal
    // pair at their head, which is one entry shorter in each
    long value = m_pair_value[pair];
    for (int c = 0; c < 3; ++c)
    {
      for (int r = diagonal ? c : 0; r < 3; ++r)
        m_stiffness.value[static_cast<std::size_t>(value + r - (diagonal ? c : 0))] = sum(r, c);
      const long column_length =
          m_stiffness.column_start[3 * static_cast<std::size_t>(column) +
                                   static_cast<std::size_t>(c) + 1] -
          m_stiffness
              .column_start[3 * static_cast<std::size_t>(column) + static_cast<std::size_t>(c)];
      value += diagonal ? column_length : column_length - 1;
    }
  }
}

Eigen::VectorXd ElasticModel::coupling(const std::vector<Vec3>& motion) const
{
  const std::size_t tet_slots = 4 * m_tets.size();
  const std::size_t prism_offset = 144 * m_tets.size();
  std::vector<double> corner(3 * (tet_slots + 6 * m_prisms.size()), 0.0);
  auto prescribed_motion = [&](int node)
  { return is_prescribed(node) ? motion[static_cast<std::size_t>(node)] : Vec3(Vec3::Zero()); };
  auto moves = [&](const auto& corners)
  {
    return std::any_of(corners.begin(), corners.end(),
                       [&](int node) { return !prescribed_motion(node).isZero(0); });
  };
  for (std::size_t i = 0; i < m_tets.size(); ++i)
  {
    if (!moves(m_mesh.tets[i]))
      continue;
    Eigen::Matrix<double, 12, 1> u;
    for (int a = 0; a < 4; ++a)
      u.segment<3>(3 * a) = prescribed_motion(m_mesh.tets[i][static_cast<std::size_t>(a)]);
    matrix_at<Eigen::Matrix<double, 12, 1>>(corner, 12 * i) =
        Eigen::Map<const Tet4::Stiffness>(&m_blocks[144 * i]) * u;
  }
  for (std::size_t i = 0; i < m_prisms.size(); ++i)
  {
    if (!moves(m_mesh.prisms[i]))
      continue;
    Eigen::Matrix<double, 18, 1> u;
    for (int a = 0; a < 6; ++a)
      u.segment<3>(3 * a) = prescribed_motion(m_mesh.prisms[i][static_cast<std::size_t>(a)]);
    matrix_at<Eigen::Matrix<double, 18, 1>>(corner, 3 * tet_slots + 18 * i) =
        Eigen::Map<const Prism6::Stiffness>(&m_blocks[prism_offset + 324 * i]) * u;
  }
  return gather_forces(corner);
}

} // namespace f2b
