#include "Core/sculpting/surface_tree.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace f2b
{
namespace
{

constexpr int leaf_size = 4;

/// Where a ray enters a box; infinite if it misses it or the box lies beyond its reach.
double entry(const Vec3& low, const Vec3& high, const Vec3& origin, const Vec3& inverse,
             double reach)
{
  double from = 0, to = reach;
  for (int k = 0; k < 3; ++k)
  {
    double a = (low[k] - origin[k]) * inverse[k], b = (high[k] - origin[k]) * inverse[k];
    if (a > b)
      std::swap(a, b);
    // a ray within a box's face gives not-a-number, which leaves both as they are
    from = a > from ? a : from;
    to = b < to ? b : to;
  }
  return from <= to ? from : std::numeric_limits<double>::infinity();
}

double squared_distance(const Vec3& low, const Vec3& high, const Vec3& p)
{
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

/// Barycentric coordinates of the point of a triangle that is nearest to p.
/// C. Ericson, Real-Time Collision Detection (2005), 5.1.5: by the Voronoi regions of its features.
Vec3 nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p)
{
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0)
    return {1, 0, 0};
  const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3)
    return {0, 1, 0};
  const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6)
    return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    const double w = (d4 - d3) / (d4 - d3 + d5 - d6);
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

} // namespace

