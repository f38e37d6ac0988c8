#pragma once

#include <Rendering/colour_maps.hpp>
#include <Rendering/framing.hpp>
#include <Rendering/texts.hpp>

/// How sure is a movement? 90 % intervals drawn at the planned reference point, enlarged.
namespace f2b
{

constexpr Colour interval_colour{0.10, 0.10, 0.12};

/// A round number that makes the widest interval of the scene about 15 mm long to either side.
double interval_enlargement(const PlanScene& scene);

/// "right ±0.12, anterior ±0.61, superior ±0.40 mm; pitch ±0.3, roll ±0.1, yaw ±0.1°"; coordinates
/// that were not free are left out.
std::string interval_text(const MovementIntervals& intervals, const Texts& texts);

/// Three bars with end caps and their mm, for an aimed panel; those that point at the viewer have
/// no number.
void add_interval_glyph(const Panel& panel, const FragmentPicture& fragment, const ViewAxes& axes,
                        double enlarged, double mm_per_pixel);

} // namespace f2b
