#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Imaging/ct_image.hpp"

/// Which CT shows the head after it was carried elsewhere?
namespace f2b
{

/// The same voxels on a lattice that was moved with the head: nothing is interpolated. Voxels are
/// shared with `ct`, which stays as it is.
/// \param motion  of the head, RAS [mm]
CtImage::Pointer moved_ct(const CtImage& ct, const RigidMotion& motion);

} // namespace f2b
