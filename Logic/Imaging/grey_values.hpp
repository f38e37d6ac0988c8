#pragma once

#include "Imaging/ct_image.hpp"

#include <string>

/// Which Hounsfield units do the grey values of a cone-beam CT stand for?
namespace f2b
{

/// Shifts and scales the voxels so that the peak of air becomes -1000 and that of soft tissue 40 HU;
/// returns a sentence that says how.
///
/// Cone-beam scanners give grey values that are linear in attenuation only roughly, so bone stays
/// uncertain: a threshold or the level set is to be looked at.
/// \throws Error  no two peaks that could be air and soft tissue
std::string to_hounsfield(CtImage& ct, const std::string& name);

} // namespace f2b
