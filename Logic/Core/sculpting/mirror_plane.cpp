#include "Core/sculpting/mirror_plane.hpp"

#include "Core/sculpting/surface_tree.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace f2b
{
namespace
{

constexpr double kept_share = 0.8;

struct Pair
{
  Vec3 own;    ///< a vertex
  Vec3 match;  ///< the place of the skin nearest to its mirror image
  Vec3 normal; ///< of the skin there
  double distance;
};

/// No more than so many of the vertices that are used.
std::vector<Vec3> sampled(const TriangleMesh& skin, const std::vector<int>& used, std::size_t most)
{
  const std::size_t step = used.size() / most + 1;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < used.size(); i += step)
    points.push_back(skin.points[static_cast<std::size_t>(used[i])]);
  return points;
}

/// The pairs that match best.
std::vector<Pair> matched(const TriangleMesh& skin, const SurfaceTree& tree,
                          const std::vector<Vec3>& points, const SymmetryPlane& plane)
{
  std::vector<Pair> pairs;
  for (const Vec3& p : points)
  {
    const SurfacePlace place = tree.nearest(plane.mirrored(p));
    const auto corner = [&](std::size_t k) -> const Vec3&
    {
      const Triangle& t = skin.triangles[static_cast<std::size_t>(place.triangle)];
      return skin.points[static_cast<std::size_t>(t[k])];
    };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (normal.norm() > 0)
      pairs.push_back({p, place.point, normal.normalized(), place.distance});
  }
  const auto kept = static_cast<std::ptrdiff_t>(kept_share * static_cast<double>(pairs.size()));
  std::nth_element(pairs.begin(), pairs.begin() + kept, pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  pairs.erase(pairs.begin() + kept, pairs.end());
  return pairs;
}

/// One Gauss-Newton step of the distances from mirror images to the skin's tangent planes (Chen &
/// Medioni 1992) in the plane's three freedoms: two turns of its normal and its offset. Returns how
/// far it went [mm at 100 mm].
double improve(SymmetryPlane& plane, const std::vector<Pair>& pairs)
{
  const Vec3 u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  Mat3 system = 1e-9 * Mat3::Identity();
  Vec3 right = Vec3::Zero();
  for (const Pair& pair : pairs)
  {
    const Vec3 arm = pair.own - plane.point;
    const double height = plane.normal.dot(arm), facing = plane.normal.dot(pair.normal);
    const Vec3 slope = -2 * Vec3(u.dot(arm) * facing + height * u.dot(pair.normal),
                                 v.dot(arm) * facing + height * v.dot(pair.normal), -facing);
    system += slope * slope.transpose();
    right -= slope * (plane.mirrored(pair.own) - pair.match).dot(pair.normal);
  }
  const Vec3 step = system.ldlt().solve(right);
  plane.point += step.z() * plane.normal;
  plane.normal = (plane.normal + step.x() * u + step.y() * v).normalized();
  return 100 * step.head<2>().norm() + std::abs(step.z());
}

MirrorPlane refined(const TriangleMesh& skin, const SurfaceTree& tree,
                    const std::vector<Vec3>& points, SymmetryPlane plane, int iterations)
{
  constexpr double settled_mm = 1e-4;
  std::vector<Pair> pairs = matched(skin, tree, points, plane);
  for (int i = 0; i < iterations; ++i)
  {
    const double step = improve(plane, pairs);
    pairs = matched(skin, tree, points, plane);
    if (step < settled_mm)
      break;
  }
  double sum = 0;
  for (const Pair& pair : pairs)
    sum += pair.distance;
  return {plane, sum / static_cast<double>(pairs.size())};
}

} // namespace

std::optional<MirrorPlane> mirror_plane(const TriangleMesh& skin, std::vector<int> used)
{
  constexpr std::size_t few = 600, many = 4000;
  if (used.empty())
  {
    used.resize(skin.points.size());
    std::iota(used.begin(), used.end(), 0);
  }
  if (used.size() < 100 || skin.triangles.empty())
    return std::nullopt;
  const std::vector<Vec3> coarse = sampled(skin, used, few);
  const Vec3 centre = std::accumulate(coarse.begin(), coarse.end(), Vec3(Vec3::Zero())) /
                      static_cast<double>(coarse.size());
  const SurfaceTree tree(skin);
  std::optional<MirrorPlane> best;
  // a head that is turned or tilted in the scanner is found from the start that is next to it
  for (const double yaw : {0.0, -0.25, 0.25})
    for (const double roll : {0.0, -0.25, 0.25})
    {
      const Vec3 normal = Vec3(1, std::sin(yaw), std::sin(roll)).normalized();
      const MirrorPlane found = refined(skin, tree, coarse, {centre, normal}, 20);
      if (!best || found.asymmetry_mm < best->asymmetry_mm)
        best = found;
    }
  best = refined(skin, tree, sampled(skin, used, many), best->plane, 30);
  const double least_cosine = std::cos(30 * std::acos(-1.0) / 180);
  if (!best->plane.normal.allFinite() || best->plane.normal.x() < least_cosine)
    return std::nullopt;
  return best;
}

} // namespace f2b
