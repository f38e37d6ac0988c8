#pragma once

#include <array>
#include <string>
#include <vector>

namespace f2b
{

/// A fragment's movement as the command line states it.
struct StatedArgument
{
  std::string fragment;
  std::array<double, 6> coordinates; ///< right, anterior, superior [mm], pitch, roll, yaw [degrees]
};

/// Of `NAME:right,anterior,superior,pitch,roll,yaw` each; throws Error.
std::vector<StatedArgument> movements_from_arguments(const std::vector<std::string>& arguments);

} // namespace f2b
