#include "Meshing/tet_star.hpp"

#include "Core/mesh/mesh_quality.hpp"

#include <algorithm>
#include <utility>

namespace f2b
{

namespace
{

/// The tetrahedra at each node, as offsets into one list.
std::pair<std::vector<int>, std::vector<int>> tets_around(const TetrahedralMesh& mesh)
{
  std::vector<int> first(mesh.X.size() + 1, 0);
  for (const Tet& tet : mesh.tets)
    for (const int node : tet)
      ++first[node + 1];
  for (std::size_t i = 1; i < first.size(); ++i)
    first[i] += first[i - 1];
  std::vector<int> around(first.back()), next(first.begin(), first.end() - 1);
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t)
    for (const int node : mesh.tets[t])
      around[next[node]++] = t;
  return {std::move(first), std::move(around)};
}

} // namespace

TetStars::TetStars(TetrahedralMesh& mesh) : m_mesh(mesh)
{
  std::tie(m_first, m_around) = tets_around(mesh);
}

double TetStars::least_angle_deg(int node) const
{
  double least = 180.0;
  for (int i = m_first[node]; i < m_first[node + 1]; ++i)
  {
    const Tet& n = m_mesh.tets[m_around[i]];
    const auto& X = m_mesh.X;
    least = std::min(least, min_dihedral_deg(X[n[0]], X[n[1]], X[n[2]], X[n[3]]));
  }
  return least;
}

bool TetStars::move(int node, const Vec3& position, double least_deg)
{
  const Vec3 before = m_mesh.X[node];
  const double bound = std::min(least_deg, least_angle_deg(node));
  m_mesh.X[node] = position;
  if (least_angle_deg(node) >= bound)
    return true;
  m_mesh.X[node] = before;
  return false;
}

int split_pinched_nodes(TetrahedralMesh& mesh)
{
  const std::vector<int> pinched = non_manifold_nodes(tet_boundary(mesh.tets));
  const auto [first, around] = tets_around(mesh);
  int added = 0;
  for (const int node : pinched)
  {
    std::vector<Tet> star;
    for (int i = first[node]; i < first[node + 1]; ++i)
      star.push_back(mesh.tets[around[i]]);
    // Faces opposite to the node join nothing in its star, so these are the sets at the node.
    const std::vector<int> part = tet_components(star);
    const int parts = *std::max_element(part.begin(), part.end()) + 1;
    for (int p = 1; p < parts; ++p, ++added)
    {
      const int copy = static_cast<int>(mesh.X.size());
      mesh.X.push_back(Vec3(mesh.X[node]));
      for (std::size_t i = 0; i < star.size(); ++i)
      {
        Tet& tet = mesh.tets[around[first[node] + i]];
        if (part[i] == p)
          std::replace(tet.begin(), tet.end(), node, copy);
      }
    }
  }
  return added;
}

int keep_largest_component(TetrahedralMesh& mesh)
{
  const std::vector<int> labels = tet_components(mesh.tets);
  std::vector<int> count(1 + *std::max_element(labels.begin(), labels.end()), 0);
  for (const int label : labels)
    ++count[label];
  const auto largest =
      static_cast<int>(std::max_element(count.begin(), count.end()) - count.begin());
  TetrahedralMesh kept;
  std::vector<int> number(mesh.X.size(), -1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
  {
    if (labels[t] != largest)
      continue;
    Tet tet = mesh.tets[t];
    for (int& node : tet)
    {
      if (number[node] < 0)
      {
        number[node] = static_cast<int>(kept.X.size());
        kept.X.push_back(mesh.X[node]);
      }
      node = number[node];
    }
    kept.tets.push_back(tet);
  }
  const int dropped = static_cast<int>(mesh.tets.size() - kept.tets.size());
  mesh = std::move(kept);
  return dropped;
}

} // namespace f2b
