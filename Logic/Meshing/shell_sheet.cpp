#include "Meshing/shell_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace f2b
{

namespace
{

/// Moves the triangles whose flag is not set from the sheet to the rest.
void keep_flagged(ShellFacets& facets, const std::vector<bool>& keep)
{
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < facets.skin.size(); ++t)
    (keep[t] ? kept : facets.rest).push_back(facets.skin[t]);
  facets.skin = std::move(kept);
}

/// Flags the triangles with the most frequent label.
std::vector<bool> largest_part(const std::vector<int>& labels)
{
  std::vector<int> count(labels.size() + 1, 0);
  for (const int label : labels)
    ++count[label];
  const auto largest = std::max_element(count.begin(), count.end()) - count.begin();
  std::vector<bool> result;
  for (const int label : labels)
    result.push_back(label == largest);
  return result;
}

/// Where fans touch in one node only, flags all but the fan with the most triangles as false.
std::vector<bool> without_touching_fans(const std::vector<Triangle>& sheet)
{
  std::map<int, std::vector<int>> fan_at;
  for (const int node : non_manifold_nodes(sheet))
    fan_at[node] = {};
  for (int t = 0; t < static_cast<int>(sheet.size()); ++t)
    for (const int node : sheet[t])
      if (const auto found = fan_at.find(node); found != fan_at.end())
        found->second.push_back(t);
  std::vector<bool> keep(sheet.size(), true);
  for (const auto& [node, members] : fan_at)
  {
    std::vector<Triangle> fan;
    for (const int t : members)
      fan.push_back(sheet[t]);
    const std::vector<bool> stays = largest_part(sheet_components(fan));
    for (std::size_t i = 0; i < members.size(); ++i)
      if (!stays[i])
        keep[members[i]] = false;
  }
  return keep;
}

/// One connected manifold sheet.
void clean(ShellFacets& facets)
{
  constexpr int most_passes = 20;
  for (int pass = 0; pass < most_passes && !facets.skin.empty(); ++pass)
  {
    const std::size_t before = facets.skin.size();
    keep_flagged(facets, largest_part(sheet_components(facets.skin)));
    keep_flagged(facets, without_touching_fans(facets.skin));
    if (facets.skin.size() == before)
      return;
  }
}

std::set<int> rim_nodes(const std::vector<Triangle>& triangles)
{
  std::set<int> result;
  for (const auto& loop : boundary_loops(triangles))
    result.insert(loop.begin(), loop.end());
  return result;
}

unsigned char walls_near(const Vec3& p, const RegionBox& box, double distance)
{
  unsigned char walls = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(p[axis] - box.lo[axis]) < distance)
      walls |= 1 << axis;
    if (std::abs(p[axis] - box.hi[axis]) < distance)
      walls |= 1 << (axis + 3);
  }
  return walls;
}

/// Facets that lean more towards a wall than along the skin.
void drop_chamfers(ShellFacets& facets, const TetrahedralMesh& mesh, const ShellDomain& domain,
                   double edge_mm)
{
  constexpr double least_cosine = 0.6;
  std::vector<bool> keep;
  for (const Triangle& n : facets.skin)
  {
    const Vec3 &a = mesh.X[n[0]], &b = mesh.X[n[1]], &c = mesh.X[n[2]];
    const Vec3 centre = (a + b + c) / 3.0;
    const double cosine =
        (b - a).cross(c - a).normalized().dot(domain.fields().skin.gradient(centre).normalized());
    keep.push_back(domain.wall_level(centre) < -edge_mm || cosine > least_cosine);
  }
  keep_flagged(facets, keep);
}

/// Facets whose corners would all be moved onto one wall.
bool drop_facets_within_walls(ShellFacets& facets, const TetrahedralMesh& mesh,
                              const ShellDomain& domain, double snap_mm)
{
  const std::set<int> rim = rim_nodes(facets.skin);
  const std::size_t before = facets.skin.size();
  std::vector<bool> keep;
  for (const Triangle& n : facets.skin)
  {
    int walls = 0b111111;
    for (const int node : n)
      walls &= rim.count(node) ? walls_near(mesh.X[node], domain.box(), snap_mm) : 0;
    keep.push_back(walls == 0);
  }
  keep_flagged(facets, keep);
  return facets.skin.size() < before;
}