SurfaceTree::SurfaceTree(const TriangleMesh& mesh)
    : m_mesh(mesh), m_order(mesh.triangles.size()), m_leaf_triangles(mesh.triangles.size()),
      m_leaf_of(mesh.triangles.size())
{
  assert(!mesh.triangles.empty());
  std::iota(m_order.begin(), m_order.end(), 0);
  std::vector<Vec3> centres;
  centres.reserve(m_order.size());
  for (const int t : m_order)
    centres.push_back((corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3);
  m_nodes.reserve(m_order.size());
  build(0, static_cast<int>(m_order.size()), -1, centres);
}

const Vec3& SurfaceTree::corner(int triangle, std::size_t k) const
{
  const Triangle& t = m_mesh.triangles[static_cast<std::size_t>(triangle)];
  return m_mesh.points[static_cast<std::size_t>(t[k])];
}

int SurfaceTree::build(int first, int last, int parent, const std::vector<Vec3>& centres)
{
  const int index = static_cast<int>(m_nodes.size());
  m_nodes.emplace_back();
  m_nodes.back().parent = parent;
  m_nodes.back().first = first;
  m_nodes.back().last = last;
  if (last - first <= leaf_size)
  {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
    {
      const auto t = static_cast<std::size_t>(m_order[i]);
      m_leaf_of[t] = index;
      m_leaf_triangles[i] = m_mesh.triangles[t];
    }
    fit_leaf(m_nodes.back());
    return index;
  }
  auto centre = [&](int t) -> const Vec3& { return centres[static_cast<std::size_t>(t)]; };
  Vec3 low = centre(m_order[static_cast<std::size_t>(first)]), high = low;
  for (int i = first; i < last; ++i)
  {
    low = low.cwiseMin(centre(m_order[static_cast<std::size_t>(i)]));
    high = high.cwiseMax(centre(m_order[static_cast<std::size_t>(i)]));
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const int middle = first + (last - first) / 2;
  std::nth_element(m_order.begin() + first, m_order.begin() + middle, m_order.begin() + last,
                   [&](int a, int b) { return centre(a)[axis] < centre(b)[axis]; });
  const int left = build(first, middle, index, centres);
  const int right = build(middle, last, index, centres);
  Node& node = m_nodes[static_cast<std::size_t>(index)];
  node.left = left;
  node.right = right;
  fit_parent(node);
  return index;
}

/// Whether the box has changed.
bool SurfaceTree::fit_leaf(Node& node) const
{
  const Vec3 low = node.low, high = node.high;
  node.low.setConstant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  for (int i = node.first; i < node.last; ++i)
    for (const int v : m_leaf_triangles[static_cast<std::size_t>(i)])
    {
      const Vec3& p = m_mesh.points[static_cast<std::size_t>(v)];
      node.low = node.low.cwiseMin(p);
      node.high = node.high.cwiseMax(p);
    }
  return node.low != low || node.high != high;
}

bool SurfaceTree::fit_parent(Node& node) const
{
  const Node& left = m_nodes[static_cast<std::size_t>(node.left)];
  const Node& right = m_nodes[static_cast<std::size_t>(node.right)];
  const Vec3 low = left.low.cwiseMin(right.low), high = left.high.cwiseMax(right.high);
  const bool changed = node.low != low || node.high != high;
  node.low = low;
  node.high = high;
  return changed;
}

void SurfaceTree::update(const std::vector<int>& triangles)
{
  std::vector<char> is_fitted(m_nodes.size(), 0), is_stale(m_nodes.size(), 0);
  const auto report = [&](const Node& changed)
  {
    if (changed.parent >= 0)
      is_stale[static_cast<std::size_t>(changed.parent)] = 1;
  };
  for (const int t : triangles)
  {
    const auto leaf = static_cast<std::size_t>(m_leaf_of[static_cast<std::size_t>(t)]);
    if (!std::exchange(is_fitted[leaf], 1) && fit_leaf(m_nodes[leaf]))
      report(m_nodes[leaf]);
  }
  // a parent's index is below its children's: from the highest down each is fitted once
  for (std::size_t n = m_nodes.size(); n-- > 0;)
    if (is_stale[n] && fit_parent(m_nodes[n]))
      report(m_nodes[n]);
}

/// T. Moeller and B. Trumbore, J. Graphics Tools 2 (1997) 21.
void SurfaceTree::hit_leaf(const Node& node, const Vec3& origin, const Vec3& direction,
                           std::optional<SurfacePlace>& best, double& reach) const
{
  constexpr double slack = 1e-9; // a ray through an edge hits one of its triangles
  for (int i = node.first; i < node.last; ++i)
  {
    const int t = m_order[static_cast<std::size_t>(i)];
    const Vec3 ab = corner(t, 1) - corner(t, 0), ac = corner(t, 2) - corner(t, 0);
    const Vec3 p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0)
      continue;
    const Vec3 s = origin - corner(t, 0);
    const Vec3 q = s.cross(ab);
    const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
    const double at = ac.dot(q) / determinant;
    if (u < -slack || v < -slack || u + v > 1 + slack || !(at >= 0) || at > reach)
      continue;
    reach = at;
    best = SurfacePlace{t, {1 - u - v, u, v}, origin + at * direction, at};
  }
}

std::optional<SurfacePlace> SurfaceTree::first_hit(const Vec3& origin, const Vec3& direction,
                                                   double reach_mm) const
{
  const Vec3 inverse = direction.cwiseInverse();
  std::optional<SurfacePlace> best;
  double reach = reach_mm;
  std::vector<int> todo{0};
  while (!todo.empty())
  {
    const Node& node = m_nodes[static_cast<std::size_t>(todo.back())];
    todo.pop_back();
    if (!(entry(node.low, node.high, origin, inverse, reach) <= reach))
      continue;
    if (node.left < 0)
    {
      hit_leaf(node, origin, direction, best, reach);
      continue;
    }
    const Node& left = m_nodes[static_cast<std::size_t>(node.left)];
    const Node& right = m_nodes[static_cast<std::size_t>(node.right)];
    const bool left_first = entry(left.low, left.high, origin, inverse, reach) <=
                            entry(right.low, right.high, origin, inverse, reach);
    todo.push_back(left_first ? node.right : node.left);
    todo.push_back(left_first ? node.left : node.right);
  }
  return best;
}

SurfacePlace SurfaceTree::nearest(const Vec3& point) const
{
  SurfacePlace best;
  double squared = std::numeric_limits<double>::infinity();
  std::vector<int> todo{0};
  while (!todo.empty())
  {
    const Node& node = m_nodes[static_cast<std::size_t>(todo.back())];
    todo.pop_back();
    if (squared_distance(node.low, node.high, point) >= squared)
      continue;
    if (node.left < 0)
    {
      for (int i = node.first; i < node.last; ++i)
      {
        const int t = m_order[static_cast<std::size_t>(i)];
        const Vec3 w = nearest_weights(corner(t, 0), corner(t, 1), corner(t, 2), point);
        const Vec3 p = w[0] * corner(t, 0) + w[1] * corner(t, 1) + w[2] * corner(t, 2);
        if ((p - point).squaredNorm() < squared)
        {
          squared = (p - point).squaredNorm();
          best = {t, w, p, std::sqrt(squared)};
        }
      }
      continue;
    }
    const Node& left = m_nodes[static_cast<std::size_t>(node.left)];
    const Node& right = m_nodes[static_cast<std::size_t>(node.right)];
    const bool left_first = squared_distance(left.low, left.high, point) <=
                            squared_distance(right.low, right.high, point);
    todo.push_back(left_first ? node.right : node.left);
    todo.push_back(left_first ? node.left : node.right);
  }
  return best;
}

} // namespace f2b
