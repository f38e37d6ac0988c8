#pragma once

#include "Imaging/ct_image.hpp"
#include "Imaging/lattice.hpp"

/// What are the Hounsfield units on a lattice of the RAS frame?
namespace f2b
{

/// Outside the CT there is air.
inline constexpr float air_hu = -1000.0F;

/// The smallest RAS box that holds the centres of all voxels [mm].
Box extent_ras(const CtImage& ct);

/// The RAS position of the CT's first voxel: lattices anchored there reproduce an axis-aligned CT.
Vec3 anchor_ras(const CtImage& ct);

/// Trilinear interpolation of a CT of any direction; `air_hu` beyond its outermost voxel centres.
ScalarGrid resample_ct(const CtImage& ct, const Lattice& lattice);

} // namespace f2b
