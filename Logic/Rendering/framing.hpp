#pragma once

#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

#include <string>
#include <vector>

/// From where do we look, and how large do we draw, so that nothing is cut off?
///
/// Parallel projection: a millimetre is as long everywhere in a picture. RAS, mm.
namespace f2b
{

enum class View
{
  Frontal,      ///< the patient's right on the picture's left
  Lateral,      ///< seen from the patient's right, nose to the right
  ThreeQuarter, ///< between both, slightly from above
};

constexpr std::array<View, 3> all_views{View::Frontal, View::Lateral, View::ThreeQuarter};

/// "frontal", "lateral", "three_quarter": for file names.
std::string view_name(View view);
/// "Frontal", "Lateral from the right", "Three-quarter": for people.
std::string view_title(View view);

/// Space that annotations take at a panel's edges [output pixels].
struct Margins
{
  double top = 0;
  double bottom = 0;
  double side = 0;
};

/// The picture's axes in RAS.
struct ViewAxes
{
  std::array<double, 3> right;
  std::array<double, 3> up;
  std::array<double, 3> towards_viewer;
};
ViewAxes view_axes(View view);

/// The box that surfaces fill in a view's own axes [mm].
struct Extents
{
  std::array<double, 3> low;
  std::array<double, 3> high;
};
Extents extents(const std::vector<Surface>& surfaces, View view);

/// Millimetres of one output pixel at which the box just fits between the margins.
double fitting_mm_per_pixel(const Extents& box, PixelSize size, const Margins& margins);

/// Centres the box between the margins.
void aim(const Panel& panel, View view, const Extents& box, const Margins& margins,
         double mm_per_pixel);

} // namespace f2b
