#include "Case/schema_check.hpp"

#include "Bridge/key_hint.hpp"
#include "Core/error.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace f2b
{
namespace
{

using nlohmann::json;

const json& resolved(const json& rule, const json& root)
{
  return rule.contains("$ref")
             ? root.at(json::json_pointer(rule["$ref"].get<std::string>().substr(1)))
             : rule;
}

std::string keys_of(const json& properties, const std::string& unknown)
{
  std::vector<std::string> keys;
  for (const auto& [key, value] : properties.items())
    keys.push_back(key);
  return hint_for(unknown, keys);
}

/// A key may be a name, which goes into warnings, reports and names of files.
void refuse_control_characters(const json& value, const std::string& source)
{
  for (const auto& [key, entry] : value.items())
  {
    if (value.is_object() &&
        std::any_of(key.begin(), key.end(), [](unsigned char c) { return std::iscntrl(c); }))
      throw Error(source, "the key " + json(key).dump() + " holds a control character",
                  "write the key without it");
    if (entry.is_structured())
      refuse_control_characters(entry, source);
  }
}

/// The commonest fault gets the best answer: a key that the schema does not know.
void refuse_unknown_keys(const json& value, const json& rule_or_reference, const json& root,
                         const std::string& source, const std::string& where)
{
  const json& rule = resolved(rule_or_reference, root);
  if (value.is_array() && rule.contains("items"))
    for (std::size_t i = 0; i < value.size(); ++i)
      refuse_unknown_keys(value[i], rule["items"], root, source, where + "/" + std::to_string(i));
  if (!value.is_object() || !rule.contains("additionalProperties"))
    return;
  const json properties = rule.value("properties", json::object());
  for (const auto& [key, entry] : value.items())
    if (properties.contains(key))
      refuse_unknown_keys(entry, properties[key], root, source, where + "/" + key);
    else if (rule["additionalProperties"].is_object())
      refuse_unknown_keys(entry, rule["additionalProperties"], root, source, where + "/" + key);
    else
      throw Error(source, "unknown key '" + where + "/" + key + "'", keys_of(properties, key));
}

/// Where valijson found a fault. It writes ["<root>", "[mesh]", "[density]"].
json::json_pointer pointer_from(const std::vector<std::string>& context)
{
  json::json_pointer pointer;
  for (std::size_t i = 1; i < context.size(); ++i)
    pointer.push_back(context[i].substr(1, context[i].size() - 2));
  return pointer;
}

/// The schema's rule for the value at a place; null where it has none.
const json* rule_at(const json& root, const std::vector<std::string>& context)
{
  const json* rule = &root;
  for (std::size_t i = 1; i < context.size(); ++i)
  {
    const std::string key = context[i].substr(1, context[i].size() - 2);
    const json& here = resolved(*rule, root);
    if (here.contains("items"))
      rule = &here["items"];
    else if (here.contains("properties") && here["properties"].contains(key))
      rule = &here["properties"][key];
    else if (here.contains("additionalProperties") && here["additionalProperties"].is_object())
      rule = &here["additionalProperties"];
    else
      return nullptr;
  }
  return rule;
}

constexpr const char* see_schema = "see Resources/Schema/case.schema.json";

/// A word where others are known, such as a misspelt name.
std::string word_hint(const json& document, const json::json_pointer& at, const json& here)
{
  if (!document.contains(at) || !document.at(at).is_string() || !here.contains("enum"))
    return "";
  std::vector<std::string> known;
  for (const json& word : here["enum"])
    if (word.is_string())
      known.push_back(word.get<std::string>());
  return known.size() < 2 ? "" : hint_for(document.at(at).get<std::string>(), known, "values");
}

/// \param rule, here  a rule as it stands, and where its reference leads
std::string allowed(const json& rule, const json& here)
{
  std::string text;
  if (here.contains("type"))
    text += "give " + here["type"].get<std::string>();
  for (const char* key :
       {"minimum", "exclusiveMinimum", "maximum", "minItems", "maxItems", "pattern"})
    if (here.contains(key))
      text += std::string(text.empty() ? "" : ", ") + key + " " + here[key].dump();
  if (here.contains("required"))
    text += " with " + here["required"].dump();
  if (here.contains("enum"))
    text += "give one of " + here["enum"].dump();
  if (rule.contains("description"))
    text += " (" + rule["description"].get<std::string>() + ")";
  return text.empty() ? see_schema : text;
}

/// What is wrong with a value, or with an object that lacks a key.
std::string fault_text(const json& document, const json::json_pointer& at, const json& rule)
{
  const std::string where = at.to_string();
  if (document.contains(at) && document.at(at).is_object())
    for (const json& key : rule.value("required", json::array()))
      if (!document.at(at).contains(key.get<std::string>()))
        return "'" + where + "/" + key.get<std::string>() + "' is absent";
  std::string value = document.contains(at) ? document.at(at).dump() : "absent";
  if (value.size() > 60)
    value = value.substr(0, 57) + "...";
  return (where.empty() ? "the document" : "'" + where + "'") + " is " + value +
         ", which is not allowed";
}

} // namespace

void check_against_schema(const json& document, const json& schema, const std::string& source)
{
  refuse_control_characters(document, source);
  refuse_unknown_keys(document, schema, schema, source, "");
  valijson::Schema parsed;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), parsed);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(parsed, valijson::adapters::NlohmannJsonAdapter(document), &results))
    return;
  // the deepest fault is the one that the others follow from
  valijson::ValidationResults::Error fault, deepest;
  while (results.popError(fault))
    if (fault.context.size() >= deepest.context.size())
      deepest = fault;
  const json::json_pointer at = pointer_from(deepest.context);
  const json* rule = rule_at(schema, deepest.context);
  const json& here = rule ? resolved(*rule, schema) : schema;
  const std::string hint = word_hint(document, at, here);
  throw Error(source, fault_text(document, at, here),
              !hint.empty() ? hint
              : rule        ? allowed(*rule, here)
                            : see_schema);
}

} // namespace f2b
