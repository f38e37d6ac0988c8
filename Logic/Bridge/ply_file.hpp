#pragma once

#include <filesystem>

/// Is a .ply file whole?
namespace f2b
{

/// Throws Error where the header is none, or where the file ends before the elements that it
/// announces: VTK's reader trusts both.
void require_whole_ply(const std::filesystem::path& path);

} // namespace f2b
