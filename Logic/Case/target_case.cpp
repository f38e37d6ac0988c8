#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/verbs.hpp"
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

/// Farther than this, a mesh is no edited copy of the reference skin.
constexpr double longest_displacement_mm = 100;

std::string millimetres(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", value);
  return text;
}

std::vector<Vec3> from_mesh(const Path& path, const TriangleMesh& reference)
{
  const vtkSmartPointer<vtkPolyData> edited = read_surface(path);
  const auto count = static_cast<std::size_t>(edited->GetNumberOfPoints());
  if (count != reference.points.size())
    throw Error(path.string(),
                "it has " + std::to_string(count) + " vertices, the reference skin " +
                    std::to_string(reference.points.size()),
                "edit the exported skin.vtp without adding, removing or merging vertices");
  std::vector<Vec3> displacement = points_of(edited);
  double longest = 0;
  for (std::size_t v = 0; v < count; ++v)
  {
    displacement[v] -= reference.points[v];
    longest = std::max(longest, displacement[v].norm());
  }
  if (longest > longest_displacement_mm)
    throw Error(path.string(), "it lies up to " + millimetres(longest) + " from the reference skin",
                "keep vertex order and frame of skin.vtp: LPS, or RAS with SPACE=RAS said in the file");
  return displacement;
}

/// The points of `to`, in the order of `from`'s labels.
std::vector<Vec3> matched_points(const TargetSettings& target, const PointMarkup& from)
{
  const Landmarks to = read_landmarks(target.warp_to);
  std::vector<Vec3> points;
  for (const ControlPoint& point : from.points)
  {
    const auto found = to.find(point.label);
    if (found == to.end())
      throw Error(target.warp_to.string(), "it has no point '" + point.label + "'",
                  "give every point of " + target.warp_from.string() + " its counterpart");
    points.push_back(found->second);
  }
  return points;
}

std::vector<Vec3> from_warp(const TargetSettings& target, const TriangleMesh& reference)
{
  const PointMarkup from = read_points(target.warp_from);
  std::vector<Vec3> begin;
  for (const ControlPoint& point : from.points)
    begin.push_back(point.position);
  const LandmarkWarp warp(begin, matched_points(target, from), target.warp_radius_mm);
  std::vector<Vec3> displacement;
  for (const Vec3& p : reference.points)
    displacement.push_back(warp.displacement(p));
  return displacement;
}

std::vector<Vec3> from_movement(CaseSession& session)
{
  const LoadedFace face = load_face(session);
  const Prediction prediction = predict_face(
      face.model(), stated_motions(session.settings.target.movements, face, "'/target/from_movement'"),
      equilibrium_options(session.settings), session.progress);
  require_converged(prediction.summary, "target from_movement");
  return prediction.skin_displacement;
}

std::vector<double> weights(const std::vector<Vec3>& displacement, double mask_mm)
{
  std::vector<double> weight(displacement.size(), 1.0);
  for (std::size_t v = 0; v < weight.size(); ++v)
    if (mask_mm > 0 && displacement[v].norm() < mask_mm)
      weight[v] = 0;
  return weight;
}

} // namespace

void target_case(CaseSession& session)
{
  const Stopwatch watch;
  const TargetSettings& target = session.settings.target;
  const vtkSmartPointer<vtkPolyData> skin = read_surface(session.folder.require("skin.vtp", "segment"));
  const TriangleMesh reference = to_triangle_mesh(skin);
  session.progress("making the target face", 0);
  const char* kind = !target.mesh.empty() ? "mesh" : !target.warp_from.empty() ? "warp" : "from_movement";
  const std::vector<Vec3> displacement = !target.mesh.empty()        ? from_mesh(target.mesh, reference)
                                         : !target.warp_from.empty() ? from_warp(target, reference)
                                                                     : from_movement(session);
  std::vector<Vec3> points = reference.points;
  double peak = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] += displacement[v];
    peak = std::max(peak, displacement[v].norm());
  }
  const vtkSmartPointer<vtkPolyData> surface = with_points(skin, points);
  add_point_array(surface, "displacement", displacement);
  add_point_array(surface, "weight", weights(displacement, target.mask_mm));

  CaseChange change(session.folder);
  write_json(change.file(case_settings_name), session.document);
  write_surface(change.file("target.vtp"), surface);
  write_json(change.file("target.json"),
             {{"seconds", watch.seconds()}, {"kind", kind}, {"peak_displacement_mm", peak}});
  change.commit("target");
  session.progress("target made", 1);
}

} // namespace f2b
