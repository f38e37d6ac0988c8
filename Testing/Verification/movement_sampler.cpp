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

/// Samples of the fragment with a neighbour in the bone that stays.
std::vector<Vec3> cut_face(const LabelGrid& labels, unsigned char fragment)
{
  std::vector<Vec3> points;
  const Eigen::Vector3i n = labels.size;
  for (int k = 1; k + 1 < n.z(); ++k)
    for (int j = 1; j + 1 < n.y(); ++j)
      for (int i = 1; i + 1 < n.x(); ++i)
      {
        if (labels.values[labels.index(i, j, k)] != fragment)
          continue;
        auto stays = [&](int di, int dj, int dk)
        { return labels.values[labels.index(i + di, j + dj, k + dk)] == BonePartition::uncut; };
        if (stays(1, 0, 0) || stays(-1, 0, 0) || stays(0, 1, 0) || stays(0, -1, 0) ||
            stays(0, 0, 1) || stays(0, 0, -1))
          points.push_back(labels.position(i, j, k));
      }
  return points;
}

} // namespace

MovementSampler::MovementSampler(UncutBone bone, unsigned char fragment_label,
                                 const Vec3& reference_point, std::uint64_t seed)
    : m_bone(bone), m_label(fragment_label), m_cut_face(cut_face(bone.parts, fragment_label)),
      m_reference(reference_point), m_numbers(seed)
{
}

/// Of a place in the bone that stays, below its surface or the cut.
double MovementSampler::depth_below(const Vec3& p) const
{
  const double below_surface = -m_bone.distance.value(p);
  if (below_surface <= 0)
    return 0;
  double squared = below_surface * below_surface;
  for (const Vec3& point : m_cut_face)
    squared = std::min(squared, (point - p).squaredNorm());
  return std::sqrt(squared);
}

double MovementSampler::depth(const RigidMotion& motion) const
{
  double deepest = 0;
  std::size_t voxel = 0;
  const ScalarGrid& bone = m_bone.distance;
  for (int k = 0; k < bone.size.z(); ++k)
    for (int j = 0; j < bone.size.y(); ++j)
      for (int i = 0; i < bone.size.x(); ++i, ++voxel)
      {
        if (m_bone.parts.values[voxel] != m_label || bone.values[voxel] >= 0)
          continue;
        const Vec3 p = motion.apply(bone.position(i, j, k));
        if (m_bone.parts.nearest(p) == BonePartition::uncut)
          deepest = std::max(deepest, depth_below(p));
      }
  return deepest;
}

Vec3 UniformNumbers::direction()
{
  const double height = between(-1, 1), angle = between(0, 2 * pi);
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

double MovementSampler::depth_on_the_way(const Vec3& translation, const Vec3& rotation_vector) const
{
  double deepest = 0;
  for (const double share : {1.0, 0.25, 0.5, 0.75}) // most that fail do so at the end
  {
    const RigidMotion motion = motion_of(share * translation, share * rotation_vector, m_reference);
    deepest = std::max(deepest, depth(motion));
    if (deepest > allowed_depth_mm)
      break;
  }
  return deepest;
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
