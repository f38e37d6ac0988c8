#include "Core/geometry/bite.hpp"

#include "Core/geometry/patient_axes.hpp"

namespace f2b
{
namespace
{

Vec3 direction(const Landmarks& landmarks, const std::string& pair)
{
  return (landmark_at(landmarks, pair + "_R") - landmark_at(landmarks, pair + "_L")).normalized();
}

/// Unit normal of the occlusal plane, upwards.
Vec3 occlusal_normal(const Landmarks& landmarks)
{
  const Vec3& right = landmark_at(landmarks, "U6_R");
  const Vec3& left = landmark_at(landmarks, "U6_L");
  const Vec3 forward = landmark_at(landmarks, "U1") - 0.5 * (right + left);
  return (right - left).cross(forward).normalized();
}

} // namespace

const std::vector<std::string>& tooth_landmarks()
{
  static const std::vector<std::string> names = {"U1", "U6_R", "U6_L", "L1"};
  return names;
}

std::vector<std::string> missing_for_bite(const Landmarks& landmarks)
{
  std::vector<std::string> missing;
  for (const char* name : {"U1", "U6_R", "U6_L", "L1", "N", "Or_R", "Or_L"})
    if (landmarks.count(name) == 0)
      missing.push_back(name);
  return missing;
}

MidSagittalPlane mid_sagittal_plane(const Landmarks& rest)
{
  Vec3 right = direction(rest, "Or");
  if (rest.count("Zy_R") && rest.count("Zy_L"))
    right += direction(rest, "Zy");
  return {landmark_at(rest, "N"), right.normalized()};
}

Bite bite(const Landmarks& landmarks, const MidSagittalPlane& mid_sagittal)
{
  const Vec3& upper = landmark_at(landmarks, "U1");
  const Vec3& lower = landmark_at(landmarks, "L1");
  const Vec3 up = occlusal_normal(landmarks);
  const Vec3 forward = up.cross(mid_sagittal.normal).normalized();
  const Vec3 right = forward.cross(up);
  Bite result;
  result.overjet_mm = (upper - lower).dot(forward);
  result.overbite_mm = (lower - upper).dot(up);
  result.dental_midline_mm = (lower - upper).dot(right);
  result.upper_midline_mm = (upper - mid_sagittal.point).dot(mid_sagittal.normal);
  result.lower_midline_mm = (lower - mid_sagittal.point).dot(mid_sagittal.normal);
  return result;
}

Vec3 bone_of_tooth(const Landmarks& landmarks, const std::string& tooth)
{
  constexpr double rootwards_mm = 10;
  const Vec3& tip = landmark_at(landmarks, tooth);
  const bool lower = tooth == "L1";
  const std::string apex = tooth == "U1" ? "A" : lower ? "B" : "";
  const Vec3 along = landmarks.count(apex) ? Vec3(landmark_at(landmarks, apex) - tip).normalized()
                                           : (lower ? -1.0 : 1.0) * occlusal_normal(landmarks);
  return tip + rootwards_mm * along;
}

} // namespace f2b
