#pragma once

#include "Case/case_folder.hpp"

namespace f2b
{

/// SHA-256 of a file's bytes as 64 hexadecimal digits, as sha256sum prints it. Throws Error if the
/// file cannot be read.
std::string sha256_of(const Path& file);
std::string sha256_of_text(const std::string& text);

} // namespace f2b
