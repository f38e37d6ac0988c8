#pragma once

#include <Rendering/colour_maps.hpp>
#include <Rendering/framing.hpp>
#include <Rendering/picture.hpp>

#include <string>
#include <vector>

/// What is written on a picture? Titles, legends, value bars, the scale and the orientation.
///
/// Positions in output pixels from the panel's bottom left corner.
namespace f2b
{

enum class Align
{
  Left,
  Centre,
  Right,
};

struct TextStyle
{
  double size = 20; ///< output pixels
  bool bold = false;
  Align align = Align::Left;
  double max_width = 0; ///< output pixels; longer text is drawn smaller; 0: no limit
  Colour colour{0.13, 0.15, 0.18};
};

struct LegendEntry
{
  std::string text;
  Colour colour{};
  double opacity = 1;
};

/// Type grows with the picture: 1 for one panel of 1000 pixels' height.
double annotation_unit(const Panel& panel);

/// Space that the annotations below need.
/// \param legend_rows  number of legend entries
Margins annotation_margins(const Panel& panel, std::size_t legend_rows);

void add_text(const Panel& panel, double x, double y, const std::string& text,
              const TextStyle& style);
void add_rectangle(const Panel& panel, double x, double y, double width, double height,
                   const Colour& colour, double opacity = 1);
void add_line(const Panel& panel, double x0, double y0, double x1, double y1, double width,
              const Colour& colour);

/// Title and subtitle at the top left.
void add_title(const Panel& panel, const std::string& title, const std::string& subtitle);
/// Rows of colour patch and text under the title.
void add_legend(const Panel& panel, const std::vector<LegendEntry>& entries);
/// Letters R L A P S I around a small cross at the bottom left.
void add_orientation(const Panel& panel, const ViewAxes& axes);
/// A line of a round number of mm at the bottom right.
void add_scale(const Panel& panel, double mm_per_pixel);
/// A horizontal colour bar with ticks at the bottom, its title above it; takes the scale's place.
void add_value_bar(const Panel& panel, vtkLookupTable* map, const std::string& title);

} // namespace f2b
