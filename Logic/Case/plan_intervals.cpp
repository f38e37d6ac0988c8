#include "Case/plan_intervals.hpp"

#include "Core/material/material_set.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr double degree = 3.14159265358979323846 / 180;

json coordinate_json(const CoordinateUncertainty& u, double unit, bool is_at_bound)
{
  json by_cause = {{"skin_noise", u.noise / unit},
                   {"registration", u.registration / unit},
                   {"poisson_ratio", u.poisson_ratio / unit},
                   {"skin_thickness", u.skin_thickness / unit}};
  for (std::size_t t = 0; t < u.stiffness.size(); ++t)
    by_cause[std::string("stiffness_of_") + name_of(static_cast<Tissue>(t))] =
        u.stiffness[t] / unit;
  return {{"half_90", u.half_90() / unit}, {"sd_by_cause", by_cause}, {"at_bound", is_at_bound}};
}

/// "pitch \u00b11.1, roll \u00b10.4" of those coordinates that there are.
std::string halves(const json& coordinates, const std::vector<const char*>& names)
{
  std::string text;
  for (const char* name : names)
    if (coordinates.contains(name))
    {
      char one[60];
      std::snprintf(one, sizeof one, "%s%s \u00b1%.2f", text.empty() ? "" : ", ", name,
                    coordinates.at(name).at("half_90").get<double>());
      text += one;
    }
  return text;
}

/// The cause with the greatest variance, each coordinate's shares counted alike.
std::string largest_cause(const json& coordinates)
{
  std::map<std::string, double> share;
  for (const auto& [name, c] : coordinates.items())
  {
    double total = 0;
    for (const json& sd : c.at("sd_by_cause"))
      total += sd.get<double>() * sd.get<double>();
    for (const auto& [cause, sd] : c.at("sd_by_cause").items())
      if (total > 0)
        share[cause] += sd.get<double>() * sd.get<double>() / total;
  }
  if (share.empty())
    return "nothing";
  std::string cause =
      std::max_element(share.begin(), share.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; })
          ->first;
  std::replace(cause.begin(), cause.end(), '_', ' ');
  return cause;
}

} // namespace

json intervals_json(const MovementSpace& space,
                    const std::vector<CoordinateUncertainty>& uncertainty,
                    const std::vector<Eigen::Index>& at_bounds)
{
  json result = json::object();
  for (const std::string& name : space.names())
    result[name] = json::object();
  for (std::size_t k = 0; k < uncertainty.size(); ++k)
  {
    const MovementSpace::Coordinate& c = space.coordinates()[k];
    const bool is_at_bound =
        std::count(at_bounds.begin(), at_bounds.end(), static_cast<Eigen::Index>(k)) > 0;
    result[space.names()[static_cast<std::size_t>(c.fragment)]][c.name()] =
        coordinate_json(uncertainty[k], c.is_angle() ? degree : 1, is_at_bound);
  }
  return result;
}

std::vector<std::pair<std::string, std::string>> interval_rows(const json& plan)
{
  const json& intervals = plan.at("methods").at("rigid-fit").at("intervals");
  std::vector<std::pair<std::string, std::string>> rows;
  if (!intervals.contains("fragments"))
    return rows;
  for (const auto& [fragment, coordinates] : intervals.at("fragments").items())
  {
    // one that is held says so among the warnings
    if (std::all_of(coordinates.begin(), coordinates.end(),
                    [](const json& c) { return c.at("at_bound").get<bool>(); }))
      continue;
    const std::string angles = halves(coordinates, {"pitch", "roll", "yaw", "hinge"});
    const std::string shifts = halves(coordinates, {"right", "anterior", "superior"});
    std::string text = angles.empty() ? "" : angles + " degrees";
    if (!shifts.empty())
      text += (text.empty() ? "" : "; ") + shifts + " mm";
    if (!text.empty())
      rows.emplace_back(fragment, text + "; most of it from " + largest_cause(coordinates));
  }
  return rows;
}

json to_json(const UncertaintySources& s)
{
  return {{"skin_sd_mm", s.skin_sd_mm},
          {"skin_correlation_mm", s.skin_correlation_mm},
          {"registration_sd_mm", s.registration_sd_mm},
          {"stiffness_log_sd", s.stiffness_log_sd},
          {"poisson_ratio_sd", s.poisson_ratio_sd},
          {"skin_thickness_sd_mm", s.skin_thickness_sd_mm}};
}

} // namespace f2b
