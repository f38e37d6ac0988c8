#include "Case/plan_intervals.hpp"

#include "Core/material/material_set.hpp"

#include <algorithm>

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
