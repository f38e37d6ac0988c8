#include "Core/geometry/trimmed_cuts.hpp"

#include "Core/geometry/saw_blade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

/// An interval of a plane's axis.
struct Extent
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return !(low <= high); }
};

/// Shrinks a side of the rectangle to an extent about its centre; never grows it.
void shrink(const Vec3& axis, const Extent& extent, double margin_mm, Vec3& center, double& half)
{
  const double low = std::max(-half, extent.low - margin_mm),
               high = std::min(half, extent.high + margin_mm);
  center += 0.5 * (low + high) * axis;
  half = 0.5 * (high - low);
}

/// False where the plane parts nothing.
bool trim(BoundedPlane& plane, const BonePartition& partition, double margin_mm)
{
  constexpr double on_plane_mm = 1e-6;
  Extent u, v;
  for (const std::vector<Vec3>& points : partition.cut_points)
    for (const Vec3& p : points)
      if (std::abs(plane.signed_distance(p)) < on_plane_mm && plane.faces(p, on_plane_mm))
      {
        u.add((p - plane.center).dot(plane.u));
        v.add((p - plane.center).dot(plane.v));
      }
  if (u.empty())
    return false;
  Vec3 center = plane.center;
  shrink(plane.u, u, margin_mm, center, plane.half_u);
  shrink(plane.v, v, margin_mm, center, plane.half_v);
  plane.center = center;
  return true;
}

/// To the rectangle itself [mm].
double distance_to(const BoundedPlane& plane, const Vec3& p)
{
  const Vec3 d = p - plane.center;
  const double across = d.dot(plane.normal()),
               u = std::max(0.0, std::abs(d.dot(plane.u)) - plane.half_u),
               v = std::max(0.0, std::abs(d.dot(plane.v)) - plane.half_v);
  return std::sqrt(across * across + u * u + v * v);
}

} // namespace

std::vector<Osteotomy> trimmed_cuts(const BonePartition& partition, double margin_mm)
{
  std::vector<Osteotomy> osteotomies = partition.osteotomies;
  for (Osteotomy& osteotomy : osteotomies)
  {
    std::vector<BoundedPlane>& planes = osteotomy.planes;
    planes.erase(std::remove_if(planes.begin(), planes.end(),
                                [&](BoundedPlane& plane)
                                { return !trim(plane, partition, margin_mm); }),
                 planes.end());
  }
  return osteotomies;
}

SawClearance saw_clearance(const std::vector<Vec3>& structure,
                           const std::vector<Osteotomy>& osteotomies)
{
  SawClearance nearest;
  nearest.distance_mm = std::numeric_limits<double>::infinity();
  for (const SawFacet& facet : saw_facets(osteotomies))
    for (const Vec3& p : structure)
    {
      const double distance = distance_to(facet.plane, p) - 0.5 * facet.kerf_mm;
      if (distance < nearest.distance_mm)
        nearest = {distance, p,
                   "'" + facet.plane.name + "' of '" + osteotomies[facet.osteotomy].fragment + "'"};
    }
  return nearest;
}

} // namespace f2b
