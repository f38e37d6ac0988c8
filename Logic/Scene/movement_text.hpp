#pragma once

#include <nlohmann/json.hpp>

#include <array>

/// How does a case file write the six coordinates of a movement?
namespace f2b
{

/// right, anterior, superior [mm], pitch, roll, yaw [degrees], as the nodes hold them.
using SixCoordinates = std::array<double, 6>;

inline constexpr const char* coordinate_keys[6] = {"right", "anterior", "superior",
                                                   "pitch", "roll",     "yaw"};

/// \param value  with `translation_mm` and `rotation_deg`; 0 where a coordinate is absent
inline SixCoordinates coordinates_from(const nlohmann::json& value)
{
  SixCoordinates six{};
  for (std::size_t c = 0; c < 6; ++c)
    six[c] = value.value(c < 3 ? "translation_mm" : "rotation_deg", nlohmann::json::object())
                 .value(coordinate_keys[c], 0.0);
  return six;
}

inline nlohmann::json to_movement_json(const SixCoordinates& six)
{
  nlohmann::json value;
  for (std::size_t c = 0; c < 6; ++c)
    value[c < 3 ? "translation_mm" : "rotation_deg"][coordinate_keys[c]] = six[c];
  return value;
}

} // namespace f2b
