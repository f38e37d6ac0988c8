#include <Rendering/annotation.hpp>

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{

namespace
{

constexpr double title_size = 32;
constexpr double body_size = 21;
constexpr double edge = 28; ///< distance of annotations from the panel's edge
constexpr double legend_step = 32;
constexpr double header_height = 104;
constexpr double footer_height = 132;

std::string number_text(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

// Ticks fall on round numbers for the ranges that nice_ceiling() gives.
int tick_intervals(double low, double high)
{
  const double mantissa = high / std::pow(10.0, std::floor(std::log10(high) + 1e-9));
  const bool is_symmetric = low < 0;
  for (const double three : {1.5, 3.0, 6.0})
  {
    if (std::abs(mantissa - three) < 0.01)
    {
      return is_symmetric ? 6 : 3;
    }
  }
  const bool is_one_or_five = std::abs(mantissa - 1) < 0.01 || std::abs(mantissa - 5) < 0.01;
  return !is_symmetric && is_one_or_five ? 5 : 4;
}

vtkSmartPointer<vtkPolyData> make_flat(const std::vector<std::array<double, 2>>& corners,
                                       double scale)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(corners.size()));
  for (const auto& corner : corners)
  {
    cells->InsertCellPoint(points->InsertNextPoint(corner[0] * scale, corner[1] * scale, 0));
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  if (corners.size() == 2)
  {
    shape->SetLines(cells);
  }
  else
  {
    shape->SetPolys(cells);
  }
  return shape;
}

vtkSmartPointer<vtkActor2D> add_flat(const Panel& panel, vtkPolyData* shape, const Colour& colour)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  panel.front->AddViewProp(actor);
  return actor;
}

// All steps of the bar in one shape: one quad per colour.
vtkSmartPointer<vtkPolyData> make_bar(vtkLookupTable* map, double x, double y, double width,
                                      double height)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  const vtkIdType count = map->GetNumberOfTableValues();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double left = x + width * static_cast<double>(i) / static_cast<double>(count);
    const double right = x + width * static_cast<double>(i + 1) / static_cast<double>(count);
    cells->InsertNextCell(4);
    for (const auto& [px, py] : {std::pair(left, y), std::pair(right, y),
                                 std::pair(right, y + height), std::pair(left, y + height)})
    {
      cells->InsertCellPoint(points->InsertNextPoint(px, py, 0));
    }
    const double* c = map->GetTableValue(i);
    colours->InsertNextTuple3(std::round(255 * c[0]), std::round(255 * c[1]),
                              std::round(255 * c[2]));
  }
  auto bar = vtkSmartPointer<vtkPolyData>::New();
  bar->SetPoints(points);
  bar->SetPolys(cells);
  bar->GetCellData()->SetScalars(colours);
  return bar;
}

void set_style(vtkTextProperty* property, const TextStyle& style, double pixels)
{
  property->SetFontFamilyToArial();
  property->SetFontSize(std::max(1, static_cast<int>(std::lround(pixels))));
  property->SetBold(style.bold);
  property->SetColor(style.colour[0], style.colour[1], style.colour[2]);
  property->SetVerticalJustificationToBottom();
  property->SetJustification(style.align == Align::Left     ? VTK_TEXT_LEFT
                             : style.align == Align::Centre ? VTK_TEXT_CENTERED
                                                            : VTK_TEXT_RIGHT);
}

struct AxisLetter
{
  const char* letter;
  std::array<double, 3> direction;
};
constexpr std::array<AxisLetter, 6> axis_letters{{{"R", {1, 0, 0}},
                                                  {"L", {-1, 0, 0}},
                                                  {"A", {0, 1, 0}},
                                                  {"P", {0, -1, 0}},
                                                  {"S", {0, 0, 1}},
                                                  {"I", {0, 0, -1}}}};

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

double annotation_unit(const Panel& panel)
{
  // Narrow panels (half a picture and less) get smaller type too.
  return panel.type_scale * std::min(panel.size.height / 1000.0, panel.size.width / 760.0);
}

Margins annotation_margins(const Panel& panel, std::size_t legend_rows)
{
  const double unit = annotation_unit(panel);
  return {unit * (header_height + legend_step * static_cast<double>(legend_rows)),
          unit * footer_height, unit * edge};
}

void add_text(const Panel& panel, double x, double y, const std::string& text,
              const TextStyle& style)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  const double pixels = style.size * panel.scale;
  set_style(actor->GetTextProperty(), style, pixels);
  std::array<double, 2> drawn{};
  actor->GetSize(panel.front, drawn.data());
  const double limit = style.max_width * panel.scale;
  if (limit > 0 && drawn[0] > limit)
  {
    set_style(actor->GetTextProperty(), style, pixels * limit / drawn[0]);
  }
  actor->SetPosition(x * panel.scale, y * panel.scale);
  panel.front->AddViewProp(actor);
}

