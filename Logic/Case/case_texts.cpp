#include "Case/case_texts.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/resources.hpp"
#include "Core/error.hpp"

#include <nlohmann/json.hpp>

namespace f2b
{

Texts case_texts(const Path& translation)
{
  auto table = nlohmann::json::parse(*carried_resource("texts/en.json")).get<Texts::Table>();
  if (!translation.empty())
  {
    const nlohmann::json document = read_json(translation);
    for (const auto& [key, text] : document.items())
    {
      if (table.count(key) == 0 || !text.is_string())
        throw Error(translation.string(), "'" + key + "' is no text that FaceToBone has",
                    "use the keys of Resources/texts/en.json, each with a string");
      table[key] = text.get<std::string>();
    }
  }
  return Texts(table);
}

} // namespace f2b
