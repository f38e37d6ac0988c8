#pragma once

#include <Rendering/draw_picture.hpp>

#include <filesystem>

/// How does a plan become a folder of pictures?
namespace f2b
{

struct WrittenPicture
{
  std::string name; ///< file name without ".png"; texts "picture.NAME.title" and ".caption" tell it
  std::filesystem::path path;
};

/// The pictures of a report, of all that a plan has: those of a missing target, prediction, mesh or
/// CT are left out.
std::vector<PictureDefinition> report_pictures(const PlanScene& scene);

/// Draws and writes pictures; each file appears whole or not at all. Starts and stops a display of
/// its own where none is there.
/// \param folder  must exist
/// \throws f2b::Error on unfit definitions, no display, or when a file cannot be written
std::vector<WrittenPicture> write_pictures(const PlanScene& scene,
                                           const std::vector<PictureDefinition>& definitions,
                                           const std::filesystem::path& folder, const Texts& texts);

} // namespace f2b
