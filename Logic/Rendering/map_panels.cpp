#include <Rendering/map_panels.hpp>

#include <Core/error.hpp>
#include <Rendering/annotation.hpp>
#include <Rendering/map_arrays.hpp>
#include <Rendering/offscreen_display.hpp>
#include <Rendering/quiet_messages.hpp>
#include <Rendering/surface_look.hpp>

#include <vtkPointData.h>

#include <algorithm>

namespace f2b
{

namespace
{

void require_values(const MapPanels& maps)
{
  if (maps.panels.empty())
  {
    throw Error("colour map", "there is nothing to draw", "give at least one panel");
  }
  for (const MapPanel& panel : maps.panels)
  {
    if (!panel.surface || panel.surface->GetNumberOfPoints() == 0 ||
        !panel.surface->GetPointData()->GetArray(MapPanel::values))
    {
      throw Error("colour map '" + panel.title + "'", "its surface has no points or no values",
                  "give each panel a surface with the array " + std::string(MapPanel::values));
    }
  }
}

// One map for all, that shows 99 % of their values.
vtkSmartPointer<vtkLookupTable> common_map(const MapPanels& maps)
{
  std::vector<double> all;
  for (const MapPanel& panel : maps.panels)
  {
    const std::vector<double> values = point_values(panel.surface, MapPanel::values);
    all.insert(all.end(), values.begin(), values.end());
  }
  const double range = nice_range(all, 0.99, maps.least_range_mm);
  return maps.is_signed ? diverging_map(range) : sequential_map(range);
}

} // namespace

Image map_panels_picture(const MapPanels& maps, PixelSize panel_size)
{
  require_values(maps);
  const ViewAxes axes = view_axes(require_view(maps.view));
  const OffscreenDisplay display;
  const QuietMessages quiet;
  std::vector<Surface> surfaces;
  bool partly = false;
  for (const MapPanel& panel : maps.panels)
  {
    surfaces.push_back(with_normals(panel.surface));
    partly = partly || has_unknown_values(panel.surface, MapPanel::values);
  }
  const auto map = common_map(maps);
  const int count = static_cast<int>(surfaces.size());
  Picture picture(count, {count * panel_size.width, panel_size.height});
  const Margins margins = annotation_margins(picture.panel(0), partly ? 1 : 0);
  const Extents box = extents(surfaces, axes);
  const double mm_per_pixel = fitting_mm_per_pixel(box, panel_size, margins);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const Panel& panel = picture.panel(static_cast<int>(i));
    add_map(panel, surfaces[i], MapPanel::values, map);
    add_title(panel, maps.panels[i].title, maps.panels[i].subtitle);
    aim(panel, axes, box, margins, mm_per_pixel);
    add_orientation(panel, axes);
  }
  if (partly)
  {
    add_legend(picture.panel(0), {{"not computed", no_value_colour}});
  }
  // the bar takes the scale's place in the middle panel
  const std::size_t middle = surfaces.size() / 2;
  add_value_bar(picture.panel(static_cast<int>(middle)), map, maps.bar_title);
  if (middle != 0)
  {
    add_scale(picture.panel(0), mm_per_pixel);
  }
  return picture.render();
}

} // namespace f2b
