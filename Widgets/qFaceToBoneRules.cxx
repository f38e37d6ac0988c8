#include "qFaceToBoneRules.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace
{

using nlohmann::json;

constexpr const char* names[] = {"right", "anterior", "superior", "pitch", "roll", "yaw"};

void erase(json& movement, const char* group, const char* name)
{
  const auto found = movement.find(group);
  if (found == movement.end())
    return;
  if (found->is_array())
    found->erase(std::remove(found->begin(), found->end(), json(name)), found->end());
  else
    found->erase(name);
  if (found->empty())
    movement.erase(group);
}

} // namespace

double qFaceToBoneRules::within(std::size_t k, double wish, double most) const
{
  if (isLocked(k))
    return 0;
  const qFaceToBoneRule& rule = coordinates[k];
  const double low = rule.bounded ? std::max(-most, rule.least) : -most;
  const double high = rule.bounded ? std::min(most, rule.most) : most;
  return std::max(low, std::min(high, wish));
}

qFaceToBoneRules qFaceToBoneRulesFrom(const json& movement)
{
  qFaceToBoneRules rules;
  if (!movement.is_object())
    return rules;
  const json locked = movement.value("locked", json::array());
  const json bounds = movement.value("bounds", json::object());
  for (std::size_t k = 0; k < 6; ++k)
  {
    qFaceToBoneRule& rule = rules.coordinates[k];
    rule.locked = std::find(locked.begin(), locked.end(), names[k]) != locked.end();
    rule.bounded = bounds.contains(names[k]);
    if (rule.bounded)
    {
      rule.least = bounds.at(names[k]).at(0).get<double>();
      rule.most = bounds.at(names[k]).at(1).get<double>();
    }
  }
  if (movement.contains("hinge"))
    rules.restraint =
        QCoreApplication::translate("qFaceToBoneRules", "It turns about a hinge only.");
  else if (movement.contains("bite") && movement.at("bite").value("tolerance_mm", 0.0) <= 0)
    rules.restraint = QCoreApplication::translate("qFaceToBoneRules", "It keeps its planned bite.");
  return rules;
}

json qFaceToBoneWithRule(json movement, std::size_t coordinate, const qFaceToBoneRule& rule)
{
  const char* name = names[coordinate];
  if (!movement.is_object())
    movement = json::object();
  erase(movement, "locked", name);
  erase(movement, "bounds", name);
  if (rule.locked)
  {
    erase(movement, "prior", name);
    movement["locked"].push_back(name);
  }
  else if (rule.bounded)
    movement["bounds"][name] = {rule.least, rule.most};
  return movement.empty() ? json() : movement;
}
