#include "Bridge/vtk_surface.hpp"
#include "Case/case_session.hpp"
#include "Core/error.hpp"
#include "Core/geometry/saw_blade.hpp"
#include "Meshing/isosurface.hpp"
#include "Meshing/saw_bone.hpp"
#include "Meshing/surface_shells.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <random>

/// Are seeded random cuts of a real skull closed pieces whose volumes add up?
///
/// `random_cuts BONE.vtp COUNT [SEED]` prints JSON: counts, the worst imbalance, times, refusals with
/// their reason. Planes (whole or ending inside bone) and curves drawn on the bone; kerf 0 to 1 mm.

namespace
{

using namespace f2b;
using nlohmann::json;

class CutSampler
{
public:
  CutSampler(const TriangleMesh& bone, unsigned seed) : m_bone(bone), m_random(seed) {}

  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double kerf() { return between(0, 1) < 0.15 ? 0.0 : between(0, 1); }
  Vec3 direction()
  {
    std::normal_distribution<double> normal;
    return Vec3(normal(m_random), normal(m_random), normal(m_random)).normalized();
  }

  /// A rectangle about a place on the bone; every second one is too small to go through.
  BoundedPlane plane(bool ends_inside)
  {
    BoundedPlane plane;
    const Place place = on_bone();
    const Vec3 normal = direction();
    plane.u = normal.unitOrthogonal();
    plane.v = normal.cross(plane.u);
    plane.center = place.point;
    plane.half_u = ends_inside ? between(3, 25) : between(60, 300);
    plane.half_v = ends_inside ? between(3, 25) : between(60, 300);
    return plane;
  }

  /// Five points along a tangent of the bone, off it by a few millimetres, sawn inwards.
  SweptCurve curve(bool ends_inside)
  {
    const Place place = on_bone();
    SweptCurve curve;
    curve.name = "random";
    curve.direction = (-place.normal + 0.3 * direction()).normalized();
    const Vec3 along = curve.direction.cross(direction()).normalized();
    const Vec3 beside = along.cross(curve.direction);
    const double length = ends_inside ? between(8, 30) : between(40, 120);
    std::vector<Vec3> drawn;
    for (int i = -2; i <= 2; ++i)
      drawn.push_back(place.point + 0.25 * length * i * along +
                      between(-0.08, 0.08) * length * beside + between(-3, 3) * curve.direction);
    curve.points = resampled_curve(drawn, false, between(0, 1) < 0.3, 1.0);
    curve.depth_mm = ends_inside ? between(1, 10) : between(20, 120);
    curve.lead_mm = between(5, 15);
    return curve;
  }

private:
  struct Place
  {
    Vec3 point, normal; ///< outwards
  };
  Place on_bone()
  {
    const auto t =
        std::uniform_int_distribution<std::size_t>(0, m_bone.triangles.size() - 1)(m_random);
    const Triangle& corners = m_bone.triangles[t];
    const Vec3 &a = m_bone.points[static_cast<std::size_t>(corners[0])],
               &b = m_bone.points[static_cast<std::size_t>(corners[1])],
               &c = m_bone.points[static_cast<std::size_t>(corners[2])];
    const Vec3 normal = (b - a).cross(c - a);
    if (!(normal.norm() > 1e-9))
      return on_bone();
    return {(a + b + c) / 3, normal.normalized()};
  }

  const TriangleMesh& m_bone;
  std::mt19937 m_random;
};

struct Tally
{
  int met = 0, missed = 0, closed = 0, planes = 0, plane_refusals = 0, parted = 0;
  double worst_imbalance = 0, seconds = 0, longest_s = 0;
  json refusals = json::array();
};

/// Edges counted anew, by code that shares nothing with the cutting.
bool is_watertight(const SawnBone& sawn)
{
  const SurfaceCheck check = check_surface(to_polydata(sawn.surface));
  return check.watertight();
}

void try_cut(const TriangleMesh& bone, const std::string& what, bool is_plane, std::size_t shells,
             const TriangleMesh& blade, Tally& tally)
{
  const Stopwatch watch;
  const SawnBone sawn = saw_bone(bone, {blade});
  const double seconds = watch.seconds();
  tally.seconds += seconds;
  tally.longest_s = std::max(tally.longest_s, seconds);
  if (!sawn.met)
  {
    ++tally.missed;
    return;
  }
  ++tally.met;
  tally.planes += is_plane;
  tally.parted += sawn.shell_volume.size() > shells;
  tally.worst_imbalance = std::max(tally.worst_imbalance, sawn.imbalance());
  if (is_watertight(sawn) && sawn.imbalance() < 1e-3)
    ++tally.closed;
  else
    tally.refusals.push_back(what + ": open, or its volumes do not add up");
}

json run(const TriangleMesh& bone, int count, unsigned seed)
{
  CutSampler sample(bone, seed);
  Tally tally;
  const std::size_t shells = surface_shells(bone).volume.size();
  for (int i = 0; i < count; ++i)
  {
    const bool is_plane = i % 2 == 0, ends_inside = i % 4 >= 2;
    const double kerf = sample.kerf();
    char what[80];
    std::snprintf(what, sizeof what, "cut %d (%s%s, kerf %.3f mm)", i, is_plane ? "plane" : "curve",
                  ends_inside ? " that ends inside" : "", kerf);
    try
    {
      const TriangleMesh blade = is_plane ? blade_of(sample.plane(ends_inside), kerf)
                                          : blade_of(sample.curve(ends_inside), kerf);
      try_cut(bone, what, is_plane, shells, blade, tally);
    }
    catch (const Error& error)
    {
      tally.plane_refusals += is_plane;
      ++tally.met;
      tally.refusals.push_back(std::string(what) + ": " + error.what());
    }
  }
  return {{"triangles", bone.triangles.size()},
          {"cuts", count},
          {"missed_bone", tally.missed},
          {"met_bone", tally.met},
          {"planes_that_met", tally.planes},
          {"closed_and_balanced", tally.closed},
          {"made_more_pieces", tally.parted},
          {"plane_refusals", tally.plane_refusals},
          {"refusals", tally.refusals},
          {"worst_imbalance", tally.worst_imbalance},
          {"mean_s", tally.seconds / std::max(1, count)},
          {"longest_s", tally.longest_s}};
}

} // namespace

int main(int count, char** arguments)
try
{
  if (count < 3)
  {
    std::cerr << "usage: random_cuts BONE.vtp COUNT [SEED]\n";
    return 2;
  }
  const TriangleMesh bone = to_triangle_mesh(read_surface(arguments[1]));
  const unsigned seed = count > 3 ? static_cast<unsigned>(std::stoul(arguments[3])) : 1U;
  std::cout << run(bone, std::stoi(arguments[2]), seed).dump(2) << '\n';
}
catch (const std::exception& error)
{
  std::cerr << error.what() << '\n';
  return 1;
}
