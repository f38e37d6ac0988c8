#pragma once

#include <Rendering/colour_maps.hpp>
#include <Rendering/picture.hpp>

#include <string>
#include <vector>

/// How do curves over one quantity become a picture?
namespace f2b
{

struct PlottedSeries
{
  enum class Style
  {
    Line,
    DashedLine,
    Points,
  };
  std::string label; ///< in the legend
  std::vector<double> x, y;
  Style style = Style::Line;
  Colour colour{0, 0, 0};
};

struct CurvePlot
{
  std::string title;
  std::string x_title, y_title; ///< with units
  std::vector<PlottedSeries> series;
};

/// Draws axes, grid, series and legend. Needs a display (OffscreenDisplay).
/// \throws f2b::Error when VTK cannot draw
Image draw_plot(const CurvePlot& plot, PixelSize size = {1200, 900});

} // namespace f2b
