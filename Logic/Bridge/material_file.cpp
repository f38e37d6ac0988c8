#include "Bridge/material_file.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/resources.hpp"
#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace f2b
{
namespace
{

using nlohmann::json;

double number(const json& tissue, const std::string& source, const std::string& where)
{
  const std::string key = where.substr(where.rfind('/') + 1);
  if (!tissue.contains(key) || !tissue[key].is_number() || !std::isfinite(tissue[key].get<double>()))
    throw Error(source, where + " is missing or not a number", "give it as a number");
  return tissue[key].get<double>();
}

Yeoh law_from(const json& tissue, const std::string& source, const std::string& where)
{
  if (!tissue.is_object() || tissue.value("law", "") != "yeoh")
    throw Error(source, where + "/law is not 'yeoh'", "give the tissue a Yeoh law");
  Yeoh law;
  law.c1 = number(tissue, source, where + "/c1");
  law.c2 = number(tissue, source, where + "/c2");
  law.c3 = number(tissue, source, where + "/c3");
  const double nu = number(tissue, source, where + "/poisson_ratio");
  if (!(law.c1 > 0) || law.c2 < 0 || law.c3 < 0)
    throw Error(source, where + " has c1 = " + std::to_string(law.c1) + ", c2 = " +
                            std::to_string(law.c2) + ", c3 = " + std::to_string(law.c3),
                "a stable law needs c1 > 0, c2 >= 0 and c3 >= 0");
  if (!(nu > -1) || !(nu <= 0.4999))
    throw Error(source, where + "/poisson_ratio is " + std::to_string(nu),
                "give a value above -1 and up to 0.4999");
  law.bulk_modulus = Yeoh::bulk_from(law.shear_modulus(), nu);
  return law;
}

} // namespace

MaterialSet read_materials(const std::string& name_or_path)
{
  const std::string* carried = carried_resource("Materials/" + name_or_path + ".json");
  const json document = carried ? json::parse(*carried) : read_json(name_or_path);
  const std::string source = carried ? "materials '" + name_or_path + "'" : name_or_path;
  if (!document.is_object() || document.value("units", "") != "MPa" ||
      document.value("volumetric_law", "") != "barrier")
    throw Error(source, "it does not state units MPa and volumetric_law barrier",
                "see Resources/Materials/table1-stable.json");
  MaterialSet set;
  set.name = document.value("name", name_or_path);
  const json tissues = document.value("tissues", json::object());
  const std::pair<const char*, Tissue> known[] = {
      {"skin", Tissue::Skin}, {"fat", Tissue::Fat}, {"muscle", Tissue::Muscle}};
  for (const auto& [name, tissue] : known)
    set.laws[static_cast<std::size_t>(tissue)] =
        law_from(tissues.value(name, json()), source, std::string("tissues/") + name);
  return set;
}

} // namespace f2b
