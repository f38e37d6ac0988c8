#pragma once

#include "Imaging/binary_mask.hpp"

/// Which part of a head do streaks from metal fillings spoil, and what is left without them?
///
/// Streaks lie in the plane of a slice and are thin across it; teeth, jaws, lips and cheeks are
/// not. The slices are taken to be axial, across S.
namespace f2b
{

/// The neighbourhood of metal (above 2000 HU), in the slices that hold a filling's worth of it.
BinaryMask streak_zone(const ScalarGrid& hu);

/// Takes away from a body what is thinner than `length` along S and farther than `stub` from what
/// is not [mm], in the zone. The result is a level function, no longer a distance.
void remove_streaks(ScalarGrid& distance, const BinaryMask& zone, double length, double stub);

/// Fills what of the outside is thinner than `length` along S but for a depth of `stub` [mm].
void fill_streaks(ScalarGrid& distance, const BinaryMask& zone, double length, double stub);

/// Gaussian smoothing of `distance` with `sigma` [mm] where, and near where, it differs from
/// `before`.
void smooth_near_changes(ScalarGrid& distance, const ScalarGrid& before, double sigma);

} // namespace f2b
