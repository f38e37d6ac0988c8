#pragma once

#include "Core/geometry/virtual_face.hpp"

/// Which shapes are the soft tissues of the virtual patient made of?
namespace f2b
{

Loft facial_mask(const MidfaceShift& midface); ///< forehead to jaw without eyes, nose and lips
Sculpture head_and_neck();
/// Brow, eyes, nose, lips, cheeks and chin, to be worked into the head.
Sculpture facial_features(const MidfaceShift& midface);
Sculpture ear();
Sculpture upper_airway(const MidfaceShift& midface);
Sculpture soft_muscles(const MidfaceShift& midface);

} // namespace f2b
