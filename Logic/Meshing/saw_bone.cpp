#include "Meshing/saw_bone.hpp"

#include "Meshing/cgal_surface.hpp"
#include "Meshing/surface_shells.hpp"

#include "Core/error.hpp"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

namespace f2b
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;
using Box = Eigen::AlignedBox3d;

/// What a volume may be off by before the cut is done anew.
constexpr double largest_imbalance = 1e-6;

Box box_of(const TriangleMesh& mesh)
{
  Box box;
  for (const Vec3& p : mesh.points)
    box.extend(p);
  return box;
}

/// The bone's shells that blades may meet, and the others.
struct Reach
{
  TriangleMesh near, far;
};

Reach split_by_reach(const TriangleMesh& bone, const std::vector<TriangleMesh>& blades)
{
  const SurfaceShells shells = surface_shells(bone);
  std::vector<Box> boxes(shells.volume.size());
  for (std::size_t t = 0; t < bone.triangles.size(); ++t)
    for (const int corner : bone.triangles[t])
      boxes[static_cast<std::size_t>(shells.of[t])].extend(
          bone.points[static_cast<std::size_t>(corner)]);
  std::vector<Box> blade_boxes;
  for (const TriangleMesh& blade : blades)
  {
    blade_boxes.push_back(box_of(blade));
    // a blade may be moved a little
    blade_boxes.back().min().array() -= 0.2;
    blade_boxes.back().max().array() += 0.2;
  }
  std::vector<char> near(bone.triangles.size()), far(bone.triangles.size());
  for (std::size_t t = 0; t < near.size(); ++t)
  {
    for (const Box& box : blade_boxes)
      near[t] |= box.intersects(boxes[static_cast<std::size_t>(shells.of[t])]);
    far[t] = !near[t];
  }
  return {submesh(bone, near), submesh(bone, far)};
}

CgalSurface manifold_from(const TriangleMesh& mesh, const std::string& what)
{
  std::size_t refused = 0;
  CgalSurface surface = to_cgal(mesh, refused);
  if (refused > 0 || !CGAL::is_closed(surface))
    throw Error(what,
                refused > 0
                    ? std::to_string(refused) + " of its triangles are not those of a manifold"
                    : std::string("it is open"),
                "repair the surface, or make it anew with 'facetobone segment'");
  return surface;
}

/// The blades in one piece, each moved and widened by less than `jitter_mm`, so that no two share a
/// face.
std::optional<CgalSurface> joined(const std::vector<TriangleMesh>& blades, double jitter_mm,
                                  std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  CgalSurface all;
  for (const TriangleMesh& blade : blades)
  {
    const Vec3 centre = box_of(blade).center();
    const Vec3 shift = jitter_mm * Vec3(unit(random), unit(random), unit(random));
    const double reach = std::max(1.0, box_of(blade).diagonal().norm());
    const Mat3 turn =
        Eigen::Quaterniond(1, jitter_mm / reach * unit(random), jitter_mm / reach * unit(random),
                           jitter_mm / reach * unit(random))
            .normalized()
            .toRotationMatrix();
    TriangleMesh moved = blade;
    for (Vec3& p : moved.points)
      p = centre + turn * (p - centre) + shift;
    CgalSurface next = manifold_from(moved, "saw blade");
    if (all.is_empty())
      all = std::move(next);
    else
    {
      CgalSurface both;
      if (!PMP::corefine_and_compute_union(all, next, both,
                                           CGAL::parameters::throw_on_self_intersection(true)))
        return std::nullopt;
      all = std::move(both);
    }
  }
  return all;
}

