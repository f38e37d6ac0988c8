#include <Rendering/interval_glyph.hpp>

#include <Rendering/annotation.hpp>
#include <Rendering/movement_arrows.hpp>

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{

namespace
{

using Point = std::array<double, 3>;

constexpr double longest_bar_mm = 15;

const std::array<Point, 3> directions{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

std::string half_width_text(double half_width)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "\u00b1%.2f", half_width);
  return text.data();
}

// A bar with a cap at each end; both ends in pixels of the panel.
void add_bar(const Panel& panel, const PanelPosition& from, const PanelPosition& to, double unit)
{
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const double cap = 9 * unit, nx = -dy / length * cap, ny = dx / length * cap;
  for (const auto& [width, colour] :
       {std::pair(8 * unit, Colour{1, 1, 1}), std::pair(4 * unit, interval_colour)})
  {
    add_line(panel, from.x, from.y, to.x, to.y, width, colour);
    for (const PanelPosition& end : {from, to})
    {
      add_line(panel, end.x - nx, end.y - ny, end.x + nx, end.y + ny, width, colour);
    }
  }
}

// Beyond the bar's end, on the side that the bar points to. A level bar's number goes below it, so
// that it never meets an upright one's.
void add_number(const Panel& panel, const PanelPosition& from, const PanelPosition& at,
                const std::string& text)
{
  const double unit = annotation_unit(panel);
  const double size = 20 * unit, width = 0.62 * size * static_cast<double>(text.size());
  const double wanted = at.x < from.x - 1 ? at.x - 14 * unit - width : at.x + 14 * unit;
  const bool is_level = std::abs(at.y - from.y) < 0.5 * std::abs(at.x - from.x);
  const double y = is_level || at.y < from.y - 1 ? at.y - 8 * unit - 1.35 * size : at.y + 6 * unit;
  const double x = std::clamp(wanted, 0.0, panel.size.width - width);
  add_rectangle(panel, x, y, width, 1.35 * size, {1, 1, 1}, 0.82);
  add_text(panel, x + 0.5 * width, y + 0.12 * size, text,
           {size, true, Align::Centre, 0, interval_colour});
}

std::string joined(const std::array<double, 3>& half, const std::array<const char*, 3>& keys,
                   const Texts& texts)
{
  std::string list;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (std::isfinite(half[i]))
    {
      list += (list.empty() ? "" : ", ") + texts(keys[i]) + " " + half_width_text(half[i]);
    }
  }
  return list;
}

} // namespace

double interval_enlargement(const PlanScene& scene)
{
  double widest = 0;
  for (const FragmentPicture& fragment : scene.pictures().fragments)
  {
    for (std::size_t i = 0; fragment.intervals && i < 3; ++i)
    {
      const double half = fragment.intervals->translation_mm[i];
      widest = std::isfinite(half) ? std::max(widest, half) : widest;
    }
  }
  for (const double times : {100.0, 50.0, 20.0, 10.0, 5.0, 2.0})
  {
    if (widest * times <= 1.4 * longest_bar_mm)
    {
      return times;
    }
  }
  return 1;
}

std::string interval_text(const MovementIntervals& intervals, const Texts& texts)
{
  const std::string mm =
      joined(intervals.translation_mm, {"axis.right", "axis.anterior", "axis.superior"}, texts);
  const std::string degrees =
      joined(intervals.rotation_deg, {"axis.pitch", "axis.roll", "axis.yaw"}, texts);
  return mm + (mm.empty() ? "" : " mm") + (mm.empty() || degrees.empty() ? "" : "; ") + degrees +
         (degrees.empty() ? "" : "\u00b0");
}

void add_interval_glyph(const Panel& panel, const FragmentPicture& fragment, const ViewAxes& axes,
                        double enlarged, double mm_per_pixel)
{
  const Point centre = moved_reference_point(fragment);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double half = fragment.intervals->translation_mm[i];
    const double facing = std::abs(vtkMath::Dot(directions[i].data(), axes.towards_viewer.data()));
    if (!std::isfinite(half) || facing > 0.97)
    {
      continue;
    }
    Point low = centre, high = centre;
    for (std::size_t c = 0; c < 3; ++c)
    {
      low[c] -= half * enlarged * directions[i][c];
      high[c] += half * enlarged * directions[i][c];
    }
    const PanelPosition begin = seen_at(panel, axes, low, mm_per_pixel);
    const PanelPosition end = seen_at(panel, axes, high, mm_per_pixel);
    add_bar(panel, begin, end, annotation_unit(panel));
    add_number(panel, begin, end, half_width_text(half) + " mm");
  }
}

} // namespace f2b
