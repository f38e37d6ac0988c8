#pragma once

#include "Imaging/head_mask.hpp"

/// Which box of the head does a plan for the face need?
namespace f2b
{

/// The face: from 10 mm below the chin to 60 mm below the vertex, from the nose back to the middle
/// of the cranium's depth (about the ear canals), in full width [mm, RAS].
Box face_region(const HeadMask& head);

} // namespace f2b