/// The same triangles in an order of their own: CGAL's depends on where the heap has put its meshes,
/// and the last digits of sums over them would, too.
TriangleMesh in_order(const TriangleMesh& mesh)
{
  std::vector<int> order(mesh.points.size()), place(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int v)
  {
    const Vec3& p = mesh.points[static_cast<std::size_t>(v)];
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  TriangleMesh sorted;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    sorted.points.push_back(mesh.points[static_cast<std::size_t>(order[i])]);
  }
  for (Triangle t : mesh.triangles)
  {
    for (int& corner : t)
      corner = place[static_cast<std::size_t>(corner)];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    sorted.triangles.push_back(t);
  }
  std::sort(sorted.triangles.begin(), sorted.triangles.end());
  return sorted;
}

struct Difference
{
  TriangleMesh left, taken;
};

std::optional<Difference> difference(const CgalSurface& bone,
                                     const std::vector<TriangleMesh>& blades, double jitter_mm,
                                     std::mt19937& random)
{
  try
  {
    std::optional<CgalSurface> blade = joined(blades, jitter_mm, random);
    if (!blade)
      return std::nullopt;
    CgalSurface whole = bone, left, taken;
    std::array<boost::optional<CgalSurface*>, 4> wanted;
    wanted[PMP::Corefinement::TM1_MINUS_TM2] = &left;
    wanted[PMP::Corefinement::INTERSECTION] = &taken;
    const auto done = PMP::corefine_and_compute_boolean_operations(
        whole, *blade, wanted, CGAL::parameters::throw_on_self_intersection(true));
    if (!done[PMP::Corefinement::TM1_MINUS_TM2] || !done[PMP::Corefinement::INTERSECTION] ||
        !CGAL::is_closed(left) || !CGAL::is_closed(taken))
      return std::nullopt;
    return Difference{in_order(from_cgal(left)), in_order(from_cgal(taken))};
  }
  catch (const PMP::Corefinement::Self_intersection_exception&)
  {
    return std::nullopt;
  }
}

SawnBone sawn(const TriangleMesh& far, const Difference& difference, double bone_mm3)
{
  SawnBone result;
  result.bone_mm3 = bone_mm3;
  result.kerf_mm3 = difference.taken.points.empty() ? 0 : signed_volume(difference.taken);
  result.met = !difference.taken.triangles.empty();
  result.surface = far;
  append(result.surface, difference.left);
  SurfaceShells shells = surface_shells(result.surface);
  result.shell = std::move(shells.of);
  result.shell_volume = std::move(shells.volume);
  return result;
}

} // namespace

double SawnBone::left_mm3() const
{
  double sum = 0;
  for (const double volume : shell_volume)
    sum += volume;
  return sum;
}

double SawnBone::imbalance() const
{
  return std::abs(left_mm3() + kerf_mm3 - bone_mm3) / bone_mm3;
}

SawnBone saw_bone(const TriangleMesh& bone, const std::vector<TriangleMesh>& blades)
{
  const double bone_mm3 = bone.points.empty() ? 0 : signed_volume(bone);
  const Reach reach = split_by_reach(bone, blades);
  if (reach.near.triangles.empty())
    return sawn(bone, {}, bone_mm3);
  const CgalSurface near = manifold_from(reach.near, "bone surface");
  std::mt19937 random(1);
  // exact predicates need no luck but where input meets itself: then a hair's breadth helps
  for (const double jitter_mm : {blades.size() > 1 ? 2e-4 : 0.0, 1e-3, 1e-2, 0.05, 0.1})
    if (const auto done = difference(near, blades, jitter_mm, random))
    {
      SawnBone result = sawn(reach.far, *done, bone_mm3);
      if (result.imbalance() < largest_imbalance)
        return result;
    }
  throw Error("bone surface", "sawing it gave no closed pieces whose volumes add up",
              "move or turn the cut a little, or widen its kerf", ErrorKind::Numerical);
}

TriangleMesh shells_of(const SawnBone& sawn, const std::vector<char>& wanted)
{
  std::vector<char> triangles(sawn.shell.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    triangles[t] = wanted[static_cast<std::size_t>(sawn.shell[t])];
  return submesh(sawn.surface, triangles);
}

} // namespace f2b
