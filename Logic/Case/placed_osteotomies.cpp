#include "Case/placed_osteotomies.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/case_session.hpp"

namespace f2b
{

using nlohmann::json;

std::vector<Osteotomy> placed_osteotomies(const CaseFolder& folder)
{
  const json cut = read_json(folder.require("cut.json", "cut"));
  const std::vector<BoundedPlane> planes = read_planes(folder.require("cuts.mrk.json", "cut"));
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
    osteotomies.push_back(std::move(o));
  }
  return osteotomies;
}

} // namespace f2b
