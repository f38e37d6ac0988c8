#include "Case/view_definitions.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/resources.hpp"
#include "Case/schema_check.hpp"
#include "Core/error.hpp"

#include <set>

namespace f2b
{
namespace
{

using nlohmann::json;

View view_from(const json& v)
{
  if (v.is_string())
    return require_view(v.get<std::string>());
  return {v.at("name").get<std::string>(), v.at("azimuth_deg").get<double>(),
          v.at("elevation_deg").get<double>()};
}

/// The picture's own value, else the file's, else none.
const json* setting(const json& document, const json& picture, const char* key)
{
  return picture.contains(key)    ? &picture.at(key)
         : document.contains(key) ? &document.at(key)
                                  : nullptr;
}

PictureDefinition definition_from(const json& document, const json& picture)
{
  PictureDefinition definition;
  definition.name = picture.at("name").get<std::string>();
  for (const json& subject : picture.at("show"))
    definition.show.push_back(require_subject(subject.get<std::string>()));
  for (const json& view : picture.value("view", json::array({"frontal"})))
    definition.views.push_back(view_from(view));
  definition.size = {1200 * panel_count(definition), 1000};
  if (const json* size = setting(document, picture, "size"))
    definition.size = {size->at(0).get<int>(), size->at(1).get<int>()};
  if (const json* dpi = setting(document, picture, "dpi"))
    definition.dpi = dpi->get<int>();
  if (const json* background = setting(document, picture, "background"))
    definition.background = require_background(background->get<std::string>());
  definition.options.fraction = picture.value("fraction", 0.5);
  if (picture.contains("slice_mm"))
    definition.options.slice_mm = picture.at("slice_mm").get<double>();
  return definition;
}

} // namespace

Background require_background(const std::string& name)
{
  const std::pair<const char*, Background> known[] = {{"light", Background::Light},
                                                      {"white", Background::White},
                                                      {"dark", Background::Dark},
                                                      {"transparent", Background::Transparent}};
  for (const auto& [word, background] : known)
    if (name == word)
      return background;
  throw Error("background", "'" + name + "' is none", "name light, white, dark or transparent");
}

std::vector<PictureDefinition> read_view_definitions(const Path& file)
{
  const json document = read_json(file);
  check_against_schema(document, json::parse(*carried_resource("Schema/views.schema.json")),
                       file.string());
  std::vector<PictureDefinition> definitions;
  std::set<std::string> names;
  for (const json& picture : document.at("pictures"))
  {
    definitions.push_back(definition_from(document, picture));
    if (!names.insert(definitions.back().name).second)
      throw Error(file.string(), "two pictures are named '" + definitions.back().name + "'",
                  "give each its own name");
  }
  return definitions;
}

} // namespace f2b
