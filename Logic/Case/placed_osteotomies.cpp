#include "Case/placed_osteotomies.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/case_session.hpp"

namespace f2b
{

using nlohmann::json;

json to_json(const SweptCurve& curve)
{
  json points = json::array();
  for (const Vec3& p : curve.points)
    points.push_back(to_json(p));
  return {{"name", curve.name},         {"closed", curve.closed},
          {"points_ras", points},       {"direction_ras", to_json(curve.direction)},
          {"depth_mm", curve.depth_mm}, {"lead_mm", curve.lead_mm}};
}

namespace
{

SweptCurve curve_from(const json& value)
{
  SweptCurve curve;
  curve.name = value.at("name").get<std::string>();
  curve.closed = value.at("closed").get<bool>();
  for (const json& point : value.at("points_ras"))
    curve.points.push_back(vec3_from(point));
  curve.direction = vec3_from(value.at("direction_ras"));
  curve.depth_mm = value.at("depth_mm").get<double>();
  curve.lead_mm = value.at("lead_mm").get<double>();
  return curve;
}

} // namespace

std::vector<Osteotomy> placed_osteotomies(const CaseFolder& folder)
{
  const json cut = read_json(folder.require("cut.json", "cut"));
  std::size_t drawn = 0;
  for (const json& fragment : cut.at("fragments"))
    drawn += fragment.at("planes").get<std::size_t>();
  std::vector<BoundedPlane> planes;
  if (drawn > 0) // a case may be cut along curves alone
    planes = read_planes(folder.require("cuts.mrk.json", "cut"));
  std::vector<Osteotomy> osteotomies;
  std::size_t next = 0;
  for (const json& fragment : cut.at("fragments"))
  {
    Osteotomy o;
    o.fragment = fragment.at("name").get<std::string>();
    o.kerf_mm = fragment.at("kerf_mm").get<double>();
    o.fragment_point = vec3_from(fragment.at("fragment_point_ras"));
    for (auto count = fragment.at("planes").get<std::size_t>(); count > 0; --count)
      o.planes.push_back(planes.at(next++));
    for (const json& curve : fragment.value("curves", json::array()))
      o.curves.push_back(curve_from(curve));
    osteotomies.push_back(std::move(o));
  }
  return osteotomies;
}

std::string cut_plane_file(const std::string& fragment, std::size_t plane)
{
  return "cut_" + file_part(fragment) + "_" + std::to_string(plane + 1) + ".mrk.json";
}

namespace
{

std::string cut_file_beginning(const std::string& fragment)
{
  return "cuts_" + file_part(fragment) + "_";
}

} // namespace

std::string cut_curve_file(const std::string& fragment, const std::string& curve)
{
  return cut_file_beginning(fragment) + file_part(curve) + ".mrk.json";
}

std::string curve_name_of(const std::string& fragment, const Path& file)
{
  const std::string name = file.stem().stem().string(), beginning = cut_file_beginning(fragment);
  return name.rfind(beginning, 0) == 0 && name.size() > beginning.size()
             ? name.substr(beginning.size())
             : name;
}

} // namespace f2b
