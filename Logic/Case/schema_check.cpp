#include "Case/schema_check.hpp"

#include "Core/error.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <vector>

namespace f2b
{
namespace
{

using nlohmann::json;

/// Number of single-letter edits between two words (Levenshtein).
std::size_t edits(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t change = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

const json& resolved(const json& rule, const json& root)
{
  return rule.contains("$ref")
             ? root.at(json::json_pointer(rule["$ref"].get<std::string>().substr(1)))
             : rule;
}

std::string keys_of(const json& properties, const std::string& unknown)
{
  std::string nearest, all;
  std::size_t distance = 4;
  for (const auto& [key, value] : properties.items())
  {
    all += (all.empty() ? "" : ", ") + key;
    if (edits(key, unknown) < distance)
    {
      distance = edits(key, unknown);
      nearest = key;
    }
  }
  return nearest.empty() ? "known keys here: " + all : "did you mean '" + nearest + "'?";
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

std::string pointer_from(const std::vector<std::string>& context)
{
  // valijson writes ["<root>", "[mesh]", "[density]"]
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i)
    pointer += "/" + context[i].substr(1, context[i].size() - 2);
  return pointer.empty() ? "/" : pointer;
}

std::string allowed(const json& root, const std::string& pointer)
{
  const json* rule = &root;
  json::json_pointer at(pointer == "/" ? "" : pointer);
  for (std::string step = pointer == "/" ? "" : pointer; !step.empty();)
  {
    const auto next = step.find('/', 1);
    const std::string key = step.substr(1, next == std::string::npos ? next : next - 1);
    step = next == std::string::npos ? "" : step.substr(next);
    const json& here = resolved(*rule, root);
    if (here.contains("items"))
      rule = &here["items"];
    else if (here.contains("properties") && here["properties"].contains(key))
      rule = &here["properties"][key];
    else if (here.contains("additionalProperties") && here["additionalProperties"].is_object())
      rule = &here["additionalProperties"];
    else
      return "see Resources/Schema/case.schema.json";
  }
  const json& here = resolved(*rule, root);
  std::string text;
  if (here.contains("type"))
    text += "give " + here["type"].get<std::string>();
  for (const char* key : {"minimum", "exclusiveMinimum", "maximum", "minItems", "maxItems", "pattern"})
    if (here.contains(key))
      text += std::string(text.empty() ? "" : ", ") + key + " " + here[key].dump();
  if (here.contains("required"))
    text += " with " + here["required"].dump();
  if (here.contains("enum"))
    text += "give one of " + here["enum"].dump();
  if (rule->contains("description"))
    text += " (" + (*rule)["description"].get<std::string>() + ")";
  return text.empty() ? "see Resources/Schema/case.schema.json" : text;
}

} // namespace

void check_against_schema(const json& document, const json& schema, const std::string& source)
{
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
  const std::string pointer = pointer_from(deepest.context);
  const json::json_pointer at(pointer == "/" ? "" : pointer);
  std::string value = document.contains(at) ? document.at(at).dump() : "absent";
  if (value.size() > 60)
    value = value.substr(0, 57) + "...";
  throw Error(source, "'" + pointer + "' is " + value + ", which is not allowed", allowed(schema, pointer));
}

} // namespace f2b
