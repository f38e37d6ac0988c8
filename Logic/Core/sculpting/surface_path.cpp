#include "Core/sculpting/surface_path.hpp"

#include <algorithm>
#include <queue>
#include <unordered_map>

namespace f2b
{
namespace
{

struct Label
{
  double distance;
  int before; ///< vertex, or -1 at the start
};

/// The shortest way along edges between the corners of two triangles, by Dijkstra's algorithm.
std::vector<int> edge_path(const TriangleMesh& mesh, const SurfaceLinks& links,
                           const SurfacePlace& from, const SurfacePlace& to)
{
  auto point = [&](int v) -> const Vec3& { return mesh.points[static_cast<std::size_t>(v)]; };
  const Triangle& goal = mesh.triangles[static_cast<std::size_t>(to.triangle)];
  std::unordered_map<int, Label> labels;
  using Entry = std::pair<double, int>; // distance so far and at least still to go, vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
  auto offer = [&](int v, double distance, int before)
  {
    const auto [found, fresh] = labels.try_emplace(v, Label{distance, before});
    if (!fresh && found->second.distance <= distance)
      return;
    found->second = {distance, before};
    front.emplace(distance + (point(v) - to.point).norm(), v);
  };
  for (const int v : mesh.triangles[static_cast<std::size_t>(from.triangle)])
    offer(v, (point(v) - from.point).norm(), -1);
  while (!front.empty())
  {
    const auto [total, v] = front.top();
    front.pop();
    const double so_far = labels.at(v).distance;
    if (total > so_far + (point(v) - to.point).norm() + 1e-12)
      continue;
    if (std::find(goal.begin(), goal.end(), v) != goal.end())
    {
      std::vector<int> path;
      for (int w = v; w >= 0; w = labels.at(w).before)
        path.push_back(w);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const int w : links.neighbours_of(v))
      offer(w, so_far + (point(w) - point(v)).norm(), v);
  }
  return {};
}

/// Points evenly spread over a polyline, its ends kept.
std::vector<Vec3> resampled(const std::vector<Vec3>& line, double spacing)
{
  std::vector<double> length{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    length.push_back(length.back() + (line[i] - line[i - 1]).norm());
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::round(length.back() / spacing)));
  std::vector<Vec3> points{line.front()};
  for (std::size_t k = 1, i = 1; k < pieces; ++k)
  {
    const double at = length.back() * static_cast<double>(k) / static_cast<double>(pieces);
    while (length[i] < at)
      ++i;
    const double t = (at - length[i - 1]) / (length[i] - length[i - 1]);
    points.push_back((1 - t) * line[i - 1] + t * line[i]);
  }
  points.push_back(line.back());
  return points;
}

/// Pulls the points between the ends towards the middle of their neighbours, on the surface.
void straighten(std::vector<Vec3>& points, const SurfaceTree& tree)
{
  constexpr int most_sweeps = 200;
  constexpr double still_mm = 0.005;
  for (int sweep = 0; sweep < most_sweeps; ++sweep)
  {
    double moved = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      const Vec3 before = points[i];
      const Vec3 middle = 0.5 * (points[i - 1] + points[i + 1]);
      points[i] = tree.nearest(middle + 0.5 * (middle - before)).point; // over-relaxed
      moved = std::max(moved, (points[i] - before).norm());
    }
    if (moved < still_mm)
      return;
  }
}

} // namespace

std::vector<Vec3> surface_path(const TriangleMesh& mesh, const SurfaceLinks& links,
                               const SurfaceTree& tree, const SurfacePlace& from,
                               const SurfacePlace& to, double spacing_mm)
{
  if ((from.point - to.point).norm() < 1e-9)
    return {from.point, to.point};
  std::vector<Vec3> line{from.point};
  if (from.triangle != to.triangle)
  {
    const std::vector<int> path = edge_path(mesh, links, from, to);
    if (path.empty())
      return {};
    for (const int v : path)
      line.push_back(mesh.points[static_cast<std::size_t>(v)]);
  }
  line.push_back(to.point);
  std::vector<Vec3> points = resampled(line, spacing_mm);
  straighten(points, tree);
  return points;
}

} // namespace f2b
