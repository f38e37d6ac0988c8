#include "Case/cephalometry_case.hpp"

#include "Bridge/markups.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/fragment_json.hpp"
#include "Case/plan_findings.hpp"
#include "Core/geometry/cephalometry.hpp"

#include <set>

namespace f2b
{
namespace
{

using nlohmann::json;

bool is_soft(const std::string& landmark)
{
  static const std::set<std::string> soft = []
  {
    std::set<std::string> names;
    for (const LandmarkDefinition& d : landmark_definitions())
      if (d.soft_tissue)
        names.insert(d.name);
    return names;
  }();
  return soft.count(landmark) > 0;
}

std::size_t nearest_vertex(const std::vector<Vec3>& points, const Vec3& to)
{
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i] - to).squaredNorm() < (points[nearest] - to).squaredNorm())
      nearest = i;
  return nearest;
}

/// Landmarks of the skin where a state of the face takes them.
Landmarks on_face(const Landmarks& rest, const std::vector<Vec3>& skin,
                  const std::vector<Vec3>& face)
{
  Landmarks moved;
  for (const auto& [name, position] : rest)
    if (is_soft(name))
    {
      const std::size_t v = nearest_vertex(skin, position);
      moved[name] = position + face[v] - skin[v];
    }
  return moved;
}

std::map<std::string, double> by_name(const std::vector<CephalometricMeasure>& measures)
{
  std::map<std::string, double> values;
  for (const CephalometricMeasure& m : measures)
    values[m.name] = m.value;
  return values;
}

} // namespace

json cephalometry_of(const CaseFolder& folder, const json& plan)
{
  json list = json::array();
  const Landmarks rest = folder.has("landmarks.mrk.json")
                             ? read_landmarks(folder.file("landmarks.mrk.json"))
                             : Landmarks();
  if (cephalometry(rest).empty())
    return list;
  std::vector<RigidMotion> motions;
  for (const json& f : plan.at("methods").at("rigid-fit").at("fragments"))
    motions.push_back(motion_from(f));
  auto points = [&](const char* file, const char* step)
  { return points_of(read_surface(folder.require(file, step))); };
  const std::vector<Vec3> skin = points("skin.vtp", "segment");
  const MidSagittalPlane plane = mid_sagittal_plane(rest);
  Landmarks predicted = MovedBones(folder).moved_landmarks(motions);
  for (const auto& [name, position] :
       on_face(rest, skin, points("predicted_rigid-fit.vtp", "plan")))
    predicted[name] = position;
  const auto after = by_name(cephalometry(predicted, plane));
  const auto wished =
      by_name(cephalometry(on_face(rest, skin, points("target.vtp", "target")), plane));
  for (const CephalometricMeasure& m : cephalometry(rest, plane))
  {
    list.push_back(
        {{"name", m.name}, {"unit", m.unit}, {"definition", m.definition}, {"before", m.value}});
    if (const auto found = wished.find(m.name); found != wished.end())
      list.back()["target"] = found->second;
    if (const auto found = after.find(m.name); found != after.end())
      list.back()["predicted"] = found->second;
  }
  return list;
}

} // namespace f2b
