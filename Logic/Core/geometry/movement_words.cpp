#include <Core/geometry/movement_words.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace f2b
{

namespace
{

std::string fixed(double value, int decimals)
{
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

MovementRow make_row(const char* axis, double value, MovementUnit unit, const char* positive,
                     const char* negative)
{
  const double amount = std::abs(value);
  // What prints as 0.00 has no direction worth reading.
  const char* direction = amount < 0.005 ? "None" : value > 0 ? positive : negative;
  return {axis, amount, unit, direction};
}

MovementRow rotation_row(const char* axis, double angle_deg)
{
  return make_row(axis, angle_deg, MovementUnit::Degree, "Counter-clockwise", "Clockwise");
}

MovementRow translation_row(const char* axis, double distance_mm, const char* positive,
                            const char* negative)
{
  return make_row(axis, distance_mm, MovementUnit::Millimetre, positive, negative);
}

} // namespace

std::string amount_text(const MovementRow& row)
{
  return fixed(row.amount, 2) + (row.unit == MovementUnit::Degree ? "\u00b0" : " mm");
}

std::vector<MovementRow> describe_movement(const Vec3& translation_ras_mm,
                                           const RotationDegrees& rotation_deg)
{
  const double right = translation_ras_mm[0];
  const double anterior = translation_ras_mm[1];
  const double superior = translation_ras_mm[2];
  return {translation_row("Coronal", anterior, "Forward", "Backward"),
          translation_row("Axial", superior, "Upwards", "Downwards"),
          rotation_row("Coronal/center", rotation_deg.roll),
          translation_row("Sagittal", right, "Right", "Left"),
          rotation_row("Sagittal/center", rotation_deg.pitch),
          rotation_row("Axial/center", rotation_deg.yaw)};
}

std::string translation_phrase(const Vec3& translation_ras_mm)
{
  struct Part
  {
    double value;
    const char* positive;
    const char* negative;
  };
  const std::array<Part, 3> parts{{{translation_ras_mm[1], "forward", "backward"},
                                   {translation_ras_mm[2], "up", "down"},
                                   {translation_ras_mm[0], "right", "left"}}};
  std::string phrase;
  for (const Part& part : parts)
  {
    if (std::abs(part.value) < 0.05)
    {
      continue;
    }
    phrase += phrase.empty() ? "" : ", ";
    phrase += fixed(std::abs(part.value), 1) + " mm ";
    phrase += part.value > 0 ? part.positive : part.negative;
  }
  return phrase.empty() ? "no translation" : phrase;
}

std::string rotation_phrase(const RotationDegrees& rotation_deg)
{
  struct Part
  {
    double degrees;
    const char* plane;
  };
  const std::array<Part, 3> parts{{{rotation_deg.roll, "coronal"},
                                   {rotation_deg.pitch, "sagittal"},
                                   {rotation_deg.yaw, "axial"}}};
  std::string phrase;
  for (const Part& part : parts)
  {
    if (std::abs(part.degrees) < 0.05)
    {
      continue;
    }
    phrase += phrase.empty() ? "" : ", ";
    phrase += fixed(std::abs(part.degrees), 1) + " degrees ";
    phrase += part.degrees > 0 ? "counter-clockwise (" : "clockwise (";
    phrase += std::string(part.plane) + ")";
  }
  return phrase.empty() ? "no rotation" : phrase;
}

} // namespace f2b
