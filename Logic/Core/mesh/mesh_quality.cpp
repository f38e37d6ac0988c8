#include "Core/mesh/mesh_quality.hpp"

#include "Core/mesh/boundary_facets.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

constexpr double degrees_per_radian = 57.29577951308232;

double unit_determinant(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double scale = a.norm() * b.norm() * c.norm();
  return scale > 0.0 ? a.cross(b).dot(c) / scale : 0.0;
}

/// Jacobian determinant at area coordinates (1 - l1 - l2, l1, l2) and height t in [-1, 1].
double jacobian_at(const PrismCorners& x, double l1, double l2, double t)
{
  const double up = 0.5 * (1.0 + t), down = 0.5 * (1.0 - t);
  const Vec3 d1 = up * (x[1] - x[0]) + down * (x[4] - x[3]);
  const Vec3 d2 = up * (x[2] - x[0]) + down * (x[5] - x[3]);
  const double l0 = 1.0 - l1 - l2;
  const Vec3 d3 = 0.5 * (l0 * (x[0] - x[3]) + l1 * (x[1] - x[4]) + l2 * (x[2] - x[5]));
  return d1.cross(d2).dot(d3);
}

void add_tet(MeshQuality& quality, const MixedMesh& mesh, int tet)
{
  const auto& n = mesh.tets[tet];
  const Vec3 &a = mesh.X[n[0]], &b = mesh.X[n[1]], &c = mesh.X[n[2]], &d = mesh.X[n[3]];
  const double volume = tet_volume6(a, b, c, d) / 6.0;
  const double angle = min_dihedral_deg(a, b, c, d);
  quality.tet_volume += volume;
  quality.min_tet_volume = std::min(quality.min_tet_volume, volume);
  quality.inverted_elements += !(volume > 0.0);
  const int bin = static_cast<int>(std::max(angle, 0.0) / MeshQuality::bin_deg);
  ++quality.dihedral_histogram[std::min(bin, MeshQuality::bin_count - 1)];
  if (angle < quality.min_dihedral_deg)
  {
    quality.min_dihedral_deg = angle;
    quality.worst_tet = tet;
  }
}

void add_prism(MeshQuality& quality, const MixedMesh& mesh, int prism)
{
  const PrismCorners x = prism_corners(mesh, prism);
  const double scaled = min_scaled_jacobian(x);
  const auto jacobians = quadrature_jacobians(x);
  const double least = *std::min_element(jacobians.begin(), jacobians.end());
  quality.prism_volume += prism_volume(x);
  quality.min_quadrature_jacobian = std::min(quality.min_quadrature_jacobian, least);
  quality.inverted_elements += !(least > 0.0 && scaled > 0.0);
  if (scaled < quality.min_scaled_jacobian)
  {
    quality.min_scaled_jacobian = scaled;
    quality.worst_prism = prism;
  }
}

} // namespace

double min_dihedral_deg(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  if (!(tet_volume6(a, b, c, d) > 0.0))
    return -1.0;
  // Outward area vectors of the faces opposite to a, b, c, d; the dihedral angle between two faces
  // is pi minus the angle between their normals.
  const std::array<Vec3, 4> normal = {
      (c - b).cross(d - b).normalized(), (d - a).cross(c - a).normalized(),
      (b - a).cross(d - a).normalized(), (c - a).cross(b - a).normalized()};
  double largest_cosine = -1.0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      largest_cosine = std::max(largest_cosine, -normal[i].dot(normal[j]));
  return std::acos(std::clamp(largest_cosine, -1.0, 1.0)) * degrees_per_radian;
}

double min_scaled_jacobian(const PrismCorners& x)
{
  double least = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3, previous = (i + 2) % 3;
    const Vec3 up = x[i] - x[i + 3];
    least = std::min(least, unit_determinant(x[next] - x[i], x[previous] - x[i], up));
    least =
        std::min(least, unit_determinant(x[next + 3] - x[i + 3], x[previous + 3] - x[i + 3], up));
  }
  return least;
}

std::array<double, 6> quadrature_jacobians(const PrismCorners& x)
{
  constexpr double t = 0.5773502691896257; // 1 / sqrt(3)
  constexpr double near = 1.0 / 6.0, far = 2.0 / 3.0;
  return {jacobian_at(x, near, near, -t), jacobian_at(x, far, near, -t),
          jacobian_at(x, near, far, -t),  jacobian_at(x, near, near, t),
          jacobian_at(x, far, near, t),   jacobian_at(x, near, far, t)};
}

double prism_volume(const PrismCorners& x)
{
  // Exact: the determinant is linear in the area coordinates and quadratic in the height.
  double sum = 0.0;
  for (const double jacobian : quadrature_jacobians(x))
    sum += jacobian;
  return sum / 6.0;
}

PrismCorners prism_corners(const MixedMesh& mesh, int prism)
{
  PrismCorners x;
  for (int i = 0; i < 6; ++i)
    x[i] = mesh.X[mesh.prisms[prism][i]];
  return x;
}

int unmatched_inner_faces(const MixedMesh& mesh)
{
  const std::vector<TetFace> faces = sorted_tet_faces(mesh.tets);
  const auto before = [](const TetFace& a, const TetFace& b) { return a.key < b.key; };
  int unmatched = 0;
  for (const auto& prism : mesh.prisms)
  {
    TetFace wanted;
    wanted.key = {prism[3], prism[4], prism[5]};
    std::sort(wanted.key.begin(), wanted.key.end());
    const auto range = std::equal_range(faces.begin(), faces.end(), wanted, before);
    unmatched += range.second - range.first != 1;
  }
  return unmatched;
}

MeshQuality measure_quality(const MixedMesh& mesh)
{
  MeshQuality quality;
  for (int tet = 0; tet < static_cast<int>(mesh.tets.size()); ++tet)
    add_tet(quality, mesh, tet);
  for (int prism = 0; prism < static_cast<int>(mesh.prisms.size()); ++prism)
    add_prism(quality, mesh, prism);
  quality.unmatched_inner_faces = unmatched_inner_faces(mesh);
  return quality;
}

} // namespace f2b
