#include <Rendering/draw_picture.hpp>

#include <Core/error.hpp>

#include <algorithm>

namespace f2b
{

namespace
{

/// One panel: which subject, and its place among the panels of that subject; slices side by side
/// count as one subject, whose legend they share.
struct PanelPlan
{
  std::size_t drawing = 0;
  ViewAxes axes{};
  std::string view_title;
  std::size_t place = 0, places = 1;
  bool has_title = true;
};

// A view that a user made up has no text of its own.
std::string view_title(const View& view, const Texts& texts)
{
  const std::string key = "view." + view.name;
  const std::string title = texts.has(key) ? texts(key) : view.name;
  return view.turned_deg == 0 ? title : title + " + " + std::to_string(view.turned_deg) + "\u00b0";
}

std::vector<PanelPlan> plan_panels(const std::vector<SubjectDrawing>& drawings,
                                   const std::vector<View>& views, const Texts& texts)
{
  std::vector<PanelPlan> panels;
  const auto slices = static_cast<std::size_t>(std::count_if(drawings.begin(), drawings.end(),
                                                             [](const SubjectDrawing& d)
                                                             { return d.fixed_view.has_value(); }));
  std::size_t slice = 0;
  for (std::size_t d = 0; d < drawings.size(); ++d)
  {
    if (const auto& fixed = drawings[d].fixed_view)
    {
      panels.push_back({d, fixed->axes, fixed->title, slice++, slices, true});
      continue;
    }
    for (std::size_t v = 0; v < views.size(); ++v)
    {
      panels.push_back(
          {d, view_axes(views[v]), view_title(views[v], texts), v, views.size(), v == 0});
    }
  }
  return panels;
}

// A long legend is spread over the panels of its subject.
std::size_t rows_per_panel(const SubjectDrawing& drawing, std::size_t panels)
{
  constexpr std::size_t short_legend = 3;
  const std::size_t rows = drawing.legend.size();
  return std::max(drawing.legend_rows, rows <= short_legend ? rows : (rows + panels - 1) / panels);
}

std::vector<LegendEntry> part_of(const std::vector<LegendEntry>& legend, std::size_t part,
                                 std::size_t rows)
{
  const auto first = legend.begin() + static_cast<long>(std::min(legend.size(), part * rows));
  const auto last = legend.begin() + static_cast<long>(std::min(legend.size(), (part + 1) * rows));
  return {first, last};
}

void annotate(const Panel& panel, const PanelPlan& plan, const SubjectDrawing& drawing,
              double mm_per_pixel)
{
  add_title(panel, plan.has_title ? drawing.title : "", plan.view_title);
  add_orientation(panel, plan.axes);
  const std::size_t rows = rows_per_panel(drawing, plan.places);
  if (rows > 0)
  {
    add_legend(panel, part_of(drawing.legend, plan.place, rows));
  }
  const bool is_middle = plan.place == plan.places / 2;
  if (drawing.bar && is_middle)
  {
    add_value_bar(panel, drawing.bar->map, drawing.bar->title);
  }
  else
  {
    add_scale(panel, mm_per_pixel);
  }
}

} // namespace

int panel_count(const PictureDefinition& definition)
{
  std::size_t panels = 0;
  for (const Subject subject : definition.show)
  {
    panels += is_ct_slice(subject) ? 1 : definition.views.size();
  }
  return static_cast<int>(panels);
}

Image draw_picture(const PlanScene& scene, const PictureDefinition& definition, const Texts& texts)
{
  std::vector<SubjectDrawing> drawings;
  for (const Subject subject : definition.show)
  {
    drawings.push_back(subject_drawing(subject, scene, texts, definition.options));
  }
  const std::vector<PanelPlan> panels = plan_panels(drawings, definition.views, texts);
  if (panels.empty())
  {
    throw Error("picture '" + definition.name + "'", "it shows nothing",
                "name a subject and a view");
  }
  Picture picture(static_cast<int>(panels.size()), definition.size, definition.background);
  std::size_t rows = 0;
  for (const PanelPlan& plan : panels)
  {
    rows = std::max(rows, rows_per_panel(drawings[plan.drawing], plan.places));
  }
  const Margins margins = annotation_margins(picture.panel(0), rows);
  std::vector<Extents> boxes;
  double mm_per_pixel = 0;
  for (const PanelPlan& plan : panels)
  {
    boxes.push_back(extents(drawings[plan.drawing].framed, plan.axes));
    mm_per_pixel =
        std::max(mm_per_pixel, fitting_mm_per_pixel(boxes.back(), picture.panel(0).size, margins));
  }
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    const Panel& panel = picture.panel(static_cast<int>(i));
    const SubjectDrawing& drawing = drawings[panels[i].drawing];
    aim(panel, panels[i].axes, boxes[i], margins, mm_per_pixel);
    drawing.draw(panel, panels[i].axes, mm_per_pixel);
    annotate(panel, panels[i], drawing, mm_per_pixel);
  }
  return picture.render();
}

} // namespace f2b
