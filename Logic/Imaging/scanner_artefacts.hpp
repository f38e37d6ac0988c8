#pragma once

#include "Core/geometry/virtual_patient.hpp"

#include <cstdint>

/// What does a scanner add to the picture of the patient: noise, metal streaks and the head rest?
namespace f2b
{

/// Gaussian noise of unit variance and mean zero that depends on nothing but seed and voxel number.
double standard_noise(std::uint64_t seed, std::uint64_t voxel);

/// Streaks around two metal crowns (first molars: upper right, lower left).
class MetalStreaks
{
public:
  MetalStreaks(const VirtualPatient& patient, std::uint64_t seed);

  /// `hounsfield` of a point [mm, RAS] with metal and streaks in it.
  double apply(const Vec3& point_ras, double hounsfield) const;

private:
  double rays(int crown, double angle) const;

  Vec3 m_crowns[2];
  std::uint64_t m_seed;
};

/// HU of the head rest at a point [mm, RAS] with the air around it.
double head_rest_hounsfield(const Vec3& point_ras, double air, double voxel_mm);

} // namespace f2b
