#include "Meshing/skin_fidelity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{

namespace
{

struct Sample
{
  double distance;
  Vec3 place;
};

DistanceFigures figures(std::vector<Sample> samples)
{
  DistanceFigures result;
  result.samples = samples.size();
  if (samples.empty())
    return result;
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.distance < b.distance; });
  const auto at = [&](double share)
  { return samples[static_cast<std::size_t>(share * (samples.size() - 1))].distance; };
  result.median = at(0.5);
  result.p95 = at(0.95);
  result.p995 = at(0.995);
  result.max = samples.back().distance;
  result.max_place = samples.back().place;
  return result;
}

/// Distance between a point and a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp);
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0.0 && d2 <= 0.0)
    return ap.norm();
  if (d3 >= 0.0 && d4 <= d3)
    return bp.norm();
  if (d6 >= 0.0 && d5 <= d6)
    return cp.norm();
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    return (ap - d1 / (d1 - d3) * ab).norm();
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    return (ap - d2 / (d2 - d6) * ac).norm();
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).norm();
  const double scale = 1.0 / (va + vb + vc);
  return (ap - vb * scale * ab - vc * scale * ac).norm();
}

/// Triangles in cubic buckets, for the distance to the nearest one.
class TriangleBuckets
{
public:
  TriangleBuckets(const std::vector<Vec3>& points, std::vector<Triangle> triangles)
      : m_points(points), m_triangles(std::move(triangles))
  {
    m_lo = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 hi = -m_lo;
    for (const Triangle& triangle : m_triangles)
      for (const int node : triangle)
      {
        m_lo = m_lo.cwiseMin(points[node]);
        hi = hi.cwiseMax(points[node]);
      }
    m_size = ((hi - m_lo) / m_edge).array().floor().cast<int>() + 1;
    m_buckets.resize(static_cast<std::size_t>(m_size.prod()));
    for (int t = 0; t < static_cast<int>(m_triangles.size()); ++t)
      insert(t);
  }

  double distance(const Vec3& p) const
  {
    const Eigen::Array3i centre = cell(p);
    double nearest = std::numeric_limits<double>::infinity();
    const int farthest = m_size.maxCoeff();
    for (int ring = 0; ring <= farthest && nearest > (ring - 1) * m_edge; ++ring)
      for (int k = -ring; k <= ring; ++k)
        for (int j = -ring; j <= ring; ++j)
        {
          const bool face = std::abs(k) == ring || std::abs(j) == ring;
          for (int i = -ring; i <= ring; i += face || ring == 0 ? 1 : 2 * ring)
            nearest = std::min(nearest, bucket_distance(centre + Eigen::Array3i(i, j, k), p));
        }
    return nearest;
  }

private:
  Eigen::Array3i cell(const Vec3& p) const
  {
    const Eigen::Array3i raw = ((p - m_lo) / m_edge).array().floor().cast<int>();
    return raw.max(0).min(m_size - 1);
  }
  std::size_t index(const Eigen::Array3i& c) const
  {
    return (static_cast<std::size_t>(c[2]) * m_size[1] + c[1]) * m_size[0] + c[0];
  }
  void insert(int t)
  {
    const Vec3 &a = m_points[m_triangles[t][0]], &b = m_points[m_triangles[t][1]],
               &c = m_points[m_triangles[t][2]];
    const Eigen::Array3i first = cell(a.cwiseMin(b).cwiseMin(c)),
                         last = cell(a.cwiseMax(b).cwiseMax(c));
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          m_buckets[index({i, j, k})].push_back(t);
  }
  double bucket_distance(const Eigen::Array3i& c, const Vec3& p) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    if ((c < 0).any() || (c >= m_size).any())
      return nearest;
    for (const int t : m_buckets[index(c)])
    {
      const Triangle& n = m_triangles[t];
      nearest =
          std::min(nearest, triangle_distance(p, m_points[n[0]], m_points[n[1]], m_points[n[2]]));
    }
    return nearest;
  }

  const std::vector<Vec3>& m_points;
  std::vector<Triangle> m_triangles;
  double m_edge = 3.0;
  Vec3 m_lo;
  Eigen::Array3i m_size;
  std::vector<std::vector<int>> m_buckets;
};

DistanceFigures mesh_to_ct(const MixedMesh& mesh, const ShellDomain& domain, double margin)
{
  static constexpr double weights[7][3] = {{1, 0, 0},
                                           {0, 1, 0},
                                           {0, 0, 1},
                                           {.5, .5, 0},
                                           {0, .5, .5},
                                           {.5, 0, .5},
                                           {1. / 3, 1. / 3, 1. / 3}};
  std::vector<Sample> samples;
  for (const auto& n : mesh.prisms)
    for (const auto& w : weights)
    {
      const Vec3 p = w[0] * mesh.X[n[0]] + w[1] * mesh.X[n[1]] + w[2] * mesh.X[n[2]];
      if (domain.wall_level(p) > -margin)
        continue;
      const double slope = std::max(domain.fields().skin.gradient(p).norm(), 0.5);
      samples.push_back({std::abs(domain.skin(p)) / slope, p});
    }
  return figures(std::move(samples));
}

/// Calls `visit(p)` where the skin crosses an edge of the lattice.
template <class Visit>
void for_each_crossing(const ScalarGrid& skin, Visit visit)
{
  for (int k = 0; k + 1 < skin.size.z(); ++k)
    for (int j = 0; j + 1 < skin.size.y(); ++j)
      for (int i = 0; i + 1 < skin.size.x(); ++i)
      {
        const double here = skin.values[skin.index(i, j, k)];
        for (int axis = 0; axis < 3; ++axis)
        {
          const double next =
              skin.values[skin.index(i + (axis == 0), j + (axis == 1), k + (axis == 2))];
          if ((here < 0.0) != (next < 0.0))
            visit(skin.position(i, j, k) + skin.spacing * here / (here - next) * Vec3::Unit(axis));
        }
      }
}

std::vector<Sample> ct_to_mesh(const MixedMesh& mesh, const ShellDomain& domain, double margin)
{
  std::vector<Triangle> tops;
  for (const auto& n : mesh.prisms)
    tops.push_back({n[0], n[1], n[2]});
  const TriangleBuckets buckets(mesh.X, tops);
  std::vector<Sample> samples;
  for_each_crossing(domain.fields().skin,
                    [&](const Vec3& p)
                    {
                      if (domain.wall_level(p) <= -margin)
                        samples.push_back({buckets.distance(p), p});
                    });
  return samples;
}

std::vector<LeftOut> left_out_places(std::vector<Sample> samples)
{
  constexpr double least = 1.5, apart = 10.0;
  constexpr std::size_t most = 12;
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.distance > b.distance; });
  std::vector<LeftOut> places;
  for (const Sample& sample : samples)
  {
    if (sample.distance < least || places.size() == most)
      break;
    if (std::none_of(places.begin(), places.end(),
                     [&](const LeftOut& other)
                     { return (other.place - sample.place).norm() < apart; }))
      places.push_back({sample.distance, sample.place});
  }
  return places;
}

} // namespace

SkinFidelity skin_fidelity(const MixedMesh& mesh, const ShellDomain& domain, double wall_margin_mm)
{
  const std::vector<Sample> samples = ct_to_mesh(mesh, domain, wall_margin_mm);
  return {mesh_to_ct(mesh, domain, wall_margin_mm), figures(samples), left_out_places(samples)};
}

} // namespace f2b
