#include "Core/inverse/skin_error.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace f2b
{

std::vector<double> signed_distances(const std::vector<Vec3>& predicted,
                                     const std::vector<Vec3>& target,
                                     const std::vector<Vec3>& outward)
{
  std::vector<double> result(predicted.size());
  for (std::size_t v = 0; v < predicted.size(); ++v)
  {
    const Vec3 d = predicted[v] - target[v];
    result[v] = d.dot(outward[v]) < 0 ? -d.norm() : d.norm();
  }
  return result;
}

namespace
{

/// The smallest distance that a share of the area does not exceed.
double percentile(const std::vector<std::pair<double, double>>& sorted_with_area, double share,
                  double total)
{
  double below = 0;
  for (const auto& [distance, area] : sorted_with_area)
  {
    below += area;
    if (below >= share * total)
      return distance;
  }
  return sorted_with_area.back().first;
}

} // namespace

SkinError skin_error(const std::vector<double>& signed_distance, const std::vector<double>& area)
{
  SkinError e;
  std::vector<std::pair<double, double>> sorted;
  for (std::size_t v = 0; v < signed_distance.size(); ++v)
  {
    if (area[v] <= 0)
      continue;
    const double d = std::abs(signed_distance[v]);
    sorted.emplace_back(d, area[v]);
    e.area_mm2 += area[v];
    e.mean += area[v] * d;
    e.signed_mean += area[v] * signed_distance[v];
    e.under_1mm += d < 1 ? area[v] : 0;
    e.under_2mm += d < 2 ? area[v] : 0;
  }
  if (sorted.empty())
    return e;
  for (double* sum : {&e.mean, &e.signed_mean, &e.under_1mm, &e.under_2mm})
    *sum /= e.area_mm2;
  for (const auto& [d, a] : sorted)
    e.variance += a * (d - e.mean) * (d - e.mean) / e.area_mm2;
  e.sd = std::sqrt(e.variance);
  std::sort(sorted.begin(), sorted.end());
  e.median = percentile(sorted, 0.50, e.area_mm2);
  e.p90 = percentile(sorted, 0.90, e.area_mm2);
  e.p95 = percentile(sorted, 0.95, e.area_mm2);
  e.max = sorted.back().first;
  return e;
}

namespace
{

Vec3 doubled_area(const TriangleMesh& mesh, const Triangle& t)
{
  const Vec3& a = mesh.points[static_cast<std::size_t>(t[0])];
  return (mesh.points[static_cast<std::size_t>(t[1])] - a)
      .cross(mesh.points[static_cast<std::size_t>(t[2])] - a);
}

} // namespace

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh)
{
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles)
    for (const int v : t)
      normals[static_cast<std::size_t>(v)] += doubled_area(mesh, t);
  for (Vec3& n : normals)
    n.normalize();
  return normals;
}

std::vector<double> vertex_areas(const TriangleMesh& mesh)
{
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (const Triangle& t : mesh.triangles)
    for (const int v : t)
      areas[static_cast<std::size_t>(v)] += doubled_area(mesh, t).norm() / 6;
  return areas;
}

} // namespace f2b
