#pragma once

#include <string>

namespace f2b
{

/// A file of Resources/ that the program carries in itself, such as `Materials/table1-stable.json`;
/// null if it carries none of that name.
const std::string* carried_resource(const std::string& path);

} // namespace f2b
