#pragma once

#include <filesystem>
#include <string_view>

/// How does a file appear whole or not at all?
namespace f2b
{

/// Writes beside `path` under another name, then renames: a reader, or a kill at any moment, sees
/// the old file or the new one.
/// \throws f2b::Error naming `path` when the folder is not writable or the disk is full; nothing is
///         left behind then
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

} // namespace f2b
