#include "Core/mesh/split_prisms.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace f2b
{

PrismCut cut_by_node_number(const std::array<int, 6>& p)
{
  PrismCut cut{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    cut[i] = std::min(p[i], p[j + 3]) < std::min(p[j], p[i + 3]);
  }
  return cut;
}

std::array<std::array<int, 4>, 3> split_prism(const std::array<int, 6>& prism, const PrismCut& cut)
{
  // a: the top corner from which both its quads are cut; there is one
  std::size_t i = 0;
  while (!cut[i] || cut[(i + 2) % 3])
    ++i;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const int a = prism[i], b = prism[j], c = prism[k];
  const int d = prism[i + 3], e = prism[j + 3], f = prism[k + 3];
  if (cut[j])
    return {{{a, c, b, f}, {a, b, e, f}, {a, e, d, f}}};
  return {{{a, c, b, e}, {a, c, e, f}, {a, e, d, f}}};
}

namespace
{

/// The cuts of all prisms; a quad that two prisms share has one diagonal.
class SkinCuts
{
public:
  explicit SkinCuts(const MixedMesh& mesh);

  /// Cuts prisms with a bad tetrahedron otherwise, where that helps.
  void mend();
  PrismCut of(std::size_t prism) const;
  /// Smallest tetrahedron of a prism relative to their mean; -infinity for a cyclic cut.
  double quality(std::size_t prism) const;

private:
  struct Quad
  {
    std::vector<std::size_t> prisms;
    int start = -1; ///< top node that the diagonal starts at
  };

  bool settle(std::size_t prism, double enough, int depth);
  bool settle_neighbours(std::size_t prism, double enough, int depth);
  bool try_cut(std::size_t prism, const PrismCut& cut);
  void undo(std::size_t quads_done, std::size_t prisms_done);

  const MixedMesh& m_mesh;
  std::vector<Quad> m_quads;
  std::vector<std::array<std::size_t, 3>> m_quads_of_prism;
  // of the search that runs
  std::vector<char> m_settled;                     ///< per prism: its quads stay as they are
  std::vector<std::size_t> m_settled_in_order;     ///< those prisms
  std::vector<std::pair<std::size_t, int>> m_done; ///< quads that were changed, and their starts
};

SkinCuts::SkinCuts(const MixedMesh& mesh)
    : m_mesh(mesh), m_quads_of_prism(mesh.prisms.size()), m_settled(mesh.prisms.size(), 0)
{
  std::map<std::pair<int, int>, std::size_t> quad_of_edge;
  for (std::size_t p = 0; p < mesh.prisms.size(); ++p)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int one = mesh.prisms[p][i], other = mesh.prisms[p][(i + 1) % 3];
      const auto [place, is_new] =
          quad_of_edge.insert({{std::min(one, other), std::max(one, other)}, m_quads.size()});
      if (is_new)
        m_quads.emplace_back();
      m_quads[place->second].prisms.push_back(p);
      m_quads_of_prism[p][i] = place->second;
    }
    try_cut(p, cut_by_node_number(mesh.prisms[p]));
  }
}

/// Cuts a prism; false, with some of it done, if that would change the cut of a settled one.
bool SkinCuts::try_cut(std::size_t prism, const PrismCut& cut)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t q = m_quads_of_prism[prism][i];
    const int start = m_mesh.prisms[prism][cut[i] ? i : (i + 1) % 3];
    if (m_quads[q].start == start)
      continue;
    for (const std::size_t neighbour : m_quads[q].prisms)
      if (neighbour != prism && m_settled[neighbour])
        return false;
    m_done.emplace_back(q, m_quads[q].start);
    m_quads[q].start = start;
  }
  return true;
}

void SkinCuts::undo(std::size_t quads_done, std::size_t prisms_done)
{
  for (; m_done.size() > quads_done; m_done.pop_back())
    m_quads[m_done.back().first].start = m_done.back().second;
  for (; m_settled_in_order.size() > prisms_done; m_settled_in_order.pop_back())
    m_settled[m_settled_in_order.back()] = 0;
}

