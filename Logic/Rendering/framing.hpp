#pragma once

#include <Rendering/picture.hpp>
#include <Rendering/plan_scene.hpp>

#include <optional>
#include <string>
#include <vector>

/// From where do we look, and how large do we draw, so that nothing is cut off?
///
/// Parallel projection: a millimetre is as long everywhere in a picture. RAS, mm.
namespace f2b
{

/// A direction to look from; the picture's up is as near to +S as it can be.
struct View
{
  std::string name;         ///< "profile-right"; its title is the text "view.profile-right"
  double azimuth_deg = 0;   ///< from +A (0: from in front) towards +R
  double elevation_deg = 0; ///< towards +S (90: from above)
  int turned_deg = 0; ///< how far azimuth_deg is from the view of that name, which its title tells
};

/// frontal, profile-right, profile-left, three-quarter-right, three-quarter-left, submental, top.
/// In the frontal view the patient's right is on the picture's left.
const std::vector<View>& named_views();
std::optional<View> view_named(const std::string& name);
/// Throws f2b::Error naming the views that there are.
View require_view(const std::string& name);

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
ViewAxes view_axes(const View& view);

/// The box that surfaces fill in a view's own axes [mm].
struct Extents
{
  std::array<double, 3> low;
  std::array<double, 3> high;
};
Extents extents(const std::vector<Surface>& surfaces, const ViewAxes& axes);

/// Millimetres of one output pixel at which the box just fits between the margins.
double fitting_mm_per_pixel(const Extents& box, PixelSize size, const Margins& margins);

/// Centres the box between the margins.
void aim(const Panel& panel, const ViewAxes& axes, const Extents& box, const Margins& margins,
         double mm_per_pixel);

} // namespace f2b
