#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace f2b
{

/// Reads a JSON file that holds an object; throws Error naming the file and the line where it cannot
/// be read.
nlohmann::json read_json(const std::filesystem::path& path);
/// Writes indented JSON with numbers that read back exactly; throws Error if the file cannot be
/// written.
void write_json(const std::filesystem::path& path, const nlohmann::json& document);

} // namespace f2b
