#include "Case/settings_paths.hpp"

#include "Bridge/resources.hpp"

namespace f2b
{

using nlohmann::json;
namespace fs = std::filesystem;
using Visit = std::function<void(json&)>;

namespace
{

void visit_members(json& object, std::initializer_list<const char*> keys, const Visit& visit)
{
  for (const char* key : keys)
    if (object.contains(key))
      visit(object[key]);
}

void visit_osteotomy(json& osteotomy, const Visit& visit)
{
  if (osteotomy.contains("planes"))
    for (json& file : osteotomy["planes"])
      visit(file);
  if (osteotomy.contains("curves"))
    for (json& curve : osteotomy["curves"])
      visit_members(curve, {"markup"}, visit);
  if (osteotomy.contains("movement"))
    visit_rule_paths(osteotomy["movement"], visit);
}

void visit_target(json& target, const Visit& visit)
{
  visit_members(target, {"mesh"}, visit);
  if (target.contains("scan"))
    visit_members(target["scan"], {"mesh"}, visit);
  if (target.contains("warp"))
    visit_members(target["warp"], {"from", "to"}, visit);
}

} // namespace

void visit_rule_paths(json& movement, const Visit& visit)
{
  if (!movement.contains("bite"))
    return;
  json& bite = movement["bite"];
  visit_members(bite, {"splint"}, visit);
  if (bite.contains("points"))
    visit_members(bite["points"], {"from", "to"}, visit);
}

void visit_paths(json& document, const Visit& visit)
{
  visit_members(document, {"ct", "landmarks"}, visit);
  if (document.contains("osteotomies"))
    for (json& osteotomy : document["osteotomies"])
      visit_osteotomy(osteotomy, visit);
  if (document.contains("segmentation"))
    visit_members(document["segmentation"], {"seeds", "labels"}, visit);
  if (document.contains("protected"))
    for (json& structure : document["protected"])
      visit_members(structure, {"curve", "mesh"}, visit);
  if (document.contains("target"))
    visit_target(document["target"], visit);
  if (document.contains("materials") &&
      !carried_resource("materials/" + document["materials"].get<std::string>() + ".json"))
    visit(document["materials"]);
}

json with_folder_paths(json document, const fs::path& folder)
{
  const fs::path home = fs::weakly_canonical(folder);
  visit_paths(document,
              [&](json& text)
              {
                const fs::path path = fs::u8path(text.get<std::string>());
                if (!path.is_absolute())
                  return;
                const fs::path within = fs::weakly_canonical(path).lexically_relative(home);
                if (!within.empty() && within != "." && *within.begin() != "..")
                  text = within.generic_u8string();
              });
  return document;
}

} // namespace f2b
