#include "Bridge/material_file.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/resources.hpp"
#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace f2b
{
namespace
{

using nlohmann::json;

double number(const json& tissue, const std::string& source, const std::string& where)
{
  const std::string key = where.substr(where.rfind('/') + 1);
  if (!tissue.contains(key))
    throw Error(source, where + " is missing", "give it as a number");
  if (!tissue[key].is_number())
    throw Error(source, where + " is " + tissue[key].dump(), "give it as a number");
  return tissue[key].get<double>();
}

/// What a key holds if it is a text; else nothing.
std::string text(const json& object, const char* key)
{
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

Law law_from(const json& tissue, const std::string& source, const std::string& where)
{
  if (text(tissue, "law") != "yeoh")
    throw Error(source, where + "/law is '" + text(tissue, "law") + "', not 'yeoh'",
                "give the tissue a Yeoh law");
  IsochoricYeoh law;
  law.c1 = number(tissue, source, where + "/c1");
  law.c2 = number(tissue, source, where + "/c2");
  law.c3 = number(tissue, source, where + "/c3");
  const double nu = number(tissue, source, where + "/poisson_ratio");
  if (!(law.c1 > 0) || law.c2 < 0 || law.c3 < 0)
    throw Error(source,
                where + " has c1 = " + std::to_string(law.c1) + ", c2 = " + std::to_string(law.c2) +
                    ", c3 = " + std::to_string(law.c3),
                "a stable law needs c1 > 0, c2 >= 0 and c3 >= 0");
  if (!(nu > -1) || !(nu <= 0.4999))
    throw Error(source, where + "/poisson_ratio is " + std::to_string(nu),
                "give a value above -1 and up to 0.4999");
  return Yeoh{law, {VolumetricLaw::Kind::Barrier, bulk_from(law.shear_modulus(), nu)}};
}

json document_of(const std::string& path)
{
  if (!std::filesystem::is_regular_file(path))
    throw Error(path, "there is no such material file",
                "use table1-stable or give a file of its form");
  return read_json(path);
}

} // namespace

MaterialSet read_materials(const std::string& name_or_path)
{
  const std::string* carried = carried_resource("Materials/" + name_or_path + ".json");
  const json document = carried ? json::parse(*carried) : document_of(name_or_path);
  const std::string source = carried ? "materials '" + name_or_path + "'" : name_or_path;
  for (const auto& [key, needed] : {std::pair{"units", "MPa"}, {"volumetric_law", "barrier"}})
    if (text(document, key) != needed)
      throw Error(source, std::string(key) + " is not '" + needed + "'",
                  std::string("state it, and give the values so: \"") + key + "\": \"" + needed +
                      "\"");
  MaterialSet set;
  set.name = document.contains("name") ? text(document, "name") : name_or_path;
  const json tissues = document.value("tissues", json());
  const std::pair<const char*, Tissue> known[] = {
      {"skin", Tissue::Skin}, {"fat", Tissue::Fat}, {"muscle", Tissue::Muscle}};
  for (const auto& [name, tissue] : known)
    set.laws[static_cast<std::size_t>(tissue)] =
        law_from(tissues.is_object() ? tissues.value(name, json()) : json(), source,
                 std::string("tissues/") + name);
  return set;
}

} // namespace f2b
