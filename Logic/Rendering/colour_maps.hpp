#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

/// Which colour stands for which value? Colour-blind-safe maps and their ranges in mm.
namespace f2b
{

using Colour = std::array<double, 3>; ///< red, green, blue, each 0 to 1

/// What a map shows where there is no value.
constexpr Colour no_value_colour{0.62, 0.62, 0.62};

/// Blue - white - red from -range to +range: blue is behind, white is on the target.
vtkSmartPointer<vtkLookupTable> diverging_map(double range_mm);

/// Near-white to dark violet from 0 to range, darker for more.
vtkSmartPointer<vtkLookupTable> sequential_map(double range_mm);

/// One pale colour for each region of the face, by its value; neighbours differ.
vtkSmartPointer<vtkLookupTable> region_map();

/// One colour for each part of the mesh's boundary, by Core's Boundary.
vtkSmartPointer<vtkLookupTable> boundary_map();

/// Strong, distinct colours for bone fragments (Okabe and Ito); they repeat after seven.
Colour fragment_colour(std::size_t index);

/// The same order for outlines on a black slice: lighter.
Colour slice_fragment_colour(std::size_t index);

/// The next value of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten that is not below `value`.
double nice_ceiling(double value);

/// A symmetric or one-sided range [mm] that holds `share` of the absolute values, rounded up, at
/// least `smallest_mm`. Not-a-number values do not count.
double nice_range(std::vector<double> values_mm, double share, double smallest_mm);

} // namespace f2b
