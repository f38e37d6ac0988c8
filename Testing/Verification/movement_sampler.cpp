#include "Verification/movement_sampler.hpp"

#include <algorithm>
#include <cmath>

namespace f2b::verification
{
namespace
{

constexpr double pi = 3.14159265358979323846;

RigidMotion motion_of(const Vec3& translation, const Vec3& rotation_vector, const Vec3& reference)
{
  return {rotation_from_vector(rotation_vector), translation, reference};
}

} // namespace

Vec3 UniformNumbers::direction()
{
  const double height = between(-1, 1), angle = between(0, 2 * pi);
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

double MovementSampler::depth_on_the_way(const Vec3& translation, const Vec3& rotation_vector) const
{
  double depth = 0;
  for (const double share : {1.0, 0.25, 0.5, 0.75}) // most that fail do so at the end
  {
    const RigidMotion motion = motion_of(share * translation, share * rotation_vector, m_reference);
    depth = std::max(
        depth, overlap_with_uncut_bone(m_bone.distance, m_bone.parts, m_label, motion).depth_mm);
    if (depth > allowed_depth_mm)
      break;
  }
  return depth;
}

SampledMovement MovementSampler::next()
{
  for (;; ++m_left_out)
  {
    SampledMovement sample;
    sample.translation_mm = m_numbers.between(0, longest_mm);
    sample.rotation_deg = m_numbers.between(0, widest_deg);
    const Vec3 translation = sample.translation_mm * m_numbers.direction();
    const Vec3 rotation = sample.rotation_deg * pi / 180 * m_numbers.direction();
    sample.overlap_depth_mm = depth_on_the_way(translation, rotation);
    sample.motion = motion_of(translation, rotation, m_reference);
    if (sample.overlap_depth_mm <= allowed_depth_mm)
      return sample;
  }
}

} // namespace f2b::verification
