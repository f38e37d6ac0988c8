#include "Core/mesh/boundary_facets.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace f2b
{

namespace
{

struct HalfEdge
{
  std::array<int, 2> key{}; ///< ascending
  int triangle = -1;
  int from = -1, to = -1;
};

std::vector<HalfEdge> sorted_edges(const std::vector<Triangle>& triangles)
{
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3; ++i)
    {
      const int a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      edges.push_back({{std::min(a, b), std::max(a, b)}, t, a, b});
    }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& a, const HalfEdge& b)
            { return a.key != b.key ? a.key < b.key : a.triangle < b.triangle; });
  return edges;
}

class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count) : m_parent(count)
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }
  int find(int i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void unite(int a, int b)
  {
    a = find(a);
    b = find(b);
    m_parent[std::max(a, b)] = std::min(a, b);
  }
  /// Set of each member, numbered by first appearance.
  std::vector<int> numbers()
  {
    std::vector<int> number_of_root(m_parent.size(), -1), result(m_parent.size());
    int next = 0;
    for (int i = 0; i < static_cast<int>(m_parent.size()); ++i)
    {
      int& number = number_of_root[find(i)];
      if (number < 0)
        number = next++;
      result[i] = number;
    }
    return result;
  }

private:
  std::vector<int> m_parent;
};

/// Calls `visit(begin, end)` for each run of members with one key.
template <class Member, class Visit>
void for_each_run(const std::vector<Member>& members, Visit visit)
{
  for (std::size_t i = 0; i < members.size();)
  {
    std::size_t end = i + 1;
    while (end < members.size() && members[end].key == members[i].key)
      ++end;
    visit(i, end);
    i = end;
  }
}

} // namespace

std::vector<TetFace> sorted_tet_faces(const std::vector<Tet>& tets)
{
  std::vector<TetFace> faces;
  faces.reserve(4 * tets.size());
  for (int t = 0; t < static_cast<int>(tets.size()); ++t)
    for (int corner = 0; corner < 4; ++corner)
    {
      TetFace face{outward_face(tets[t], corner), t, corner};
      std::sort(face.key.begin(), face.key.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(),
            [](const TetFace& a, const TetFace& b)
            { return a.key != b.key ? a.key < b.key : a.tet < b.tet; });
  return faces;
}

Triangle outward_face(const Tet& tet, int opposite)
{
  static constexpr int corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  const int* c = corners[opposite];
  return {tet[c[0]], tet[c[1]], tet[c[2]]};
}

std::vector<Triangle> tet_boundary(const std::vector<Tet>& tets)
{
  std::vector<TetFace> outer;
  const std::vector<TetFace> faces = sorted_tet_faces(tets);
  for_each_run(faces,
               [&](std::size_t begin, std::size_t end)
               {
                 if (end - begin == 1)
                   outer.push_back(faces[begin]);
               });
  std::sort(outer.begin(), outer.end(),
            [](const TetFace& a, const TetFace& b)
            { return a.tet != b.tet ? a.tet < b.tet : a.opposite < b.opposite; });
  std::vector<Triangle> result;
  result.reserve(outer.size());
  for (const TetFace& face : outer)
    result.push_back(outward_face(tets[face.tet], face.opposite));
  return result;
}

BoundaryFacets boundary_facets(const MixedMesh& mesh)
{
  BoundaryFacets result;
  std::vector<Triangle> bottoms;
  std::map<int, int> below;
  for (const auto& p : mesh.prisms)
  {
    result.skin.push_back({p[0], p[1], p[2]});
    bottoms.push_back({p[3], p[4], p[5]});
    for (int i = 0; i < 3; ++i)
      below[p[i]] = p[i + 3];
  }
  const std::vector<HalfEdge> edges = sorted_edges(result.skin);
  for_each_run(edges,
               [&](std::size_t begin, std::size_t end)
               {
                 const HalfEdge& e = edges[begin];
                 if (end - begin == 1)
                   result.sides.push_back({e.to, e.from, below[e.from], below[e.to]});
               });
  for (Triangle& triangle : bottoms)
    std::sort(triangle.begin(), triangle.end());
  std::sort(bottoms.begin(), bottoms.end());
  for (const Triangle& facet : tet_boundary(mesh.tets))
  {
    Triangle key = facet;
    std::sort(key.begin(), key.end());
    if (!std::binary_search(bottoms.begin(), bottoms.end(), key))
      result.inner.push_back(facet);
  }
  return result;
}

std::vector<int> sheet_components(const std::vector<Triangle>& triangles)
{
  DisjointSets sets(triangles.size());
  const std::vector<HalfEdge> edges = sorted_edges(triangles);
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].key == edges[i - 1].key)
      sets.unite(edges[i].triangle, edges[i - 1].triangle);
  return sets.numbers();
}

std::vector<std::vector<int>> boundary_loops(const std::vector<Triangle>& triangles)
{
  std::multimap<int, int> next;
  const std::vector<HalfEdge> edges = sorted_edges(triangles);
  for_each_run(edges,
               [&](std::size_t begin, std::size_t end)
               {
                 if (end - begin == 1)
                   next.emplace(edges[begin].from, edges[begin].to);
               });
  std::vector<std::vector<int>> loops;
  while (!next.empty())
  {
    std::vector<int> loop;
    for (auto edge = next.begin(); edge != next.end(); edge = next.find(loop.back()))
    {
      if (loop.empty())
        loop.push_back(edge->first);
      loop.push_back(edge->second);
      next.erase(edge);
      if (loop.back() == loop.front())
        break;
    }
    loop.pop_back();
    loops.push_back(loop);
  }
  return loops;
}

std::vector<int> non_manifold_nodes(const std::vector<Triangle>& triangles)
{
  std::vector<int> result;
  // Two triangles at a node are in one fan when they share an edge at that node.
  std::map<int, std::vector<int>> around;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (const int node : triangles[t])
      around[node].push_back(t);
  const std::vector<HalfEdge> edges = sorted_edges(triangles);
  std::map<int, std::vector<std::array<int, 2>>> joined;
  for_each_run(edges,
               [&](std::size_t begin, std::size_t end)
               {
                 for (const int node : edges[begin].key)
                   for (std::size_t i = begin + 1; i < end; ++i)
                     joined[node].push_back({edges[begin].triangle, edges[i].triangle});
                 if (end - begin > 2)
                   result.insert(result.end(), edges[begin].key.begin(), edges[begin].key.end());
               });
  for (const auto& [node, fan] : around)
  {
    DisjointSets sets(fan.size());
    for (const auto& pair : joined[node])
    {
      const auto local = [&, &members = fan](int t)
      { return std::lower_bound(members.begin(), members.end(), t) - members.begin(); };
      sets.unite(static_cast<int>(local(pair[0])), static_cast<int>(local(pair[1])));
    }
    const std::vector<int> numbers = sets.numbers();
    if (*std::max_element(numbers.begin(), numbers.end()) > 0)
      result.push_back(node);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<int> tet_components(const std::vector<Tet>& tets)
{
  DisjointSets sets(tets.size());
  const std::vector<TetFace> faces = sorted_tet_faces(tets);
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].key == faces[i - 1].key)
      sets.unite(faces[i].tet, faces[i - 1].tet);
  return sets.numbers();
}

} // namespace f2b
