#pragma once

#include <Rendering/framing.hpp>
#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

#include <string>
#include <vector>

/// How do several results of one quantity compare? One panel each, one scale, one colour bar.
namespace f2b
{

struct MapPanel
{
  static constexpr const char* values = "map_mm"; ///< point array that is shown [mm], NaN: unknown

  Surface surface; ///< mm, RAS
  std::string title;
  std::string subtitle; ///< such as the error in numbers
};

struct MapPanels
{
  std::vector<MapPanel> panels; ///< from left to right
  std::string view = "three-quarter-right"; ///< of named_views()
  bool is_signed = true; ///< diverging about zero; else from zero on
  double least_range_mm = 0.5;
  std::string bar_title;
};

/// Starts and stops a display of its own where none is there.
/// \throws f2b::Error without panels, for a surface without points or values, or without a display
Image map_panels_picture(const MapPanels& maps, PixelSize panel_size);

} // namespace f2b
