#pragma once

#include "Core/geometry/scalar_grid.hpp"

/// How far is each sample from the surface at which a sampled function changes sign?
namespace f2b
{

/// Signed distance [mm], negative where `level_function` is, to the zero level of its trilinear
/// interpolant.
///
/// Within `accurate_band_mm` of the surface the closest point is found on the interpolant itself,
/// so that the distance is good to a few hundredths of the spacing; farther away it is the distance
/// to the nearest crossing of a grid edge. Without any change of sign all distances are +-1e4.
ScalarGrid signed_distance(const ScalarGrid& level_function, double accurate_band_mm = 6.0);

} // namespace f2b
