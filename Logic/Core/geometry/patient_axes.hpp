#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

/// Which way is the patient's right, front and top?
namespace f2b
{

/// Orthonormal, in RAS: right from Or_L to Or_R, forward along the palate (PNS to ANS), as the
/// osteotomy templates use them.
struct PatientAxes
{
  Vec3 right, forward, up;
};

/// Throws Error naming the landmark that is not there (Or_R, Or_L, ANS, PNS).
PatientAxes patient_axes(const Landmarks& landmarks);

/// A landmark's position; throws Error naming it if it is not there.
const Vec3& landmark_at(const Landmarks& landmarks, const std::string& name);

} // namespace f2b
