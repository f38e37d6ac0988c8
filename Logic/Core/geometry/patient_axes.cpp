#include "Core/geometry/patient_axes.hpp"

#include "Core/error.hpp"

namespace f2b
{

const Vec3& landmark_at(const Landmarks& landmarks, const std::string& name)
{
  const auto found = landmarks.find(name);
  if (found == landmarks.end())
    throw Error("landmark '" + name + "'", "it is not there", "add it to the case's landmark file");
  return found->second;
}

PatientAxes patient_axes(const Landmarks& landmarks)
{
  PatientAxes axes;
  axes.right = (landmark_at(landmarks, "Or_R") - landmark_at(landmarks, "Or_L")).normalized();
  const Vec3 palate = landmark_at(landmarks, "ANS") - landmark_at(landmarks, "PNS");
  axes.forward = (palate - axes.right * axes.right.dot(palate)).normalized();
  axes.up = axes.right.cross(axes.forward);
  return axes;
}

} // namespace f2b
