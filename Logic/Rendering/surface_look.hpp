#pragma once

#include <Rendering/colour_maps.hpp>
#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

#include <string>

/// How do skin, bone, ghosts, maps and arrows look?
namespace f2b
{

constexpr Colour skin_colour{0.92, 0.73, 0.63};
constexpr Colour bone_colour{0.93, 0.87, 0.73};
constexpr Colour ghost_colour{0.42, 0.47, 0.55};
constexpr Colour cut_colour{0.72, 0.05, 0.27};
constexpr Colour arrow_colour{0.10, 0.10, 0.12};
constexpr double ghost_opacity = 0.28;

void add_skin(const Panel& panel, const Surface& surface, double opacity = 1);
/// Skin-coloured where a point array has a value, no_value_colour where it has none.
void add_skin_known_by(const Panel& panel, const Surface& surface, const std::string& array);
void add_bone(const Panel& panel, const Surface& surface, const Colour& colour);
/// Where something was: translucent.
void add_ghost(const Panel& panel, const Surface& surface);
/// One colour, translucent.
void add_translucent(const Panel& panel, const Surface& surface, const Colour& colour,
                     double opacity);
/// The same for a sheet that has no inside: both of its sides.
void add_open_translucent(const Panel& panel, const Surface& surface, const Colour& colour,
                          double opacity);
/// A point array in colours, lit softly so that the colours stay those of the bar.
void add_map(const Panel& panel, const Surface& surface, const std::string& array,
             vtkLookupTable* map);
/// A point array of whole numbers, each with the map's colour; no colours between them.
void add_categories(const Panel& panel, const Surface& surface, const std::string& array,
                    vtkLookupTable* map);
/// The same for a cell array.
void add_cell_categories(const Panel& panel, const Surface& surface, const std::string& array,
                         vtkLookupTable* map);
/// Lines where a point array has a value, on the surface.
void add_contour(const Panel& panel, const Surface& surface, const std::string& array, double value,
                 double width);
/// Polylines in one colour, always in front.
void add_outline(const Panel& panel, const Surface& lines, const Colour& colour, double width);
/// Planes of cuts, translucent, their outline always in front.
void add_planes(const Panel& panel, const Surface& planes);

/// An arrow from one point to another [mm, RAS], always in front.
/// \param thickness_mm  of its shaft
void add_arrow(const Panel& panel, const std::array<double, 3>& from,
               const std::array<double, 3>& to, double thickness_mm);

} // namespace f2b
