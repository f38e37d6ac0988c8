#include "Scene/osteotomy_settings.hpp"

#include "Core/error.hpp"
#include "Scene/movement_text.hpp"
#include "Scene/plan_settings.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>

namespace f2b
{
namespace
{

using nlohmann::json;
using Osteotomy = vtkMRMLFaceToBoneOsteotomyNode;

constexpr double default_kerf_mm = 1;

void rules_to_node(json rules, Osteotomy* node, int n)
{
  json locked = json::array(), bounds = json::object(), prior = json::object();
  if (rules.is_object())
  {
    take_out(rules, "locked", locked);
    take_out(rules, "bounds", bounds);
    take_out(rules, "prior", prior);
  }
  for (int c = 0; c < Osteotomy::Coordinate_Last; ++c)
  {
    const std::string key = Osteotomy::GetCoordinateAsString(c);
    node->SetNthFragmentLocked(n, c, std::find(locked.begin(), locked.end(), key) != locked.end());
    node->RemoveNthFragmentBounds(n, c);
    node->RemoveNthFragmentPrior(n, c);
    if (bounds.contains(key))
    {
      const double range[2] = {bounds[key].at(0).get<double>(), bounds[key].at(1).get<double>()};
      node->SetNthFragmentBounds(n, c, range);
    }
    if (prior.contains(key))
    {
      const double expected_sd[2] = {prior[key].value("expected", 0.0),
                                     prior[key].at("sd").get<double>()};
      node->SetNthFragmentPrior(n, c, expected_sd);
    }
  }
  // an empty bite or hinge is a rule: nothing is dropped here
  node->SetNthFragmentOtherRules(n, rules.is_object() && !rules.empty() ? rules.dump() : "");
}

json rules_from_node(Osteotomy* node, int n)
{
  json rules = rest_from_text(node->GetNthFragmentOtherRules(n));
  for (int c = 0; c < Osteotomy::Coordinate_Last; ++c)
  {
    const std::string key = Osteotomy::GetCoordinateAsString(c);
    double pair[2];
    if (node->GetNthFragmentLocked(n, c))
      rules["locked"].push_back(key);
    if (node->GetNthFragmentBounds(n, c, pair))
      rules["bounds"][key] = {pair[0], pair[1]};
    if (node->GetNthFragmentPrior(n, c, pair))
      rules["prior"][key] = {{"expected", pair[0]}, {"sd", pair[1]}};
  }
  return rules;
}

void entry_to_node(json entry, Osteotomy* node, int n)
{
  std::string template_name;
  double kerf = default_kerf_mm;
  std::vector<std::string> planes;
  json point, rules;
  take_out(entry, "template", template_name);
  take_out(entry, "kerf_mm", kerf);
  take_out(entry, "planes", planes);
  take_out(entry, "fragment_point_ras", point);
  take_out(entry, "movement", rules);
  node->SetNthFragmentTemplate(n, template_name);
  node->SetNthFragmentKerfMm(n, kerf);
  node->SetNthFragmentPlaneFileNames(n, planes);
  node->RemoveNthFragmentPoint(n);
  if (!point.is_null())
  {
    const double ras[3] = {point.at(0).get<double>(), point.at(1).get<double>(),
                           point.at(2).get<double>()};
    node->SetNthFragmentPoint(n, ras);
  }
  rules_to_node(rules, node, n);
  node->SetNthFragmentOtherSettings(n, text_of_rest(entry));
}

json entry_from_node(Osteotomy* node, int n)
{
  json entry = rest_from_text(node->GetNthFragmentOtherSettings(n));
  const std::string name = node->GetNthFragmentName(n),
                    template_name = node->GetNthFragmentTemplate(n);
  if (name != template_name)
    entry["fragment"] = name;
  if (!template_name.empty())
    entry["template"] = template_name;
  put(entry, "kerf_mm", node->GetNthFragmentKerfMm(n), default_kerf_mm);
  put(entry, "planes", node->GetNthFragmentPlaneFileNames(n), std::vector<std::string>());
  double ras[3];
  if (node->GetNthFragmentPoint(n, ras))
    entry["fragment_point_ras"] = {ras[0], ras[1], ras[2]};
  if (json rules = rules_from_node(node, n); !rules.empty())
    entry["movement"] = std::move(rules);
  return entry;
}

} // namespace

void osteotomies_to_node(const json& osteotomies, Osteotomy* node)
{
  MRMLNodeModifyBlocker blocker(node);
  std::vector<std::string> names;
  for (const json& entry : osteotomies)
    names.push_back(entry.value("fragment", entry.value("template", "")));
  for (int n = node->GetNumberOfFragments() - 1; n >= 0; --n)
    if (std::find(names.begin(), names.end(), node->GetNthFragmentName(n)) == names.end())
      node->RemoveNthFragment(n);
  for (std::size_t i = 0; i < osteotomies.size(); ++i)
  {
    json entry = osteotomies[i];
    entry.erase("fragment");
    if (node->GetFragmentIndex(names[i]) < 0 && node->AddFragment(names[i]) < 0)
      throw Error("/osteotomies/" + std::to_string(i),
                  "'" + names[i] + "' cannot be the name of a fragment",
                  "use letters, digits, spaces, '_' and '-', each name once");
    entry_to_node(entry, node, node->GetFragmentIndex(names[i]));
  }
  node->SortFragments(names);
}

json osteotomies_from_node(Osteotomy* node)
{
  json osteotomies = json::array();
  for (int n = 0; n < node->GetNumberOfFragments(); ++n)
    osteotomies.push_back(entry_from_node(node, n));
  return osteotomies;
}

} // namespace f2b