void add_rectangle(const Panel& panel, double x, double y, double width, double height,
                   const Colour& colour, double opacity)
{
  const auto shape =
      make_flat({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, panel.scale);
  add_flat(panel, shape, colour)->GetProperty()->SetOpacity(opacity);
}

void add_line(const Panel& panel, double x0, double y0, double x1, double y1, double width,
              const Colour& colour)
{
  const auto shape = make_flat({{x0, y0}, {x1, y1}}, panel.scale);
  add_flat(panel, shape, colour)
      ->GetProperty()
      ->SetLineWidth(static_cast<float>(width * panel.scale));
}

void add_title(const Panel& panel, const std::string& title, const std::string& subtitle)
{
  const double unit = annotation_unit(panel);
  const double top = panel.size.height;
  const double width = panel.size.width - 2 * edge * unit;
  add_text(panel, edge * unit, top - 60 * unit, title,
           {title_size * unit, true, Align::Left, width, panel.ink});
  add_text(panel, edge * unit, top - 90 * unit, subtitle,
           {body_size * unit, false, Align::Left, width, panel.pale_ink});
}

void add_legend(const Panel& panel, const std::vector<LegendEntry>& entries)
{
  const double unit = annotation_unit(panel);
  const double patch = 20 * unit;
  double y = panel.size.height - header_height * unit - patch;
  for (const LegendEntry& entry : entries)
  {
    const double rim = 1.5 * unit; // a black patch would not be seen on black
    add_rectangle(panel, edge * unit - rim, y - rim, patch + 2 * rim, patch + 2 * rim,
                  panel.pale_ink, 0.5);
    add_rectangle(panel, edge * unit, y, patch, patch, panel.paper);
    add_rectangle(panel, edge * unit, y, patch, patch, entry.colour, entry.opacity);
    add_text(panel, edge * unit + 1.6 * patch, y - 1 * unit, entry.text,
             {body_size * unit, false, Align::Left,
              panel.size.width - 2 * edge * unit - 1.6 * patch, panel.ink});
    y -= legend_step * unit;
  }
}

void add_orientation(const Panel& panel, const ViewAxes& axes)
{
  const double unit = annotation_unit(panel);
  const double centre_x = (edge + 42) * unit, centre_y = (edge + 40) * unit;
  const double arm = 24 * unit;
  for (const AxisLetter& axis : axis_letters)
  {
    const double dx = dot(axis.direction, axes.right), dy = dot(axis.direction, axes.up);
    // An oblique view would give two letters in one place: the one that points away is left out.
    const double depth = dot(axis.direction, axes.towards_viewer);
    const double length = std::hypot(dx, dy);
    if (depth < -0.2 || length < 0.3)
    {
      continue;
    }
    add_line(panel, centre_x, centre_y, centre_x + arm * dx, centre_y + arm * dy, 2 * unit,
             panel.pale_ink);
    const double reach = arm * length + 13 * unit;
    add_text(panel, centre_x + reach * dx / length, centre_y + reach * dy / length - 10 * unit,
             axis.letter, {18 * unit, true, Align::Centre, 0, panel.ink});
  }
}

void add_scale(const Panel& panel, double mm_per_pixel)
{
  const double unit = annotation_unit(panel);
  double length_mm = nice_ceiling(0.12 * panel.size.width * mm_per_pixel);
  const double length = length_mm / mm_per_pixel;
  const double right = panel.size.width - edge * unit;
  const double y = (edge + 8) * unit;
  add_line(panel, right - length, y, right, y, 3 * unit, panel.ink);
  for (const double x : {right - length, right})
  {
    add_line(panel, x, y - 6 * unit, x, y + 6 * unit, 2 * unit, panel.ink);
  }
  add_text(panel, right - 0.5 * length, y + 10 * unit, number_text(length_mm) + " mm",
           {18 * unit, false, Align::Centre, 0, panel.ink});
}

void add_value_bar(const Panel& panel, vtkLookupTable* map, const std::string& title)
{
  const double unit = annotation_unit(panel);
  const double left = (edge + 116) * unit; // the orientation's cross is left of it
  const double right = panel.size.width - 2 * edge * unit;
  const double width = std::min(right - left, 560 * unit), height = 22 * unit;
  const double x = 0.5 * (left + right - width), y = (edge + 36) * unit;
  add_rectangle(panel, x - 1.5 * unit, y - 1.5 * unit, width + 3 * unit, height + 3 * unit,
                panel.ink);
  const auto bar =
      make_bar(map, x * panel.scale, y * panel.scale, width * panel.scale, height * panel.scale);
  add_flat(panel, bar, panel.ink);
  const double* range = map->GetTableRange();
  const int intervals = tick_intervals(range[0], range[1]);
  for (int tick = 0; tick <= intervals; ++tick)
  {
    const double share = static_cast<double>(tick) / intervals;
    const double at = x + width * share;
    add_line(panel, at, y - 8 * unit, at, y, 1.5 * unit, panel.ink);
    add_text(panel, at, y - 34 * unit, number_text(range[0] + (range[1] - range[0]) * share),
             {body_size * unit, false, Align::Centre, 0, panel.ink});
  }
  add_text(panel, x + 0.5 * width, y + height + 10 * unit, title,
           {body_size * unit, true, Align::Centre, right - left, panel.ink});
}

} // namespace f2b
