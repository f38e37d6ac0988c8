#include "Case/cut_surfaces.hpp"

#include "Core/geometry/saw_blade.hpp"
#include "Core/mesh/contact.hpp"
#include "Core/sculpting/surface_links.hpp"
#include "Meshing/saw_bone.hpp"
#include "Meshing/surface_shells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <optional>

namespace f2b
{
namespace
{

std::vector<TriangleMesh> blades_of(const std::vector<Osteotomy>& osteotomies)
{
  std::vector<TriangleMesh> blades;
  for (const Osteotomy& osteotomy : osteotomies)
  {
    for (const BoundedPlane& plane : osteotomy.planes)
      blades.push_back(blade_of(plane, osteotomy.kerf_mm));
    for (const SweptCurve& curve : osteotomy.curves)
      blades.push_back(blade_of(curve, osteotomy.kerf_mm));
  }
  return blades;
}

/// How much of a shell's area lies on each part of the bone, and where.
struct Shares
{
  std::vector<double> area;          ///< where the lattice tells the parts apart
  std::vector<double> near_cuts;     ///< where it does not
  std::vector<std::size_t> triangle; ///< one of `area`
};

/// The part just below a triangle.
unsigned char part_below(const Vec3& middle, const Vec3& inwards, const LabelGrid& labels)
{
  const unsigned char label = labels.nearest(middle + 0.7 * labels.spacing * inwards);
  return label != BonePartition::no_bone ? label : nearest_bone(labels, middle);
}

/// Within a lattice step of a saw's wall, the lattice does not tell on which side of it a point lies.
bool is_near_cut(const Vec3& p, double step_mm, const std::vector<SawFacet>& facets)
{
  return std::any_of(facets.begin(), facets.end(),
                     [&](const SawFacet& facet)
                     {
                       const double reach = step_mm + 0.5 * facet.kerf_mm;
                       return std::abs(facet.plane.signed_distance(p)) < reach &&
                              facet.plane.faces(p, reach);
                     });
}

std::vector<Shares> shares_of(const SawnBone& sawn, const BonePartition& partition,
                              const std::vector<SawFacet>& facets)
{
  const std::size_t parts = 1 + partition.osteotomies.size();
  std::vector<Shares> shares(sawn.shell_volume.size(),
                             {std::vector<double>(parts, 0), std::vector<double>(parts, 0),
                              std::vector<std::size_t>(parts)});
  for (std::size_t t = 0; t < sawn.shell.size(); ++t)
  {
    const Triangle& corners = sawn.surface.triangles[t];
    const Vec3 &a = sawn.surface.points[static_cast<std::size_t>(corners[0])],
               &b = sawn.surface.points[static_cast<std::size_t>(corners[1])],
               &c = sawn.surface.points[static_cast<std::size_t>(corners[2])];
    const Vec3 outwards = (b - a).cross(c - a);
    const double doubled = outwards.norm();
    if (!(doubled > 0))
      continue;
    const Vec3 middle = (a + b + c) / 3;
    const auto part = static_cast<std::size_t>(
        part_below(middle, -outwards / doubled, partition.labels) - BonePartition::uncut);
    Shares& s = shares[static_cast<std::size_t>(sawn.shell[t])];
    if (is_near_cut(middle, 1.5 * partition.labels.spacing, facets))
    {
      s.near_cuts[part] += 0.5 * doubled;
      continue;
    }
    s.area[part] += 0.5 * doubled;
    s.triangle[part] = t;
  }
  return shares;
}

std::string part_name(std::size_t part, const BonePartition& partition)
{
  return part == 0 ? std::string("the bone that stays")
                   : "'" + partition.osteotomies[part - 1].fragment + "'";
}

std::size_t owner(const Shares& shares)
{
  const double told = std::accumulate(shares.area.begin(), shares.area.end(), 0.0);
  const std::vector<double>& area = told > 0 ? shares.area : shares.near_cuts;
  return static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
}

/// Vertices from one triangle of a surface to another of the same shell, as few as there can be.
std::vector<int> way_between(const TriangleMesh& surface, std::size_t from, std::size_t to)
{
  const SurfaceLinks links(surface.points.size(), surface.triangles);
  const int start = surface.triangles[from][0], end = surface.triangles[to][0];
  std::vector<int> before(surface.points.size(), -1);
  std::vector<int> front = {start};
  before[static_cast<std::size_t>(start)] = start;
  for (std::size_t next = 0; next < front.size() && before[static_cast<std::size_t>(end)] < 0;
       ++next)
    for (const int other : links.neighbours_of(front[next]))
      if (int& b = before[static_cast<std::size_t>(other)]; b < 0)
      {
        b = front[next];
        front.push_back(other);
      }
  std::vector<int> way = {end};
  while (way.back() != start)
    way.push_back(before[static_cast<std::size_t>(way.back())]);
  return way;
}

/// Where a way over the surface passes a saw's plane beside its edge, next to that edge, and gets from
/// one part to another.
void find_passage(const TriangleMesh& surface, const std::vector<int>& way, const LabelGrid& labels,
                  const std::vector<SawFacet>& facets, BoneBridge& bridge)
{
  constexpr std::size_t around = 8; // steps in which the part changes
  std::vector<unsigned char> part;
  for (const int v : way)
    part.push_back(nearest_bone(labels, surface.points[static_cast<std::size_t>(v)]));
  bridge.place = surface.points[static_cast<std::size_t>(way.front())];
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t step = 1; step < way.size(); ++step)
  {
    if (part[step - std::min(step, around)] == part[std::min(step + around, way.size() - 1)])
      continue;
    const Vec3 &p = surface.points[static_cast<std::size_t>(way[step - 1])],
               &q = surface.points[static_cast<std::size_t>(way[step])];
    for (const SawFacet& facet : facets)
    {
      const double a = facet.plane.signed_distance(p), b = facet.plane.signed_distance(q);
      if ((a >= 0) == (b >= 0))
        continue;
      const Vec3 at = p + (q - p) * (a / (a - b)), d = at - facet.plane.center;
      const double beside = std::max(std::abs(d.dot(facet.plane.u)) - facet.plane.half_u,
                                     std::abs(d.dot(facet.plane.v)) - facet.plane.half_v);
      if (beside < nearest)
      {
        nearest = beside;
        bridge.place = at;
        bridge.cut = facet.plane.name;
      }
    }
  }
}

/// Of a shell that two parts share.
std::optional<BoneBridge> bridge_in(const Shares& shares, const TriangleMesh& surface,
                                    const LabelGrid& labels, const std::vector<SawFacet>& facets)
{
  // walls of cavities may be ascribed to the wrong side of a cut
  constexpr double tolerated_mm2 = 60, tolerated_share = 0.05;
  const std::size_t most = owner(shares);
  for (std::size_t part = 0; part < shares.area.size(); ++part)
    if (part != most && shares.area[part] > tolerated_mm2 &&
        shares.area[part] > tolerated_share * shares.area[most])
    {
      BoneBridge bridge;
      bridge.part = most;
      bridge.other = part;
      find_passage(surface, way_between(surface, shares.triangle[part], shares.triangle[most]),
                   labels, facets, bridge);
      return bridge;
    }
  return std::nullopt;
}

} // namespace

