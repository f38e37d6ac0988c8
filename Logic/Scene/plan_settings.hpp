#pragma once

#include <nlohmann/json.hpp>

#include <string>

class vtkMRMLFaceToBonePlanNode;

/// Which options of a case file has the plan node?
namespace f2b
{

/// Moves a member out of an object.
template <class Value>
void take_out(nlohmann::json& object, const std::string& key, Value& value)
{
  if (const auto member = object.find(key); member != object.end())
  {
    value = member->template get<Value>();
    object.erase(member);
  }
}

/// Adds a member unless it says what is so without it.
template <class Value>
void put(nlohmann::json& object, const std::string& key, const Value& value,
         const Value& default_value)
{
  if (value != default_value)
    object[key] = value;
}

/// What is left of an object once everything with a property was taken out; empty: nothing.
std::string text_of_rest(nlohmann::json object);
/// The object again; throws Error where the text is no JSON object.
nlohmann::json rest_from_text(const std::string& text);

/// \param document  a case document without osteotomies and target
void plan_to_node(nlohmann::json document, vtkMRMLFaceToBonePlanNode* node);
nlohmann::json plan_from_node(vtkMRMLFaceToBonePlanNode* node);

} // namespace f2b
