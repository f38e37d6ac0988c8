#pragma once

#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// How does a plan become a folder of pictures?
namespace f2b
{

struct WrittenPicture
{
  std::string name;    ///< file name without ".png", such as "distance_map"
  std::string title;   ///< for a report
  std::string caption; ///< what to see, in a sentence or two; also fit as an alternative text
  std::filesystem::path path;
  bool belongs_in_report = false; ///< the comparisons do; their single parts do not
};

struct PictureOptions
{
  PixelSize single{1200, 1000};
  PixelSize panel{800, 1000}; ///< of each part of a comparison
  bool singles = true;        ///< also write every part of a comparison as a picture of its own
};

/// Draws everything that the plan has: pictures of a missing target or prediction are left out.
/// Starts and stops a display of its own where none is there. Each file appears whole or not at
/// all.
/// \param folder  must exist
/// \throws f2b::Error on unfit surfaces, no display, or when a file cannot be written
std::vector<WrittenPicture> write_plan_pictures(const PlanPictures& pictures,
                                                const std::filesystem::path& folder,
                                                const PictureOptions& options = {});

} // namespace f2b
