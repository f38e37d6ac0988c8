#include "Core/sculpting/geodesic_distance.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

bool farther(const NearVertex& a, const NearVertex& b)
{
  return a.distance > b.distance || (a.distance == b.distance && a.vertex > b.vertex);
}

/// Distance of c from a source that lies at distances da and db from a and b, in the plane of the
/// three and beyond ab; infinite if its straight line to c does not cross ab.
double across(const Vec3& a, const Vec3& b, const Vec3& c, double da, double db)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const Vec3 ab = b - a;
  const double length = ab.norm();
  if (length == 0)
    return none;
  const Vec3 along = ab / length;
  const double source_x = (length * length + da * da - db * db) / (2 * length);
  const double source_y = std::sqrt(std::max(0.0, da * da - source_x * source_x));
  const double x = along.dot(c - a);
  const double y = std::sqrt(std::max(0.0, (c - a).squaredNorm() - x * x));
  if (source_y + y == 0)
    return none;
  const double crossing = source_x + (x - source_x) * source_y / (source_y + y);
  if (crossing < 0 || crossing > length)
    return none;
  const double dx = x - source_x, dy = y + source_y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Corners of all triangles that a place lies in: two on an edge, more on a vertex. One of them alone
/// would make a symmetric face's distances asymmetric.
std::vector<int> corners_around(const SurfaceLinks& links, const SurfacePlace& place)
{
  constexpr double on_edge = 1e-9;
  const Triangle& own = links.triangles()[static_cast<std::size_t>(place.triangle)];
  std::vector<int> held;
  for (int k = 0; k < 3; ++k)
    if (place.weights[k] > on_edge)
      held.push_back(own[static_cast<std::size_t>(k)]);
  std::vector<int> corners(own.begin(), own.end());
  if (held.empty() || held.size() == 3)
    return corners;
  for (const int t : links.triangles_of(held.front()))
  {
    const Triangle& other = links.triangles()[static_cast<std::size_t>(t)];
    if (std::all_of(held.begin(), held.end(),
                    [&](int v) { return std::find(other.begin(), other.end(), v) != other.end(); }))
      corners.insert(corners.end(), other.begin(), other.end());
  }
  return corners;
}

} // namespace

GeodesicDistance::GeodesicDistance(const SurfaceLinks& links)
    : m_links(links), m_distance(links.vertex_count(), std::numeric_limits<double>::infinity()),
      m_state(links.vertex_count(), State::Far)
{
}

void GeodesicDistance::offer(int vertex, double distance)
{
  const auto v = static_cast<std::size_t>(vertex);
  if (distance > m_limit_mm || !(distance < m_distance[v]))
    return;
  if (m_state[v] == State::Far)
    m_touched.push_back(vertex);
  m_state[v] = State::Front;
  m_distance[v] = distance;
  m_front.push_back({vertex, distance});
  std::push_heap(m_front.begin(), m_front.end(), farther);
}

/// A final vertex offers its neighbours their distances, along edges and across triangles.
void GeodesicDistance::spread(const std::vector<Vec3>& points, int vertex)
{
  auto at = [&](int v) -> const Vec3& { return points[static_cast<std::size_t>(v)]; };
  auto distance = [&](int v) { return m_distance[static_cast<std::size_t>(v)]; };
  for (const int t : m_links.triangles_of(vertex))
  {
    const Triangle& corners = m_links.triangles()[static_cast<std::size_t>(t)];
    const int k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    const int others[2] = {corners[k == 2 ? 0 : k + 1], corners[k == 0 ? 2 : k - 1]};
    if (m_state[static_cast<std::size_t>(others[0])] == State::Final &&
        m_state[static_cast<std::size_t>(others[1])] == State::Final)
      continue;
    for (int i = 0; i < 2; ++i)
    {
      const int a = others[i], b = others[1 - i];
      if (m_state[static_cast<std::size_t>(a)] == State::Final)
        continue;
      double found = distance(vertex) + (at(a) - at(vertex)).norm();
      if (m_state[static_cast<std::size_t>(b)] == State::Final)
        found = std::min(found, across(at(vertex), at(b), at(a), distance(vertex), distance(b)));
      offer(a, found);
    }
  }
}

const std::vector<NearVertex>& GeodesicDistance::from(const std::vector<Vec3>& points,
                                                      const SurfacePlace& source, double limit_mm)
{
  for (const int v : m_touched)
  {
    m_distance[static_cast<std::size_t>(v)] = std::numeric_limits<double>::infinity();
    m_state[static_cast<std::size_t>(v)] = State::Far;
  }
  m_touched.clear();
  m_front.clear();
  m_reached.clear();
  m_limit_mm = limit_mm;
  for (const int v : corners_around(m_links, source))
    offer(v, (points[static_cast<std::size_t>(v)] - source.point).norm());
  while (!m_front.empty())
  {
    const NearVertex next = m_front.front();
    std::pop_heap(m_front.begin(), m_front.end(), farther);
    m_front.pop_back();
    State& state = m_state[static_cast<std::size_t>(next.vertex)];
    if (state == State::Final)
      continue;
    state = State::Final;
    m_reached.push_back(next);
    spread(points, next.vertex);
  }
  return m_reached;
}

} // namespace f2b
