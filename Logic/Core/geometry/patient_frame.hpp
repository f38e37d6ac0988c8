#pragma once

#include "Core/geometry/bite.hpp"

#include <optional>

/// Which axes does a clinician measure this patient by?
///
/// Frankfort horizontal: through porion (Po) and orbitale (Or), here the plane through the middles
/// of the two pairs that is level with the patient's right. Mid-sagittal: as in bite.hpp, through N,
/// from pairs of the upper face. (Proffit et al., Contemporary Orthodontics, ch. 6.)
namespace f2b
{

/// Right-handed and orthonormal; vectors in RAS of the scanner.
struct PatientFrame
{
  Vec3 origin = Vec3::Zero(); ///< N [mm]
  Vec3 right = Vec3::UnitX(), anterior = Vec3::UnitY(), superior = Vec3::UnitZ();
  bool guessed = false; ///< some of its landmarks were not placed by a person

  /// Rows right, anterior, superior: takes a scanner's vector into the patient's axes.
  Mat3 from_scanner() const;
  Vec3 point(const Vec3& point_ras) const { return from_scanner() * (point_ras - origin); }
};

/// Landmarks that the frame needs and that are not there: N, Or_R, Or_L, Po_R, Po_L.
std::vector<std::string> missing_for_patient_frame(const Landmarks& landmarks);

/// Nothing where one of them is missing, or where they lie on one line: then reports use the
/// scanner's axes and say so.
std::optional<PatientFrame> patient_frame(const Landmarks& landmarks);

} // namespace f2b