Error bridge_error(const BoneBridge& bridge, const BonePartition& partition)
{
  char place[64];
  std::snprintf(place, sizeof place, "(%.0f, %.0f, %.0f)", bridge.place.x(), bridge.place.y(),
                bridge.place.z());
  return {"cut",
          "a bridge of bone is left between " + part_name(bridge.part, partition) + " and " +
              part_name(bridge.other, partition) + ", beside the cut '" + bridge.cut +
              "' near RAS " + place,
          "enlarge the cut there, or widen its kerf"};
}

std::variant<CutSurfaces, BoneBridge> cut_surfaces(const TriangleMesh& bone,
                                                   const BonePartition& partition)
{
  const SawnBone sawn = saw_bone(bone, blades_of(partition.osteotomies));
  std::vector<std::size_t> owners;
  const std::vector<SawFacet> facets = saw_facets(partition.osteotomies);
  for (const Shares& shares : shares_of(sawn, partition, facets))
  {
    if (const auto bridge = bridge_in(shares, sawn.surface, partition.labels, facets))
      return *bridge;
    owners.push_back(owner(shares));
  }
  CutSurfaces result;
  result.bone_mm3 = sawn.bone_mm3;
  result.kerf_mm3 = sawn.kerf_mm3;
  result.imbalance = sawn.imbalance();
  for (std::size_t part = 0; part <= partition.osteotomies.size(); ++part)
  {
    std::vector<char> wanted;
    for (const std::size_t of : owners)
      wanted.push_back(of == part);
    result.parts.push_back(shells_of(sawn, wanted));
    result.volume_mm3.push_back(
        result.parts.back().points.empty() ? 0 : signed_volume(result.parts.back()));
  }
  return result;
}

} // namespace f2b
