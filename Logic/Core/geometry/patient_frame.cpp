#include "Core/geometry/patient_frame.hpp"

#include "Core/geometry/patient_axes.hpp"

namespace f2b
{

Mat3 PatientFrame::from_scanner() const
{
  Mat3 rows;
  rows << right.transpose(), anterior.transpose(), superior.transpose();
  return rows;
}

std::vector<std::string> missing_for_patient_frame(const Landmarks& landmarks)
{
  std::vector<std::string> missing;
  for (const char* name : {"N", "Or_R", "Or_L", "Po_R", "Po_L"})
    if (landmarks.count(name) == 0)
      missing.push_back(name);
  return missing;
}

std::optional<PatientFrame> patient_frame(const Landmarks& landmarks)
{
  if (!missing_for_patient_frame(landmarks).empty())
    return std::nullopt;
  auto middle = [&](const std::string& pair) {
    return Vec3(0.5 * (landmark_at(landmarks, pair + "_R") + landmark_at(landmarks, pair + "_L")));
  };
  PatientFrame frame;
  frame.origin = landmark_at(landmarks, "N");
  frame.right = mid_sagittal_plane(landmarks).normal;
  const Vec3 forward = middle("Or") - middle("Po");
  const Vec3 level = forward - frame.right * frame.right.dot(forward);
  constexpr double shortest_mm = 10; // porion to orbitale is 70 to 90 mm in an adult
  if (!frame.right.allFinite() || !(level.norm() > shortest_mm))
    return std::nullopt;
  frame.anterior = level.normalized();
  frame.superior = frame.right.cross(frame.anterior);
  return frame;
}

} // namespace f2b
