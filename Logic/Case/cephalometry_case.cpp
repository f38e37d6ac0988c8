#include "Case/cephalometry_case.hpp"

#include "Core/geometry/cephalometry.hpp"
#include "Core/geometry/nearest_vertex.hpp"

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

/// Landmarks of the skin where a state of the face takes them.
Landmarks on_face(const Landmarks& rest, const std::vector<Vec3>& skin,
                  const std::vector<Vec3>& displacement)
{
  Landmarks moved;
  for (const auto& [name, position] : rest)
    if (is_soft(name))
      moved[name] = position + displacement[nearest_vertex(skin, position)];
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

json cephalometry_json(const Landmarks& rest, const Landmarks& moved, const FaceStates& face)
{
  json list = json::array();
  const LeftOutMeasures left_out = left_out_measures(rest);
  if (!cephalometry(rest).empty())
  {
    const MidSagittalPlane plane = mid_sagittal_plane(rest);
    Landmarks predicted = moved;
    for (const auto& [name, position] : on_face(rest, face.skin, face.to_predicted))
      predicted[name] = position;
    const auto after = by_name(cephalometry(predicted, plane));
    const auto wished = by_name(cephalometry(on_face(rest, face.skin, face.to_target), plane));
    for (const CephalometricMeasure& m : cephalometry(rest, plane))
    {
      list.push_back(
          {{"name", m.name}, {"unit", m.unit}, {"definition", m.definition}, {"before", m.value}});
      if (const auto found = wished.find(m.name); found != wished.end())
        list.back()["target"] = found->second;
      if (const auto found = after.find(m.name); found != after.end())
        list.back()["predicted"] = found->second;
    }
  }
  return {{"measures", list},
          {"missing_landmarks", left_out.landmarks},
          {"left_out", left_out.measures}};
}

} // namespace f2b
