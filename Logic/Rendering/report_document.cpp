#include <Rendering/report_document.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace f2b
{

ReportValue::ReportValue(double value, int shown_decimals)
    : kind(std::isfinite(value) ? Kind::Number : Kind::None), number(value),
      decimals(shown_decimals)
{
}

std::string ReportValue::shown() const
{
  if (kind != Kind::Number)
  {
    return kind == Kind::Text ? text : "-";
  }
  std::array<char, 400> digits{};
  std::snprintf(digits.data(), digits.size(), "%.*f", decimals, number);
  const std::string plain = digits.data();
  const bool is_minus_zero =
      plain[0] == '-' && plain.find_first_of("123456789") == std::string::npos;
  return is_minus_zero ? plain.substr(1) : plain;
}

} // namespace f2b