/// To the walls and to depth zeta. False when no such place is near.
bool slide_to_rim(const ShellDomain& domain, unsigned char walls, Vec3& p)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (walls & (1 << axis))
      p[axis] = domain.box().lo[axis];
    if (walls & (1 << (axis + 3)))
      p[axis] = domain.box().hi[axis];
  }
  for (int iteration = 0; iteration < 8; ++iteration)
  {
    const double depth = domain.skin(p) + domain.zeta(p);
    if (std::abs(depth) < 0.01)
      return true;
    Vec3 gradient = domain.fields().skin.gradient(p);
    for (int axis = 0; axis < 3; ++axis)
      if (walls & (0b1001 << axis))
        gradient[axis] = 0.0;
    p -= std::clamp(depth / std::max(gradient.squaredNorm(), 0.05), -1.0, 1.0) * gradient;
  }
  return false;
}

/// The walls that the node lies on after it was moved towards them if it could be.
unsigned char snap_to_walls(TetStars& stars, int node, const ShellDomain& domain, double snap_mm,
                            double least_deg)
{
  const Vec3 before = stars.position(node);
  const unsigned char wanted = walls_near(before, domain.box(), snap_mm);
  Vec3 target = before;
  if (wanted && slide_to_rim(domain, wanted, target) && (target - before).norm() < 2.0 * snap_mm &&
      stars.move(node, target, least_deg))
    return wanted;
  return walls_near(before, domain.box(), 0.01);
}

} // namespace

ShellFacets shell_facets(const TetrahedralMesh& mesh, const ShellDomain& domain, double edge_mm)
{
  ShellFacets facets;
  for (const Triangle& n : tet_boundary(mesh.tets))
  {
    const Vec3 centre = (mesh.X[n[0]] + mesh.X[n[1]] + mesh.X[n[2]]) / 3.0;
    (domain.part(centre) == ShellPart::UnderSkin ? facets.skin : facets.rest).push_back(n);
  }
  if (facets.skin.empty())
    return facets;
  drop_chamfers(facets, mesh, domain, edge_mm);
  const std::size_t under_skin = facets.skin.size();
  clean(facets);
  facets.stray = static_cast<int>(under_skin - facets.skin.size());
  for (int pass = 0; pass < 5 && drop_facets_within_walls(facets, mesh, domain, 0.6 * edge_mm);
       ++pass)
    clean(facets);
  return facets;
}

void drop_from_sheet(ShellFacets& facets, const std::vector<int>& dropped)
{
  std::vector<bool> keep(facets.skin.size(), true);
  for (const int t : dropped)
    keep[t] = false;
  keep_flagged(facets, keep);
  clean(facets);
}

ShellSheet shell_sheet(TetStars& stars, const ShellFacets& facets, const ShellDomain& domain,
                       double snap_mm, double least_deg)
{
  ShellSheet sheet;
  std::map<int, int> number;
  for (const Triangle& triangle : facets.skin)
    for (const int node : triangle)
      number.emplace(node, 0);
  const std::set<int> rim = rim_nodes(facets.skin);
  for (auto& [node, index] : number)
  {
    index = static_cast<int>(sheet.tet_node.size());
    const bool on_rim = rim.count(node) > 0;
    sheet.tet_node.push_back(node);
    sheet.rim.push_back(on_rim);
    sheet.prisms.walls.push_back(on_rim ? snap_to_walls(stars, node, domain, snap_mm, least_deg)
                                        : 0);
    sheet.prisms.bottom.push_back(stars.position(node));
  }
  for (const Triangle& n : facets.skin)
    sheet.prisms.triangles.push_back({number[n[0]], number[n[1]], number[n[2]]});
  return sheet;
}

} // namespace f2b
