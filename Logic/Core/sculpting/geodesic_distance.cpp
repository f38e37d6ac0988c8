#include "Core/sculpting/geodesic_distance.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

constexpr std::size_t bucket_count = 512; // of a large brush each holds a few dozen vertices

bool farther(const NearVertex& a, const NearVertex& b)
{
  return a.distance > b.distance || (a.distance == b.distance && a.vertex > b.vertex);
}

/// Distance of c from a source that lies at distances da and db from a and b, in the plane of the
/// three and beyond ab; infinite if its straight line to c does not cross ab.
double across(const Vec3& a, const Vec3& b, const Vec3& c, double da, double db)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const Vec3 ab = b - a, ac = c - a;
  const double squared = ab.squaredNorm();
  if (squared == 0)
    return none;
  // along ab in shares of its length, from a; aside in millimetres
  const double source = (squared + da * da - db * db) / (2 * squared);
  const double along = ab.dot(ac) / squared;
  const double source_aside = std::sqrt(std::max(0.0, da * da - source * source * squared));
  const double aside = std::sqrt(std::max(0.0, ac.squaredNorm() - along * along * squared));
  const double apart = source_aside + aside;
  if (apart == 0)
    return none;
  const double crossing = source + (along - source) * source_aside / apart;
  if (crossing < 0 || crossing > 1)
    return none;
  return std::sqrt((along - source) * (along - source) * squared + apart * apart);
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
      m_state(links.vertex_count(), State::Far), m_buckets(bucket_count)
{
  m_ring_start.push_back(0);
  for (std::size_t v = 0; v < links.vertex_count(); ++v)
  {
    const int vertex = static_cast<int>(v);
    for (const int t : links.triangles_of(vertex))
    {
      const Triangle& corners = links.triangles()[static_cast<std::size_t>(t)];
      const int k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
      m_ring.push_back({corners[k == 2 ? 0 : k + 1], corners[k == 0 ? 2 : k - 1], true});
    }
    for (std::size_t r = m_ring_start.back(); r < m_ring.size(); ++r)
      for (std::size_t other = m_ring_start.back(); other < m_ring.size(); ++other)
        if (m_ring[other].next == m_ring[r].previous)
          m_ring[r].has_edge_to_previous = false;
    m_ring_start.push_back(m_ring.size());
  }
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
  m_offered.push_back(vertex);
}

/// Vertices that have been offered less join the front, each once with the least.
void GeodesicDistance::join_front()
{
  const double per_mm = m_limit_mm > 1e-9 ? bucket_count / m_limit_mm : 0;
  for (auto offered = m_offered.begin(); offered != m_offered.end(); ++offered)
  {
    if (std::find(offered + 1, m_offered.end(), *offered) != m_offered.end())
      continue; // it comes again
    const double distance = m_distance[static_cast<std::size_t>(*offered)];
    const auto bucket = std::min(static_cast<std::size_t>(distance * per_mm), bucket_count - 1);
    if (bucket > m_bucket)
    {
      m_buckets[bucket].push_back({*offered, distance});
      continue;
    }
    m_front.push_back({*offered, distance});
    std::push_heap(m_front.begin(), m_front.end(), farther);
  }
  m_offered.clear();
}

/// What has not come nearer since it was put there becomes the heap.
void GeodesicDistance::open_bucket()
{
  for (const NearVertex& near : m_buckets[m_bucket])
    if (m_distance[static_cast<std::size_t>(near.vertex)] == near.distance)
      m_front.push_back(near);
  m_buckets[m_bucket].clear();
  std::make_heap(m_front.begin(), m_front.end(), farther);
}

/// A final vertex offers its neighbours their distances, along edges and across triangles.
void GeodesicDistance::spread(const std::vector<Vec3>& points, int vertex)
{
  auto at = [&](int v) -> const Vec3& { return points[static_cast<std::size_t>(v)]; };
  auto distance = [&](int v) { return m_distance[static_cast<std::size_t>(v)]; };
  auto is_final = [&](int v) { return m_state[static_cast<std::size_t>(v)] == State::Final; };
  auto along_edge = [&](int v) { return distance(vertex) + (at(v) - at(vertex)).norm(); };
  const auto at_vertex = static_cast<std::size_t>(vertex);
  for (std::size_t r = m_ring_start[at_vertex]; r < m_ring_start[at_vertex + 1]; ++r)
  {
    const Opposite& triangle = m_ring[r];
    const bool next_is_final = is_final(triangle.next),
               previous_is_final = is_final(triangle.previous);
    if (!next_is_final)
      offer(triangle.next, along_edge(triangle.next));
    if (!previous_is_final && triangle.has_edge_to_previous)
      offer(triangle.previous, along_edge(triangle.previous));
    if (next_is_final != previous_is_final)
    {
      const int known = next_is_final ? triangle.next : triangle.previous;
      const int sought = next_is_final ? triangle.previous : triangle.next;
      offer(sought, across(at(vertex), at(known), at(sought), distance(vertex), distance(known)));
    }
  }
  join_front();
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
  m_bucket = 0;
  join_front();
  for (; m_bucket < bucket_count; ++m_bucket)
  {
    open_bucket();
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
  }
  return m_reached;
}

} // namespace f2b
