#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// How do text and pictures get into HTML without harm?
namespace f2b
{

/// Text that shows as it is, in an element or in a quoted attribute. Control characters, which HTML
/// does not allow, become U+FFFD.
std::string html_escaped(std::string_view text);

std::string base64(std::string_view bytes);

/// "data:image/png;base64,...".
/// \throws f2b::Error naming the file when it cannot be read or is no PNG
std::string png_data_uri(const std::filesystem::path& png);

} // namespace f2b
