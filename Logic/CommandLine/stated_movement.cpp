#include "CommandLine/stated_movement.hpp"

#include "Core/error.hpp"

#include <sstream>

namespace f2b
{

nlohmann::json movements_from_arguments(const std::vector<std::string>& arguments)
{
  nlohmann::json movements = nlohmann::json::object();
  for (const std::string& argument : arguments)
  {
    const auto colon = argument.rfind(':');
    double v[6] = {};
    int count = 0;
    std::stringstream numbers(colon == std::string::npos ? "" : argument.substr(colon + 1));
    for (char comma = ','; count < 6 && comma == ',' && numbers >> v[count];)
    {
      ++count;
      comma = ' ';
      numbers >> comma;
    }
    if (count != 6 || !(numbers >> std::ws).eof())
      throw Error("--movement", "'" + argument + "' cannot be read",
                  "write NAME:right,anterior,superior,pitch,roll,yaw with six numbers");
    movements[argument.substr(0, colon)] = {
        {"translation_mm", {{"right", v[0]}, {"anterior", v[1]}, {"superior", v[2]}}},
        {"rotation_deg", {{"pitch", v[3]}, {"roll", v[4]}, {"yaw", v[5]}}}};
  }
  return movements;
}

} // namespace f2b
