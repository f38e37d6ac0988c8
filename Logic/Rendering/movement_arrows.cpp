#include <Rendering/movement_arrows.hpp>

#include <Rendering/annotation.hpp>
#include <Rendering/surface_look.hpp>

#include <vtkCamera.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{

namespace
{

using Point = std::array<double, 3>;

std::string length_text(double length_mm)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f mm", length_mm);
  return text.data();
}

} // namespace

PanelPosition seen_at(const Panel& panel, const ViewAxes& axes, const Point& point,
                      double mm_per_pixel)
{
  Point offset{};
  vtkMath::Subtract(point.data(), panel.scene->GetActiveCamera()->GetFocalPoint(), offset.data());
  return {0.5 * panel.size.width + vtkMath::Dot(offset.data(), axes.right.data()) / mm_per_pixel,
          0.5 * panel.size.height + vtkMath::Dot(offset.data(), axes.up.data()) / mm_per_pixel};
}

Point moved_reference_point(const FragmentPicture& fragment)
{
  const auto& m = fragment.matrix_ras;
  const auto& c = fragment.reference_point_ras;
  Point moved{};
  for (std::size_t row = 0; row < 3; ++row)
  {
    moved[row] = m[4 * row] * c[0] + m[4 * row + 1] * c[1] + m[4 * row + 2] * c[2] + m[4 * row + 3];
  }
  return moved;
}

void add_movement_arrow(const Panel& panel, const FragmentPicture& fragment, const ViewAxes& axes,
                        double mm_per_pixel)
{
  const double unit = annotation_unit(panel);
  const Point from = fragment.reference_point_ras;
  const Point to = moved_reference_point(fragment);
  add_arrow(panel, from, to, 6 * unit * mm_per_pixel);

  const double length = std::sqrt(vtkMath::Distance2BetweenPoints(from.data(), to.data()));
  const std::string text = length_text(length);
  const PanelPosition at = seen_at(panel, axes, to, mm_per_pixel);
  const double size = 22 * unit;
  const double width = 0.62 * size * static_cast<double>(text.size());
  const double x = std::clamp(at.x + 14 * unit, 0.0, panel.size.width - width);
  const double y = at.y - 1.6 * size;
  add_rectangle(panel, x, y, width, 1.35 * size, {1, 1, 1}, 0.82);
  add_text(panel, x + 0.5 * width, y + 0.12 * size, text,
           {size, true, Align::Centre, 0, arrow_colour});
}

} // namespace f2b
