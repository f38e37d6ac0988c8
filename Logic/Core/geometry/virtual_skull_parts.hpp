#pragma once

#include "Core/geometry/virtual_skull.hpp"

/// Which shapes is the skull of the virtual patient made of?
///
/// One function per anatomical part; the frame is that of virtual_skull.hpp [mm, RAS].
namespace f2b
{

Sculpture brain_case(); ///< solid: its outer surface, flat below
Sculpture facial_skeleton(const MidfaceShift& midface);
Sculpture skull_base(const MidfaceShift& midface);
/// What is cut out of vault, face and base: orbits, nasal cavity, ear canals, foramen magnum.
Sculpture skull_openings(const MidfaceShift& midface);
Sculpture nasal_septum(const MidfaceShift& midface);
Sculpture maxillary_sinuses(const MidfaceShift& midface);
Sculpture mandible_bone();
Sculpture cervical_spine();
Sculpture upper_teeth(const MidfaceShift& midface);
Sculpture lower_teeth();

} // namespace f2b
