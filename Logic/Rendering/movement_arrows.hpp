#pragma once

#include <Rendering/framing.hpp>
#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

/// How is the movement of a fragment's reference point drawn? An arrow to scale, and its mm.
namespace f2b
{

/// Output pixels from a panel's bottom left corner.
struct PanelPosition
{
  double x = 0, y = 0;
};

/// Where a point [mm, RAS] is seen in an aimed panel.
PanelPosition seen_at(const Panel& panel, const ViewAxes& axes, const std::array<double, 3>& point,
                      double mm_per_pixel);

/// Where a fragment's matrix takes its reference point [mm, RAS].
std::array<double, 3> moved_reference_point(const FragmentPicture& fragment);

/// For an aimed panel.
void add_movement_arrow(const Panel& panel, const FragmentPicture& fragment, const ViewAxes& axes,
                        double mm_per_pixel);

} // namespace f2b
