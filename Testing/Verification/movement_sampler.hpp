#pragma once

#include "Core/geometry/osteotomy.hpp"
#include "Core/geometry/rigid_motion.hpp"

#include <cstdint>
#include <random>

/// Which random movements of one fragment does the movement study try?
namespace f2b::verification
{

/// Numbers that are the same with every compiler and library, other than those of std's
/// distributions.
class UniformNumbers
{
public:
  explicit UniformNumbers(std::uint64_t seed) : m_generator(seed) {}
  double between(double low, double high)
  {
    const double unit = static_cast<double>(m_generator() >> 11) * 0x1.0p-53; // 53 random bits
    return low + (high - low) * unit;
  }
  /// Uniform on the unit sphere (Archimedes: equal heights, equal areas).
  Vec3 direction();

private:
  std::mt19937_64 m_generator;
};

struct SampledMovement
{
  RigidMotion motion;
  double translation_mm = 0, rotation_deg = 0;
  double overlap_depth_mm = 0; ///< the deepest on the way
};

/// The bone that a movement may not run into.
struct UncutBone
{
  const ScalarGrid& distance; ///< of the actual bone, negative inside
  const LabelGrid& parts;     ///< BonePartition::labels
};

/// Draws movements: direction and axis uniform on the sphere, length uniform in [0, 22] mm, angle
/// uniform in [0, 15] degrees, about the fragment's reference point.
///
/// A movement runs into uncut bone, and is left out, if at a quarter, half, three quarters or all
/// of the way the fragment reaches more than `allowed_depth_mm` below the surface of the bone that
/// stays. The saw's kerf is not left out, unlike in a plan: the set of movements stays what it is
/// whatever a plan says of overlaps.
class MovementSampler
{
public:
  static constexpr double longest_mm = 22, widest_deg = 15, allowed_depth_mm = 2;

  MovementSampler(UncutBone bone, unsigned char fragment_label, const Vec3& reference_point,
                  std::uint64_t seed);

  SampledMovement next();
  int left_out() const { return m_left_out; }

private:
  double depth_below(const Vec3& p) const;
  double depth(const RigidMotion& motion) const;
  double depth_on_the_way(const Vec3& translation, const Vec3& rotation_vector) const;

  UncutBone m_bone;
  unsigned char m_label;
  std::vector<Vec3> m_cut_face;
  Vec3 m_reference;
  UniformNumbers m_numbers;
  int m_left_out = 0;
};

} // namespace f2b::verification
