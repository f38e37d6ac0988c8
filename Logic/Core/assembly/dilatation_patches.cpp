#include "Core/assembly/dilatation_patches.hpp"

#include <algorithm>
#include <deque>

namespace f2b
{
namespace
{

/// For every tetrahedron, the one across each of its faces, or -1.
std::vector<std::array<int, 4>> face_neighbours(const std::vector<Tet>& tets)
{
  std::vector<std::array<int, 4>> neighbours(tets.size(), {-1, -1, -1, -1});
  const std::vector<TetFace> faces = sorted_tet_faces(tets);
  auto side = [&](const TetFace& face) -> int& {
    return neighbours[static_cast<std::size_t>(face.tet)][static_cast<std::size_t>(face.opposite)];
  };
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].key == faces[i - 1].key)
    {
      side(faces[i]) = faces[i - 1].tet;
      side(faces[i - 1]) = faces[i].tet;
    }
  return neighbours;
}

class Growth
{
public:
  Growth(const std::vector<Tet>& tets, int size)
      : m_tets(tets), m_neighbours(face_neighbours(tets)), m_size(size), m_patch(tets.size(), -1)
  {
    for (int t = 0; t < static_cast<int>(tets.size()); ++t)
      m_seeds[free_neighbours(t)].push_back(t);
    for (int seed = next_seed(); seed >= 0; seed = next_seed())
      grow(seed);
    merge_small();
  }
  DilatationPatches patches() const;

private:
  std::size_t free_neighbours(int tet) const;
  int next_seed();
  void grow(int seed);
  int best_candidate(const std::vector<int>& members, const std::vector<int>& nodes) const;
  void take(int tet, std::vector<int>& members, std::vector<int>& nodes);
  void merge_small();
  bool join_neighbour(int tet);

  const std::array<int, 4>& neighbours(int tet) const
  {
    return m_neighbours[static_cast<std::size_t>(tet)];
  }
  const Tet& nodes_of(int tet) const { return m_tets[static_cast<std::size_t>(tet)]; }
  int& patch_of(int tet) { return m_patch[static_cast<std::size_t>(tet)]; }
  int patch_of(int tet) const { return m_patch[static_cast<std::size_t>(tet)]; }
  int& members_of(int patch) { return m_members[static_cast<std::size_t>(patch)]; }

  const std::vector<Tet>& m_tets;
  std::vector<std::array<int, 4>> m_neighbours;
  int m_size;
  std::vector<int> m_patch;               ///< per tetrahedron
  std::vector<int> m_members;             ///< number of tetrahedra, per patch
  std::array<std::deque<int>, 5> m_seeds; ///< by number of free neighbours, some out of date
};

std::size_t Growth::free_neighbours(int tet) const
{
  std::size_t count = 0;
  for (const int n : neighbours(tet))
    count += n >= 0 && patch_of(n) < 0;
  return count;
}

/// The free tetrahedron that is nearest to being cut off: starting there leaves fewer crumbs.
int Growth::next_seed()
{
  for (std::size_t free = 0; free < m_seeds.size(); ++free)
    while (!m_seeds[free].empty())
    {
      const int tet = m_seeds[free].front();
      m_seeds[free].pop_front();
      if (patch_of(tet) < 0 && free_neighbours(tet) == free)
        return tet;
    }
  return -1;
}

void Growth::take(int tet, std::vector<int>& members, std::vector<int>& nodes)
{
  patch_of(tet) = static_cast<int>(m_members.size()) - 1;
  ++m_members.back();
  members.push_back(tet);
  for (const int node : nodes_of(tet))
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
      nodes.push_back(node);
}

void Growth::grow(int seed)
{
  m_members.push_back(0);
  std::vector<int> members, nodes;
  for (int tet = seed; tet >= 0; tet = best_candidate(members, nodes))
  {
    take(tet, members, nodes);
    if (static_cast<int>(members.size()) == m_size)
      break;
  }
  for (const int member : members)
    for (const int n : neighbours(member))
      if (n >= 0 && patch_of(n) < 0)
        m_seeds[free_neighbours(n)].push_back(n);
}

/// The free neighbour with the fewest new nodes, then the most faces on the patch, then the fewest
/// free neighbours of its own.
int Growth::best_candidate(const std::vector<int>& members, const std::vector<int>& nodes) const
{
  int best = -1;
  std::array<int, 3> best_rank{};
  for (const int member : members)
    for (const int tet : neighbours(member))
    {
      if (tet < 0 || patch_of(tet) >= 0)
        continue;
      std::array<int, 3> rank{0, 0, static_cast<int>(free_neighbours(tet))};
      for (const int node : nodes_of(tet))
        rank[0] += std::find(nodes.begin(), nodes.end(), node) == nodes.end();
      for (const int n : neighbours(tet))
        rank[1] -= std::find(members.begin(), members.end(), n) != members.end();
      if (best < 0 || rank < best_rank)
      {
        best = tet;
        best_rank = rank;
      }
    }
  return best;
}

/// Moves a tetrahedron of a small patch into the smallest neighbour that is not small.
bool Growth::join_neighbour(int tet)
{
  int best = -1;
  for (const int n : neighbours(tet))
    if (n >= 0 && 2 * members_of(patch_of(n)) >= m_size &&
        (best < 0 || members_of(patch_of(n)) < members_of(best)))
      best = patch_of(n);
  if (best < 0)
    return false;
  --members_of(patch_of(tet));
  patch_of(tet) = best;
  ++members_of(best);
  return true;
}

/// A whole piece that is small, such as a tissue of one tetrahedron, stays as it is.
void Growth::merge_small()
{
  std::vector<int> crumbs;
  for (int t = 0; t < static_cast<int>(m_tets.size()); ++t)
    if (2 * members_of(patch_of(t)) < m_size)
      crumbs.push_back(t);
  for (bool changed = true; changed;)
  {
    std::vector<int> left;
    for (const int tet : crumbs)
      if (!join_neighbour(tet))
        left.push_back(tet);
    changed = left.size() < crumbs.size();
    crumbs = std::move(left);
  }
}

/// Numbered by their first tetrahedron, so that patches lie as their tetrahedra do.
DilatationPatches Growth::patches() const
{
  DilatationPatches result;
  std::vector<int> number(m_members.size(), -1);
  result.start.push_back(0);
  for (const int p : m_patch)
    if (number[static_cast<std::size_t>(p)] < 0)
    {
      number[static_cast<std::size_t>(p)] = result.count();
      result.start.push_back(result.start.back() + m_members[static_cast<std::size_t>(p)]);
    }
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  result.tets.resize(m_tets.size());
  for (std::size_t t = 0; t < m_tets.size(); ++t)
  {
    int& place = next[static_cast<std::size_t>(number[static_cast<std::size_t>(m_patch[t])])];
    result.tets[static_cast<std::size_t>(place++)] = static_cast<int>(t);
  }
  return result;
}

} // namespace

DilatationPatches make_dilatation_patches(const std::vector<Tet>& tets, int size)
{
  return Growth(tets, size).patches();
}

} // namespace f2b
