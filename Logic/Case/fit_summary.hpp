#pragma once

#include "Case/fit_material.hpp"

namespace f2b
{

/// A fit as the terminal shows it: coefficients, residual, stable range.
std::string fit_summary(const FittedCurve& fit);

/// What a curve is: `uniaxial test, 61 points, stretch 1 to 1.3`.
std::string curve_description(const StressCurve& curve);

/// Where a law's nominal stress grows, in a test's words: `every stretch`, or `stretch 0.8957 and
/// above`.
std::string range_words(const DeformationRange& range, Loading loading);

} // namespace f2b
