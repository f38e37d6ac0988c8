#pragma once

#include <optional>
#include <string>
#include <vector>

/// How many MPa (N/mm^2) are one of a file's units of stress? The one place that converts.
namespace f2b
{

inline const std::vector<std::string> known_stress_units = {"MPa", "kPa", "Pa", "gf/mm^2"};

/// Nothing for a unit that is not among the known ones.
inline std::optional<double> mpa_per(const std::string& unit)
{
  const double factors[] = {1, 1e-3, 1e-6, 9.80665e-3};
  for (std::size_t i = 0; i < known_stress_units.size(); ++i)
    if (unit == known_stress_units[i])
      return factors[i];
  return std::nullopt;
}

} // namespace f2b
