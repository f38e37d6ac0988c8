#pragma once

#include "Core/geometry/virtual_patient.hpp"
#include "Core/geometry/virtual_skull.hpp"

#include <functional>

/// Where are the anatomical landmarks on the surfaces of the virtual patient?
namespace f2b
{

/// Signed distances [mm, RAS] of the surfaces that carry landmarks.
struct LandmarkSurfaces
{
  std::function<double(const Vec3&)> bone, mandible, skin;
};

/// Every landmark is found by looking at the surface along a line, as on an X-ray tracing.
std::vector<NamedPoint> virtual_landmarks(const LandmarkSurfaces& surfaces,
                                          const MidfaceShift& midface);

} // namespace f2b
