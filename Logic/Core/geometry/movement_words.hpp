#pragma once

#include <Core/geometry/vectors.hpp>

#include <string>
#include <vector>

/// How does a clinician say the movement of a bone fragment? Rows as in the paper's Table 2.
///
/// Frame RAS; translations in mm, rotations in degrees, right-handed about +R, +A, +S.
///
/// The words follow the geometry alone. A rotation that is right-handed about an axis looks
/// counter-clockwise to a viewer whom the axis points at, so a positive angle always reads
/// "Counter-clockwise" from these three places:
///   coronal  = roll  about +A, seen from in front of the patient
///   sagittal = pitch about +R, seen from the patient's right
///   axial    = yaw   about +S, seen from above the patient
/// The paper prints its case (2.5 and 5 degrees) as "Clockwise" and does not say where the viewer
/// stands; with these places that is roll = -2.5, pitch = -5.
namespace f2b
{

/// Rotation angles of R = Rz(yaw) Ry(roll) Rx(pitch) [deg].
struct RotationDegrees
{
  double pitch = 0; ///< about +R
  double roll = 0;  ///< about +A
  double yaw = 0;   ///< about +S
};

enum class MovementUnit
{
  Millimetre,
  Degree,
};

/// One row of Table 2: so much, in that direction, with respect to that plane.
struct MovementRow
{
  std::string axis;  ///< "Coronal", "Axial", "Sagittal", with "/center" for a rotation
  double amount = 0; ///< never negative, in `unit`
  MovementUnit unit = MovementUnit::Millimetre;
  std::string direction; ///< "Forward", ..., "Clockwise"; "None" below 0.005, printed as 0.00
};

/// The amount as it is printed: "11.00 mm", or "2.50°" in UTF-8.
std::string amount_text(const MovementRow& row);

/// The six rows of a movement, in the order of the paper's Table 2, yaw (not in the paper) last.
std::vector<MovementRow> describe_movement(const Vec3& translation_ras_mm,
                                           const RotationDegrees& rotation_deg);

/// The translation in one phrase: "11.0 mm forward, 5.0 mm down, 2.0 mm right"; "no translation"
/// when every part is below 0.05 mm.
std::string translation_phrase(const Vec3& translation_ras_mm);

/// The rotation in one phrase: "2.5 degrees clockwise (coronal), 5.0 degrees counter-clockwise
/// (sagittal)"; "no rotation" when every angle is below 0.05 degrees.
std::string rotation_phrase(const RotationDegrees& rotation_deg);

} // namespace f2b
