#pragma once

#include <Rendering/framing.hpp>
#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

/// How is the movement of a fragment's reference point drawn? An arrow to scale, and its mm.
namespace f2b
{

/// Where a fragment's matrix takes its reference point [mm, RAS].
std::array<double, 3> moved_reference_point(const FragmentPicture& fragment);

/// For an aimed panel.
void add_movement_arrow(const Panel& panel, const FragmentPicture& fragment, View view,
                        double mm_per_pixel);

} // namespace f2b
