#include "CommandLine/stated_movement.hpp"

#include "Core/error.hpp"

#include <sstream>

namespace f2b
{

std::vector<StatedArgument> movements_from_arguments(const std::vector<std::string>& arguments)
{
  std::vector<StatedArgument> movements;
  for (const std::string& argument : arguments)
  {
    const auto colon = argument.rfind(':');
    std::array<double, 6> v{};
    std::size_t count = 0;
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
    movements.push_back({argument.substr(0, colon), v});
  }
  return movements;
}

} // namespace f2b
