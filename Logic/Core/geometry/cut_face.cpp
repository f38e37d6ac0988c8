#include "Core/geometry/cut_face.hpp"

#include "Core/geometry/saw_blade.hpp"

#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

/// The first facet that passes between two neighbouring samples, and where; or null.
const SawFacet* between(const std::vector<SawFacet>& facets, const Vec3& p, const Vec3& q, Vec3& at)
{
  for (const SawFacet& facet : facets)
    if (facet.plane.separates(p, q, at))
      return &facet;
  return nullptr;
}

bool is_part(unsigned char label)
{
  return label != BonePartition::no_bone;
}

/// Visits every pair of neighbouring bone samples of which the first belongs to the part.
template <class Belongs>
std::vector<CutPoint> collect(const CutBone& cut, unsigned char part, Belongs other_belongs)
{
  std::vector<CutPoint> points;
  const LabelGrid& parts = cut.parts;
  const double facet_mm2 = parts.spacing * parts.spacing;
  const std::vector<SawFacet> facets = saw_facets(cut.osteotomies);
  const Eigen::Vector3i n = parts.size;
  auto visit = [&](const Eigen::Vector3i& v, int axis, int step)
  {
    Eigen::Vector3i w = v;
    w[axis] += step;
    if (w[axis] < 0 || w[axis] >= n[axis])
      return;
    const std::size_t next = parts.index(w.x(), w.y(), w.z());
    if (!other_belongs(parts.values[next]) || cut.bone.values[next] >= 0)
      return;
    const Vec3 p = parts.position(v.x(), v.y(), v.z());
    Vec3 at;
    const SawFacet* saw = between(facets, p, parts.position(w.x(), w.y(), w.z()), at);
    if (!saw)
      return;
    const Vec3 normal = saw->plane.normal();
    // the facets between samples are a staircase: each counts with its projection on the plane
    points.push_back({at, saw->plane.signed_distance(p) >= 0 ? normal : Vec3(-normal),
                      facet_mm2 * std::abs(normal[axis]), saw->kerf_mm});
  };
  for (int k = 0; k < n.z(); ++k)
    for (int j = 0; j < n.y(); ++j)
      for (int i = 0; i < n.x(); ++i)
      {
        const std::size_t voxel = parts.index(i, j, k);
        if (parts.values[voxel] != part || cut.bone.values[voxel] >= 0)
          continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int step : {-1, 1})
            visit({i, j, k}, axis, step);
      }
  return points;
}

} // namespace

std::vector<CutPoint> common_cut(const CutBone& cut, unsigned char part, unsigned char other)
{
  return collect(cut, part, [&](unsigned char label) { return label == other; });
}

std::vector<CutPoint> cuts_of(const CutBone& cut, unsigned char part)
{
  return collect(cut, part, [&](unsigned char label) { return is_part(label) && label != part; });
}

double distance_to_cut(const Vec3& p, const std::vector<CutPoint>& cuts, double spacing_mm)
{
  double nearest = std::numeric_limits<double>::infinity();
  const CutPoint* point = nullptr;
  for (const CutPoint& c : cuts)
    if (const double squared = (c.place - p).squaredNorm(); squared < nearest)
    {
      nearest = squared;
      point = &c;
    }
  if (!point)
    return nearest;
  const Vec3 d = p - point->place;
  const double along = std::abs(d.dot(point->normal));
  const double beside = std::sqrt(std::max(0.0, d.squaredNorm() - along * along));
  return (beside <= spacing_mm ? along : d.norm()) - 0.5 * point->kerf_mm;
}

} // namespace f2b
