#include "Bridge/json_file.hpp"
#include "Bridge/point_labels.hpp"
#include "Bridge/scan_surface.hpp"
#include "Case/input_records.hpp"
#include "Case/plan_target.hpp"
#include "Case/verbs.hpp"
#include "Case/warp_points.hpp"
#include "Core/error.hpp"
#include "Core/geometry/landmark_warp.hpp"
#include "Core/inverse/skin_error.hpp"

#include <algorithm>
#include <cstdio>

namespace f2b
{
namespace
{

using nlohmann::json;

/// Farther than this, a mesh is no edited copy of the reference skin, and a target no plan.
constexpr double longest_displacement_mm = 100;

std::string millimetres(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", value);
  return text;
}

/// Whether two surfaces join the same vertices. Editors may start a triangle at another corner and
/// write triangles in another order.
bool same_triangles(const TriangleMesh& a, const TriangleMesh& b)
{
  auto sorted = [](const TriangleMesh& mesh)
  {
    std::vector<Triangle> triangles = mesh.triangles;
    for (Triangle& t : triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  return sorted(a) == sorted(b);
}

/// The edited reference skin, if it is one.
TriangleMesh edited_skin(const Path& path, vtkPolyData* surface, const TriangleMesh& reference)
{
  const TriangleMesh edited = to_triangle_mesh(surface);
  if (edited.points.size() != reference.points.size())
    throw Error(path.string(),
                "it has " + std::to_string(edited.points.size()) +
                    " vertices, the reference skin " + std::to_string(reference.points.size()),
                "edit the exported skin.vtp without adding, removing or merging vertices");
  if (!same_triangles(edited, reference))
    throw Error(path.string(), "its triangles join other vertices than those of the reference skin",
                "edit the exported skin.vtp and keep the order of its vertices");
  return edited;
}

/// The moved vertices, and what of them counts where the file says so.
SkinTarget from_mesh(const Path& path, const TriangleMesh& reference)
{
  const vtkSmartPointer<vtkPolyData> surface = read_surface(path);
  std::vector<Vec3> displacement = edited_skin(path, surface, reference).points;
  std::vector<double> weight(displacement.size(), 1.0);
  if (has_point_array(surface, "weight"))
    weight = point_scalars(surface, "weight");
  double longest = 0;
  for (std::size_t v = 0; v < displacement.size(); ++v)
  {
    displacement[v] -= reference.points[v];
    longest = std::max(longest, displacement[v].norm());
  }
  if (longest > longest_displacement_mm)
    throw Error(
        path.string(), "it lies up to " + millimetres(longest) + " from the reference skin",
        "keep vertex order and frame of skin.vtp: LPS, or RAS with SPACE=RAS said in the file");
  return {displacement, weight, {}};
}

std::vector<Vec3> from_warp(const TargetSettings& target, const TriangleMesh& reference)
{
  const WarpPoints points = read_warp_points(target);
  const LandmarkWarp warp(points.from, points.to, target.warp_radius_mm);
  std::vector<Vec3> displacement;
  for (const Vec3& p : reference.points)
    displacement.push_back(warp.displacement(p));
  return displacement;
}

std::vector<Vec3> from_movement(CaseSession& session)
{
  const LoadedFace face(session);
  const Prediction prediction = predict_face(
      face.model(),
      stated_motions(session.settings.target.movements, face, "'/target/from_movement'"),
      equilibrium_options(session.settings), session.progress);
  if (!prediction.summary.converged())
    require_converged(prediction.summary, "target from_movement",
                      examine_stability(face.tissue, face.materials, prediction.x).warnings());
  return prediction.skin_displacement;
}

/// The nearest places of a scan, which must lie over some of the face.
SkinTarget from_scan(const TargetSettings& target, const TriangleMesh& reference)
{
  const auto scan = std::make_shared<const ScanSurface>(read_surface(target.scan));
  SkinTarget found =
      target_on_scan(scan, reference.points, vertex_normals(reference), target.scan_reach_mm);
  const auto counting = std::count(found.weight.begin(), found.weight.end(), 1.0);
  if (counting < 100)
    throw Error(target.scan.string(),
                "it overlaps the face in " + std::to_string(counting) + " of " +
                    std::to_string(found.weight.size()) + " vertices within " +
                    millimetres(target.scan_reach_mm),
                "register the scan to the CT first, check its frame (LPS, or RAS with SPACE=RAS "
                "said in the file), or raise target.scan.reach_mm");
  return found;
}

/// Without what the target moves by less than the mask.
std::vector<double> masked(std::vector<double> weight, const std::vector<Vec3>& displacement,
                           double mask_mm)
{
  for (std::size_t v = 0; v < weight.size(); ++v)
    if (mask_mm > 0 && displacement[v].norm() < mask_mm)
      weight[v] = 0;
  return weight;
}

} // namespace

void target_case(CaseSession& session)
{
  const Stopwatch watch;
  require_target(session.settings);
  const TargetSettings& target = session.settings.target;
  const vtkSmartPointer<vtkPolyData> skin =
      read_surface(session.folder.require("skin.vtp", "segment"));
  const TriangleMesh reference = to_triangle_mesh(skin);
  session.progress("making the target face", 0);
  const char* kind = !target.mesh.empty()        ? "mesh"
                     : !target.scan.empty()      ? "scan"
                     : !target.warp_from.empty() ? "warp"
                                                 : "from_movement";
  SkinTarget made{{}, std::vector<double>(reference.points.size(), 1.0), {}};
  if (!target.mesh.empty())
    made = from_mesh(target.mesh, reference);
  else if (!target.scan.empty())
    made = from_scan(target, reference);
  else if (!target.warp_from.empty())
    made.displacement = from_warp(target, reference);
  else
    made.displacement = from_movement(session);
  const std::vector<Vec3>& displacement = made.displacement;
  std::vector<Vec3> points = reference.points;
  double peak = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] += displacement[v];
    if (made.weight[v] > 0)
      peak = std::max(peak, displacement[v].norm());
  }
  if (peak > longest_displacement_mm)
    throw Error("target", "it moves the skin by up to " + millimetres(peak),
                "no operation moves a face by more than " + millimetres(longest_displacement_mm) +
                    ": check the points, and the frame of their file");
  const vtkSmartPointer<vtkPolyData> surface = with_points(skin, points);
  add_point_array(surface, "displacement", displacement);
  add_point_array(surface, "weight", masked(made.weight, displacement, target.mask_mm));

  CaseChange change(session.folder);
  session.write_settings(change.folder());
  write_surface(change.file("target.vtp"), surface);
  if (!target.scan.empty())
    write_surface(change.file(target_scan_name), read_surface(target.scan));
  write_json(change.file("target.json"), {{"seconds", watch.seconds()},
                                          {"kind", kind},
                                          {"peak_displacement_mm", peak},
                                          {"inputs", target_inputs(session.settings)}});
  change.commit("target");
  session.progress("target made", 1);
}

} // namespace f2b
