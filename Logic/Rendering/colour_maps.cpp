#include <Rendering/colour_maps.hpp>

#include <Core/geometry/face_regions.hpp>

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

constexpr int table_size = 256;

Colour interpolate(const std::vector<Colour>& stops, double fraction)
{
  const double position = fraction * static_cast<double>(stops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double weight = position - static_cast<double>(first);
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    colour[c] = (1 - weight) * stops[first][c] + weight * stops[first + 1][c];
  }
  return colour;
}

vtkSmartPointer<vtkLookupTable> make_table(const std::vector<Colour>& stops, double low,
                                           double high)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(table_size);
  table->SetTableRange(low, high);
  for (int i = 0; i < table_size; ++i)
  {
    const Colour c = interpolate(stops, i / (table_size - 1.0));
    table->SetTableValue(i, c[0], c[1], c[2], 1.0);
  }
  table->SetNanColor(no_value_colour[0], no_value_colour[1], no_value_colour[2], 1.0);
  return table;
}

} // namespace

vtkSmartPointer<vtkLookupTable> diverging_map(double range_mm)
{
  static const std::vector<Colour> stops{
      {0.02, 0.19, 0.50}, {0.13, 0.40, 0.72}, {0.42, 0.66, 0.85},
      {0.78, 0.88, 0.95}, {0.97, 0.97, 0.97}, {0.99, 0.84, 0.76},
      {0.95, 0.58, 0.46}, {0.80, 0.22, 0.22}, {0.50, 0.00, 0.10}};
  return make_table(stops, -range_mm, range_mm);
}

vtkSmartPointer<vtkLookupTable> sequential_map(double range_mm)
{
  static const std::vector<Colour> stops{{0.95, 0.94, 0.92}, {0.99, 0.85, 0.62},
                                         {0.98, 0.64, 0.42}, {0.88, 0.38, 0.40},
                                         {0.62, 0.18, 0.48}, {0.30, 0.07, 0.42}};
  return make_table(stops, 0, range_mm);
}

vtkSmartPointer<vtkLookupTable> region_map()
{
  // in the order of FaceRegion's values; right and left alike, no neighbours alike
  static const std::array<Colour, face_region_count> colours{
      {{0.80, 0.80, 0.80}, // rest of the head
       {0.98, 0.86, 0.55}, // forehead
       {0.55, 0.75, 0.90},
       {0.55, 0.75, 0.90}, // orbits
       {0.93, 0.55, 0.45}, // nose
       {0.65, 0.85, 0.62},
       {0.65, 0.85, 0.62}, // cheeks
       {0.80, 0.62, 0.86}, // upper lip
       {0.45, 0.55, 0.85}, // lower lip
       {0.90, 0.70, 0.30}, // chin
       {0.93, 0.72, 0.80},
       {0.93, 0.72, 0.80},   // jaw
       {0.45, 0.72, 0.70}}}; // neck
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(colours.size()));
  table->SetTableRange(-0.5, static_cast<double>(colours.size()) - 0.5);
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    table->SetTableValue(static_cast<vtkIdType>(i), colours[i][0], colours[i][1], colours[i][2]);
  }
  return table;
}

vtkSmartPointer<vtkLookupTable> boundary_map()
{
  // in the order of Boundary's values
  static const std::array<Colour, 6> colours{{{0.80, 0.80, 0.80},   // not on it
                                              {0.92, 0.73, 0.63},   // skin
                                              {0.34, 0.71, 0.91},   // bone that stays
                                              {0.84, 0.37, 0.00},   // fragments
                                              {0.95, 0.90, 0.45},   // free
                                              {0.55, 0.55, 0.58}}}; // walls
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(colours.size()));
  table->SetTableRange(-0.5, static_cast<double>(colours.size()) - 0.5);
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    table->SetTableValue(static_cast<vtkIdType>(i), colours[i][0], colours[i][1], colours[i][2]);
  }
  return table;
}

Colour fragment_colour(std::size_t index)
{
  static const std::array<Colour, 7> colours{{{0.00, 0.45, 0.70},
                                              {0.84, 0.37, 0.00},
                                              {0.00, 0.62, 0.45},
                                              {0.80, 0.40, 0.65},
                                              {0.34, 0.71, 0.91},
                                              {0.90, 0.62, 0.00},
                                              {0.35, 0.30, 0.60}}};
  return colours[index % colours.size()];
}

Colour slice_fragment_colour(std::size_t index)
{
  Colour colour = fragment_colour(index);
  for (double& c : colour)
  {
    c = std::min(1.0, 0.35 + 0.75 * c);
  }
  return colour;
}

double nice_ceiling(double value)
{
  if (!(value > 0))
  {
    return 0;
  }
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0})
  {
    // The small allowance keeps 0.3 from becoming 0.4 by rounding.
    if (step * decade >= value * (1 - 1e-9))
    {
      return step * decade;
    }
  }
  return 10 * decade;
}

double nice_range(std::vector<double> values_mm, double share, double smallest_mm)
{
  values_mm.erase(std::remove_if(values_mm.begin(), values_mm.end(),
                                 [](double v) { return !std::isfinite(v); }),
                  values_mm.end());
  if (values_mm.empty())
  {
    return smallest_mm;
  }
  std::transform(values_mm.begin(), values_mm.end(), values_mm.begin(),
                 [](double v) { return std::abs(v); });
  const auto last = static_cast<double>(values_mm.size() - 1);
  const auto rank = values_mm.begin() + static_cast<std::ptrdiff_t>(std::ceil(share * last));
  std::nth_element(values_mm.begin(), rank, values_mm.end());
  return std::max(nice_ceiling(*rank), smallest_mm);
}

} // namespace f2b
