#include "Meshing/edge_collapse.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <queue>

namespace f2b
{
namespace
{

/// Sum of squared distances to planes, weighted with area: x'Ax + 2b'x + c.
struct Quadric
{
  Mat3 A = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0.0;

  void add_plane(const Vec3& normal, const Vec3& point, double weight)
  {
    const double d = -normal.dot(point);
    A += weight * normal * normal.transpose();
    b += weight * d * normal;
    c += weight * d * d;
  }
  Quadric operator+(const Quadric& other) const { return {A + other.A, b + other.b, c + other.c}; }
  double at(const Vec3& x) const { return x.dot(A * x) + 2.0 * b.dot(x) + c; }
};

struct Plane
{
  Vec3 normal;
  double offset;
  double distance(const Vec3& x) const { return std::abs(normal.dot(x) - offset); }
};

struct Candidate
{
  double cost;
  int from, to;
  int version; ///< sum of both ends' versions when the cost was computed
  Vec3 place;

  /// Cheapest first; ties by index, for the same result everywhere.
  bool operator<(const Candidate& other) const
  {
    if (cost != other.cost)
      return cost > other.cost;
    return from != other.from ? from > other.from : to > other.to;
  }
};

class EdgeCollapse
{
public:
  EdgeCollapse(const TriangleMesh& surface, double error_mm)
      : m_error(error_mm), m_points(surface.points), m_triangles(surface.triangles),
        m_alive(surface.triangles.size(), 1), m_fans(surface.points.size()),
        m_quadrics(surface.points.size()), m_versions(surface.points.size(), 0),
        m_planes(surface.points.size())
  {
    for (int t = 0; t < static_cast<int>(m_triangles.size()); ++t)
      add_triangle(t);
    for (const Triangle& t : m_triangles)
      for (int c = 0; c < 3; ++c)
        if (t[c] < t[(c + 1) % 3])
          push(t[c], t[(c + 1) % 3]);
  }

  void run()
  {
    while (!m_queue.empty())
    {
      const Candidate next = m_queue.top();
      m_queue.pop();
      if (next.version == m_versions[next.from] + m_versions[next.to] &&
          !m_fans[next.from].empty() && !m_fans[next.to].empty() && allowed(next))
        collapse(next);
    }
  }

  TriangleMesh result() const
  {
    TriangleMesh mesh;
    std::vector<int> number(m_points.size(), -1);
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
    {
      if (!m_alive[t])
        continue;
      Triangle triangle = m_triangles[t];
      for (int& corner : triangle)
      {
        if (number[corner] < 0)
        {
          number[corner] = static_cast<int>(mesh.points.size());
          mesh.points.push_back(m_points[corner]);
        }
        corner = number[corner];
      }
      mesh.triangles.push_back(triangle);
    }
    return mesh;
  }

private:
  Vec3 area_vector(const Triangle& t) const
  {
    return 0.5 * (m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]);
  }

  void add_triangle(int number)
  {
    const Triangle& t = m_triangles[number];
    const Vec3 a = area_vector(t);
    const double area = a.norm();
    for (const int corner : t)
    {
      m_fans[corner].push_back(number);
      if (area > 0.0)
      {
        m_quadrics[corner].add_plane(a / area, m_points[t[0]], area);
        m_planes[corner].push_back({a / area, a.dot(m_points[t[0]]) / area});
      }
    }
  }

