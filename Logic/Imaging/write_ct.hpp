#pragma once

#include "Imaging/ct_image.hpp"

#include <filesystem>

namespace f2b
{

/// Writes a compressed NRRD (.nrrd). Throws Error if the file cannot be written.
void write_ct(const CtImage& ct, const std::filesystem::path& path);

} // namespace f2b
