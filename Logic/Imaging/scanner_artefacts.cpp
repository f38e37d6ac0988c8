#include "Imaging/scanner_artefacts.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

constexpr double metal_radius = 3.4;
constexpr double metal_hu = 3071;

/// Steele's and Vigna's splitmix64: a bijective scrambling of 64 bits.
std::uint64_t scrambled(std::uint64_t value)
{
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

double unit_random(std::uint64_t seed, std::uint64_t counter)
{
  return static_cast<double>(scrambled(scrambled(seed) ^ counter) >> 11) * 0x1p-53;
}

} // namespace

double standard_noise(std::uint64_t seed, std::uint64_t voxel)
{
  // The sum of twelve uniform numbers of 16 bits has variance 1: integers only, so equal
  // everywhere.
  const std::uint64_t start = scrambled(seed) ^ (3 * voxel);
  std::int64_t sum = 0;
  for (std::uint64_t word = 0; word < 3; ++word)
  {
    std::uint64_t bits = scrambled(start + word * 0xd1342543de82ef95ULL);
    for (int part = 0; part < 4; ++part, bits >>= 16)
      sum += static_cast<std::int64_t>(bits & 0xffff);
  }
  return static_cast<double>(sum - 6 * 65535) / 65536.0;
}

MetalStreaks::MetalStreaks(const VirtualPatient& patient, std::uint64_t seed) : m_seed(seed)
{
  const Vec3 upper = patient.landmark("U6_R");
  m_crowns[0] = upper + Vec3(0, 0, 3.5);
  m_crowns[1] = Vec3(-upper.x(), upper.y(), upper.z()) - Vec3(-2.5, 0, 7);
}

double MetalStreaks::rays(int crown, double angle) const
{
  double sum = 0;
  for (int wave = 0; wave < 6; ++wave)
  {
    const std::uint64_t id = 64 * crown + 2 * wave;
    const double frequency = 3 + wave * 4 + std::floor(3 * unit_random(m_seed, id));
    sum += std::sin(frequency * angle + 6.2831853 * unit_random(m_seed, id + 1));
  }
  return sum / 1.7;
}

double MetalStreaks::apply(const Vec3& point_ras, double hounsfield) const
{
  double metal = 0;
  for (int crown = 0; crown < 2; ++crown)
  {
    const Vec3 v = point_ras - m_crowns[crown];
    const double in_plane = std::hypot(v.x(), v.y());
    const double height = std::exp(-v.z() * v.z() / (2 * 2.2 * 2.2));
    const double slice = 0.6 + 0.8 * unit_random(m_seed, 1000 + std::lround(point_ras.z() + 500));
    if (height > 1e-3)
      hounsfield +=
          420 * slice * height * rays(crown, std::atan2(v.y(), v.x())) / (1 + in_plane / 45);
    metal = std::max(metal, std::clamp(metal_radius - v.norm() + 0.5, 0.0, 1.0));
  }
  return hounsfield + metal * (metal_hu - hounsfield);
}

double head_rest_hounsfield(const Vec3& point_ras, double air, double voxel_mm)
{
  // A trough around an axis along S; its pad reaches 1.5 mm into the back of the head.
  const double pad_inner = 104, pad_thickness = 11, plastic_thickness = 3;
  const double radius = std::hypot(point_ras.x(), point_ras.y() - 8.5);
  const double beyond = std::max({point_ras.y() + 55, point_ras.z() - 85, -point_ras.z() - 55});
  auto filled = [&](double inner, double thickness)
  {
    const double d = std::max(std::abs(radius - inner - 0.5 * thickness) - 0.5 * thickness, beyond);
    return std::clamp(0.5 - d / voxel_mm, 0.0, 1.0);
  };
  const double pad = filled(pad_inner, pad_thickness);
  const double plastic = filled(pad_inner + pad_thickness, plastic_thickness);
  return air + pad * (-90 - air) + plastic * (160 - air);
}

} // namespace f2b
