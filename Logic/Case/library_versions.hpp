#pragma once

#include <string>
#include <utility>
#include <vector>

namespace f2b
{

/// FaceToBone's own version and those of the libraries that computed.
std::vector<std::pair<std::string, std::string>> library_versions();

} // namespace f2b
