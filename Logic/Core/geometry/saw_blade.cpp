#include "Core/geometry/saw_blade.hpp"

#include "Core/geometry/saw_track.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

double signed_volume(const TriangleMesh& mesh)
{
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
  {
    const Vec3& a = mesh.points[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.points[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.points[static_cast<std::size_t>(t[2])];
    sum += (a - mesh.points[0]).dot((b - mesh.points[0]).cross(c - mesh.points[0])) / 6;
  }
  return sum;
}

void add_quad(TriangleMesh& mesh, int a, int b, int c, int d)
{
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Tiles of a blade are no longer than this: boxes around long oblique triangles hold most of a skull,
/// and everything in them would be tested against them.
constexpr double tile_mm = 10;

int tiles(double length_mm)
{
  return std::max(1, static_cast<int>(std::ceil(length_mm / tile_mm)));
}

/// A blade's cross-section at one place of its course: from its start to its end.
struct Section
{
  Vec3 left_start, left_end, right_start, right_end;
};

/// The closed surface around sections that follow one another.
TriangleMesh around(const std::vector<Section>& sections, int levels, bool closed)
{
  TriangleMesh mesh;
  const int side = levels + 1, ring = 2 * side;
  auto between = [&](const Vec3& start, const Vec3& end, int level)
  { return Vec3(start + (double(level) / levels) * (end - start)); };
  for (const Section& s : sections)
  {
    for (int level = 0; level <= levels; ++level)
      mesh.points.push_back(between(s.left_start, s.left_end, level));
    for (int level = levels; level >= 0; --level)
      mesh.points.push_back(between(s.right_start, s.right_end, level));
  }
  const int count = static_cast<int>(sections.size());
  for (int r = 0; r < (closed ? count : count - 1); ++r)
  {
    const int here = ring * r, next = ring * ((r + 1) % count);
    for (int c = 0; c < ring; ++c)
    {
      const int d = (c + 1) % ring;
      add_quad(mesh, here + c, here + d, next + d, next + c);
    }
  }
  for (int level = 0; !closed && level < levels; ++level)
  {
    const int last = ring * (count - 1), across = ring - 1 - level;
    add_quad(mesh, across, across - 1, level + 1, level);
    add_quad(mesh, last + level, last + level + 1, last + across - 1, last + across);
  }
  if (signed_volume(mesh) < 0)
    for (Triangle& t : mesh.triangles)
      std::swap(t[1], t[2]);
  return mesh;
}

} // namespace

TriangleMesh blade_of(const BoundedPlane& plane, double kerf_mm)
{
  const Vec3 half = 0.5 * std::max(kerf_mm, thinnest_kerf_mm) * plane.normal(),
             v = plane.half_v * plane.v;
  const int along = tiles(2 * plane.half_u);
  std::vector<Section> sections;
  for (int i = 0; i <= along; ++i)
  {
    const Vec3 middle = plane.center + (2.0 * i / along - 1) * plane.half_u * plane.u;
    sections.push_back(
        {middle + half - v, middle + half + v, middle - half - v, middle - half + v});
  }
  return around(sections, tiles(2 * plane.half_v), false);
}

TriangleMesh blade_of(const SweptCurve& curve, double kerf_mm)
{
  const SawTrack track(curve, std::max(kerf_mm, thinnest_kerf_mm));
  std::vector<Section> sections;
  for (const SawTrack::Station& s : track.stations())
  {
    const double start = s.height - curve.lead_mm, end = s.height + curve.depth_mm;
    sections.push_back({track.point(s.left, start), track.point(s.left, end),
                        track.point(s.right, start), track.point(s.right, end)});
  }
  return around(sections, tiles(curve.lead_mm + curve.depth_mm), curve.closed);
}

std::vector<BoundedPlane> facets_of(const SweptCurve& curve)
{
  const SawTrack track(curve, thinnest_kerf_mm);
  const auto& stations = track.stations();
  const std::size_t n = stations.size();
  std::vector<BoundedPlane> facets;
  for (std::size_t i = 0; i < (curve.closed ? n : n - 1); ++i)
  {
    const SawTrack::Station &a = stations[i], &b = stations[(i + 1) % n];
    const double start = std::min(a.height, b.height) - curve.lead_mm;
    const double end = std::max(a.height, b.height) + curve.depth_mm;
    BoundedPlane facet;
    facet.name = curve.name;
    facet.u = track.direction((b.middle - a.middle).normalized());
    facet.v = curve.direction.normalized();
    facet.center = track.point(0.5 * (a.middle + b.middle), 0.5 * (start + end));
    facet.half_u = 0.5 * (b.middle - a.middle).norm();
    facet.half_v = 0.5 * (end - start);
    facets.push_back(facet);
  }
  return facets;
}

std::vector<SawFacet> saw_facets(const std::vector<Osteotomy>& osteotomies)
{
  std::vector<SawFacet> facets;
  std::size_t cut = 0;
  for (std::size_t k = 0; k < osteotomies.size(); ++k)
  {
    const Osteotomy& osteotomy = osteotomies[k];
    for (const BoundedPlane& plane : osteotomy.planes)
      facets.push_back({plane, k, cut++, osteotomy.kerf_mm});
    for (const SweptCurve& curve : osteotomy.curves)
    {
      for (const BoundedPlane& plane : facets_of(curve))
        facets.push_back({plane, k, cut, osteotomy.kerf_mm});
      ++cut;
    }
  }
  return facets;
}

} // namespace f2b
