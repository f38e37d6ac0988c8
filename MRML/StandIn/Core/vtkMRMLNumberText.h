#pragma once

#include <charconv>
#include <cstdlib>
#include <string>
#include <type_traits>

/// How is a number written so that it is read back to the last bit? The shortest decimal that does;
/// Slicer's stream writes six digits. Reading takes both.
template <class Number>
std::string vtkMRMLNumberText(Number value)
{
  if constexpr (std::is_floating_point_v<Number>)
  {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return std::string(text, end);
  }
  else
  {
    return std::to_string(value);
  }
}

/// The next number of a text of numbers parted by white space; false where there is none.
/// \param text  moved behind what was read
inline bool vtkMRMLNextNumber(const char*& text, double& value)
{
  while (*text == ' ' || *text == '\t' || *text == '\n' || *text == '\r')
  {
    ++text;
  }
  if (*text == '+')
  {
    ++text;
  }
  const char* end = text;
  while (*end && *end != ' ' && *end != '\t' && *end != '\n' && *end != '\r')
  {
    ++end;
  }
  const auto [stop, error] = std::from_chars(text, end, value);
  if (error != std::errc() || stop == text)
  {
    return false;
  }
  text = stop;
  return true;
}

/// The one number that a text holds; false where it holds anything else.
inline bool vtkMRMLNumberFromText(const char* text, double& value)
{
  const char* rest = text;
  double found = 0.0;
  double more = 0.0;
  if (!vtkMRMLNextNumber(rest, found) || vtkMRMLNextNumber(rest, more) || *rest)
  {
    return false;
  }
  value = found;
  return true;
}

/// A double as an int, within int's range (out-of-range casts are undefined).
inline int vtkMRMLIntFromDouble(double value)
{
  return value >= 2147483647.0    ? 2147483647
         : value <= -2147483648.0 ? -2147483647 - 1
         : value != value         ? 0
                                  : static_cast<int>(value);
}