  std::vector<int> neighbours(int point) const
  {
    std::vector<int> found;
    for (const int t : m_fans[point])
      for (const int corner : m_triangles[t])
        if (corner != point)
          found.push_back(corner);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  void push(int a, int b)
  {
    const Quadric q = m_quadrics[a] + m_quadrics[b];
    const Vec3 middle = 0.5 * (m_points[a] + m_points[b]);
    // A touch of the middle makes flat and cylindrical places solvable and prefers short edges.
    const double pull = 1e-3 * q.A.trace() + 1e-12;
    const Mat3 system = q.A + pull * Mat3::Identity();
    const Vec3 place = system.ldlt().solve(pull * middle - q.b);
    const double length2 = (m_points[a] - m_points[b]).squaredNorm();
    const double cost = std::max(0.0, q.at(place)) + pull * length2;
    m_queue.push({cost, a, b, m_versions[a] + m_versions[b], place});
  }

  /// The link condition: the ends share just the two points opposite the edge, and these keep at
  /// least three triangles.
  bool link_is_simple(int a, int b) const
  {
    const std::vector<int> of_a = neighbours(a), of_b = neighbours(b);
    std::vector<int> shared;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          std::back_inserter(shared));
    return shared.size() == 2 && m_fans[shared[0]].size() > 3 && m_fans[shared[1]].size() > 3;
  }

  bool keeps_facing(int moved, int other, const Vec3& place) const
  {
    for (const int number : m_fans[moved])
    {
      const Triangle& t = m_triangles[number];
      if (std::find(t.begin(), t.end(), other) != t.end())
        continue;
      Vec3 corners[3];
      for (int c = 0; c < 3; ++c)
        corners[c] = t[c] == moved ? place : m_points[t[c]];
      const Vec3 after = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
      const Vec3 before = area_vector(t);
      const double longest = std::max({(corners[1] - corners[0]).squaredNorm(),
                                       (corners[2] - corners[1]).squaredNorm(),
                                       (corners[0] - corners[2]).squaredNorm()});
      if (after.norm() < 0.02 * longest || after.dot(before) < 0.3 * after.norm() * before.norm())
        return false;
    }
    return true;
  }

  bool stays_near(int point, const Vec3& place) const
  {
    return std::all_of(m_planes[point].begin(), m_planes[point].end(),
                       [&](const Plane& plane) { return plane.distance(place) <= m_error; });
  }

  bool allowed(const Candidate& edge) const
  {
    return stays_near(edge.from, edge.place) && stays_near(edge.to, edge.place) &&
           link_is_simple(edge.from, edge.to) && keeps_facing(edge.from, edge.to, edge.place) &&
           keeps_facing(edge.to, edge.from, edge.place);
  }

  void collapse(const Candidate& edge)
  {
    const int kept = edge.from, gone = edge.to;
    m_points[kept] = edge.place;
    m_quadrics[kept] = m_quadrics[kept] + m_quadrics[gone];
    m_planes[kept].insert(m_planes[kept].end(), m_planes[gone].begin(), m_planes[gone].end());
    m_planes[gone] = {};
    const std::vector<int> fan = std::move(m_fans[gone]);
    m_fans[gone].clear();
    for (const int number : fan)
    {
      Triangle& t = m_triangles[number];
      if (std::find(t.begin(), t.end(), kept) == t.end())
      {
        std::replace(t.begin(), t.end(), gone, kept);
        m_fans[kept].push_back(number);
        continue;
      }
      m_alive[number] = 0;
      for (const int corner : t)
      {
        std::vector<int>& other = m_fans[corner];
        other.erase(std::remove(other.begin(), other.end(), number), other.end());
      }
    }
    ++m_versions[gone];
    ++m_versions[kept];
    for (const int neighbour : neighbours(kept))
      push(std::min(kept, neighbour), std::max(kept, neighbour));
  }

  double m_error;
  std::vector<Vec3> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<char> m_alive;
  std::vector<std::vector<int>> m_fans; ///< living triangles around each point
  std::vector<Quadric> m_quadrics;
  std::vector<int> m_versions;
  std::vector<std::vector<Plane>> m_planes; ///< of the triangles that a vertex stands for
  std::priority_queue<Candidate> m_queue;
};

} // namespace

TriangleMesh collapse_edges(const TriangleMesh& closed_surface, double error_mm)
{
  EdgeCollapse collapse(closed_surface, error_mm);
  collapse.run();
  return collapse.result();
}

} // namespace f2b
