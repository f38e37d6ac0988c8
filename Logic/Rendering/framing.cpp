#include <Rendering/framing.hpp>

#include <Core/error.hpp>

#include <vtkCamera.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace f2b
{

namespace
{

using Vector = std::array<double, 3>;

double dot(const Vector& a, const double* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector combine(const ViewAxes& axes, double right, double up, double depth)
{
  Vector point{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    point[i] = right * axes.right[i] + up * axes.up[i] + depth * axes.towards_viewer[i];
  }
  return point;
}

// Azimuth from +A towards +R, elevation towards +S.
ViewAxes axes_from_angles(double azimuth_deg, double elevation_deg)
{
  const double azimuth = azimuth_deg * M_PI / 180;
  const double elevation = elevation_deg * M_PI / 180;
  ViewAxes axes{};
  axes.towards_viewer = {std::sin(azimuth) * std::cos(elevation),
                         std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
  axes.right = {-std::cos(azimuth), std::sin(azimuth), 0};
  axes.up = cross(axes.towards_viewer, axes.right);
  return axes;
}

} // namespace

const std::vector<View>& named_views()
{
  static const std::vector<View> views{{"frontal", 0, 0},
                                       {"profile-right", 90, 0},
                                       {"profile-left", -90, 0},
                                       {"three-quarter-right", 42, 8},
                                       {"three-quarter-left", -42, 8},
                                       {"submental", 0, -60},
                                       {"top", 0, 90}};
  return views;
}

std::optional<View> view_named(const std::string& name)
{
  const auto& views = named_views();
  const auto found =
      std::find_if(views.begin(), views.end(), [&](const View& v) { return v.name == name; });
  return found == views.end() ? std::nullopt : std::optional<View>(*found);
}

View require_view(const std::string& name)
{
  if (const auto view = view_named(name))
  {
    return *view;
  }
  std::string known;
  for (const View& view : named_views())
  {
    known += (known.empty() ? "" : ", ") + view.name;
  }
  throw Error("view", "'" + name + "' is none", "name one of " + known);
}

ViewAxes view_axes(const View& view)
{
  return axes_from_angles(view.azimuth_deg, view.elevation_deg);
}

Extents extents(const std::vector<Surface>& surfaces, const ViewAxes& axes)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Extents box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Surface& surface : surfaces)
  {
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* x = surface->GetPoint(i);
      const Vector seen{dot(axes.right, x), dot(axes.up, x), dot(axes.towards_viewer, x)};
      for (std::size_t c = 0; c < 3; ++c)
      {
        box.low[c] = std::min(box.low[c], seen[c]);
        box.high[c] = std::max(box.high[c], seen[c]);
      }
    }
  }
  return box;
}

double fitting_mm_per_pixel(const Extents& box, PixelSize size, const Margins& margins)
{
  const double width = std::max(size.width - 2 * margins.side, 1.0);
  const double height = std::max(size.height - margins.top - margins.bottom, 1.0);
  const double needed =
      std::max((box.high[0] - box.low[0]) / width, (box.high[1] - box.low[1]) / height);
  return std::max(needed, 1e-6);
}

void aim(const Panel& panel, const ViewAxes& axes, const Extents& box, const Margins& margins,
         double mm_per_pixel)
{
  const double right = 0.5 * (box.low[0] + box.high[0]);
  const double up = 0.5 * (box.low[1] + box.high[1]);
  // The box's centre goes between the margins, which is not the panel's centre.
  const double shifted_up = up - 0.5 * (margins.bottom - margins.top) * mm_per_pixel;
  const double depth_range = std::max(box.high[2] - box.low[2], 1.0);
  const double distance = 2 * depth_range;
  const Vector focus = combine(axes, right, shifted_up, 0.5 * (box.low[2] + box.high[2]));
  vtkCamera* camera = panel.scene->GetActiveCamera();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(focus[0] + distance * axes.towards_viewer[0],
                      focus[1] + distance * axes.towards_viewer[1],
                      focus[2] + distance * axes.towards_viewer[2]);
  camera->SetViewUp(axes.up.data());
  camera->SetParallelScale(0.5 * panel.size.height * mm_per_pixel);
  camera->SetClippingRange(0.5 * depth_range, 3.5 * depth_range);
}

} // namespace f2b
