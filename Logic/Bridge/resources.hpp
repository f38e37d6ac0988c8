#pragma once

#include <string>
#include <vector>

namespace f2b
{

/// A file of Resources/ that the program carries in itself, such as `materials/table1-stable.json`;
/// null if it carries none of that name.
const std::string* carried_resource(const std::string& path);

/// The paths of all carried files that begin so, in alphabetical order.
std::vector<std::string> carried_resources(const std::string& beginning);

} // namespace f2b
