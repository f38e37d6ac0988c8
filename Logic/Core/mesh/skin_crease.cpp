#include "Core/mesh/skin_crease.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace f2b
{
namespace
{

constexpr double degrees_per_radian = 57.29577951308232;

/// An edge as one prism sees it.
struct EdgeSide
{
  std::pair<int, int> nodes; ///< ascending
  int prism;
  std::array<int, 2> corners; ///< of the prism, in the order of the nodes
};

std::vector<EdgeSide> sorted_sides(const MixedMesh& mesh)
{
  std::vector<EdgeSide> sides;
  for (std::size_t p = 0; p < mesh.prisms.size(); ++p)
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int a = mesh.prisms[p][static_cast<std::size_t>(i)];
      const int b = mesh.prisms[p][static_cast<std::size_t>(j)];
      sides.push_back(a < b ? EdgeSide{{a, b}, static_cast<int>(p), {i, j}}
                            : EdgeSide{{b, a}, static_cast<int>(p), {j, i}});
    }
  std::sort(sides.begin(), sides.end(),
            [](const EdgeSide& a, const EdgeSide& b)
            { return std::tie(a.nodes, a.prism) < std::tie(b.nodes, b.prism); });
  return sides;
}

/// \param normal_at  unit normal of a prism's face at area coordinates
/// \param shares     where along each edge to look, from its lower node
template <class NormalAt>
SkinCrease measure_crease(const MixedMesh& mesh, const std::vector<double>& shares,
                          const NormalAt& normal_at)
{
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  SkinCrease crease;
  double sum = 0;
  for (std::size_t s = 0; s + 1 < sides.size(); ++s)
  {
    if (sides[s].nodes != sides[s + 1].nodes)
      continue;
    ++crease.edges;
    for (const double share : shares)
    {
      std::array<Vec3, 2> normal;
      for (std::size_t k = 0; k < 2; ++k)
      {
        const EdgeSide& side = sides[s + k];
        normal[k] = normal_at(side.prism, (1 - share) * Vec3::Unit(side.corners[0]) +
                                              share * Vec3::Unit(side.corners[1]));
      }
      const double angle = degrees_per_radian *
                           std::atan2(normal[0].cross(normal[1]).norm(), normal[0].dot(normal[1]));
      sum += angle;
      if (angle > crease.max_deg)
      {
        crease.max_deg = angle;
        crease.worst = sides[s].nodes;
      }
    }
  }
  if (crease.edges)
    crease.mean_deg = sum / static_cast<double>(crease.edges * static_cast<long>(shares.size()));
  return crease;
}

} // namespace

SkinCrease linear_skin_crease(const MixedMesh& mesh, const std::vector<Vec3>& x)
{
  return measure_crease(mesh, {0.5},
                        [&](int prism, const Vec3&)
                        {
                          const auto& n = mesh.prisms[static_cast<std::size_t>(prism)];
                          const Vec3& origin = x[static_cast<std::size_t>(n[0])];
                          return Vec3((x[static_cast<std::size_t>(n[1])] - origin)
                                          .cross(x[static_cast<std::size_t>(n[2])] - origin)
                                          .stableNormalized());
                        });
}

SkinCrease smooth_skin_crease(const SmoothSkin& skin, const std::vector<Vec3>& x)
{
  return measure_crease(skin.mesh(), {0.1, 0.3, 0.5, 0.7, 0.9},
                        [&](int prism, const Vec3& L)
                        { return skin.surface_point(prism, L, x).normal; });
}

} // namespace f2b