PrismCut SkinCuts::of(std::size_t prism) const
{
  PrismCut cut{};
  for (std::size_t i = 0; i < 3; ++i)
    cut[i] = m_quads[m_quads_of_prism[prism][i]].start == m_mesh.prisms[prism][i];
  return cut;
}

double SkinCuts::quality(std::size_t prism) const
{
  const PrismCut cut = of(prism);
  if (cut[0] == cut[1] && cut[1] == cut[2])
    return -std::numeric_limits<double>::infinity();
  double smallest = std::numeric_limits<double>::infinity(), total = 0;
  for (const auto& tet : split_prism(m_mesh.prisms[prism], cut))
  {
    auto X = [&](std::size_t i) -> const Vec3&
    { return m_mesh.X[static_cast<std::size_t>(tet[i])]; };
    const double volume = tet_volume6(X(0), X(1), X(2), X(3));
    smallest = std::min(smallest, volume);
    total += volume;
  }
  return 3 * smallest / std::abs(total);
}

/// Finds a good cut of a prism for which its neighbours, and theirs, have good ones too. Fewest
/// changes first.
bool SkinCuts::settle(std::size_t prism, double enough, int depth)
{
  const PrismCut before = of(prism);
  std::vector<std::pair<int, PrismCut>> cuts;
  for (unsigned pattern = 1; pattern < 7; ++pattern)
  {
    const PrismCut cut = {(pattern & 1) != 0, (pattern & 2) != 0, (pattern & 4) != 0};
    cuts.emplace_back((cut[0] != before[0]) + (cut[1] != before[1]) + (cut[2] != before[2]), cut);
  }
  std::sort(cuts.begin(), cuts.end());
  const std::size_t quads_done = m_done.size(), prisms_done = m_settled_in_order.size();
  for (const auto& [changes, cut] : cuts)
  {
    m_settled[prism] = 1;
    m_settled_in_order.push_back(prism);
    if (try_cut(prism, cut) && quality(prism) > enough && settle_neighbours(prism, enough, depth))
      return true;
    undo(quads_done, prisms_done);
  }
  return false;
}

bool SkinCuts::settle_neighbours(std::size_t prism, double enough, int depth)
{
  for (const std::size_t quad : m_quads_of_prism[prism])
    for (const std::size_t neighbour : m_quads[quad].prisms)
      if (!m_settled[neighbour] && !(quality(neighbour) > enough) &&
          (depth == 0 || !settle(neighbour, enough, depth - 1)))
        return false;
  return true;
}

void SkinCuts::mend()
{
  for (const double enough : {0.05, 0.0})
    for (std::size_t p = 0; p < m_quads_of_prism.size(); ++p)
      if (!(quality(p) > enough))
      {
        settle(p, enough, 8);
        m_done.clear();
        undo(0, 0); // nothing is settled for the next
      }
}

[[noreturn]] void refuse(const MixedMesh& mesh, const std::array<int, 6>& prism)
{
  const Vec3& at = mesh.X[static_cast<std::size_t>(prism[0])];
  throw Error("mesh",
              "the skin prism at RAS (" + std::to_string(at.x()) + ", " + std::to_string(at.y()) +
                  ", " + std::to_string(at.z()) +
                  ") is too warped to be split into three tetrahedra",
              "use the model nfm-em, or mesh at another density");
}

} // namespace

MixedMesh split_prisms(const MixedMesh& mesh)
{
  SkinCuts cuts(mesh);
  cuts.mend();
  MixedMesh split = mesh;
  split.prisms.clear();
  split.tets.reserve(mesh.tets.size() + 3 * mesh.prisms.size());
  for (std::size_t p = 0; p < mesh.prisms.size(); ++p)
  {
    if (!(cuts.quality(p) > 0))
      refuse(mesh, mesh.prisms[p]);
    for (const auto& tet : split_prism(mesh.prisms[p], cuts.of(p)))
      split.tets.push_back(tet);
  }
  split.tet_tissue.resize(split.tets.size(), Tissue::Skin);
  return split;
}

} // namespace f2b
