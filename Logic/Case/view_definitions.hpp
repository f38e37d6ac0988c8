#pragma once

#include "Case/case_folder.hpp"
#include "Rendering/draw_picture.hpp"

/// Which pictures does a file of view definitions ask for? (Resources/Schema/views.schema.json)
namespace f2b
{

/// Throws Error with the first fault of the file.
std::vector<PictureDefinition> read_view_definitions(const Path& file);

/// light, white, dark or transparent; throws Error for others.
Background require_background(const std::string& name);

} // namespace f2b
