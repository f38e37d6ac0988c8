#include "Core/geometry/noise_field.hpp"

#include <cmath>

namespace f2b
{
namespace
{

constexpr double pi = 3.14159265358979323846;

/// sqrt(2) cos(frequency . x + phase): mean square 1 over phases.
struct Wave
{
  Vec3 frequency; ///< [1/mm]
  Vec3 phase;     ///< of each component of the error
};

std::vector<Wave> random_waves(double correlation_mm, RandomNumbers& random)
{
  constexpr int count = 500;
  std::vector<Wave> waves(count);
  for (Wave& wave : waves)
  {
    for (int i = 0; i < 3; ++i)
      wave.frequency[i] = random.normal() / correlation_mm;
    for (int i = 0; i < 3; ++i)
      wave.phase[i] = random.between(0, 2 * pi);
  }
  return waves;
}

} // namespace

double RandomNumbers::between(double low, double high)
{
  const double unit = static_cast<double>(m_generator() >> 11) * 0x1.0p-53; // 53 random bits
  return low + (high - low) * unit;
}

double RandomNumbers::normal()
{
  // Box and Muller; 1 - u is never zero
  const double radius = std::sqrt(-2 * std::log(1 - between(0, 1)));
  return radius * std::cos(between(0, 2 * pi));
}

Vec3 RandomNumbers::direction()
{
  // equal heights, equal areas (Archimedes)
  const double z = between(-1, 1), angle = between(0, 2 * pi), r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

std::vector<Vec3> correlated_noise(const std::vector<Vec3>& points, const NoiseOptions& options)
{
  RandomNumbers random(options.seed);
  std::vector<Vec3> noise(points.size(), Vec3::Zero());
  if (!(options.correlation_mm > 0))
  {
    for (Vec3& n : noise)
      for (int i = 0; i < 3; ++i)
        n[i] = options.sd_mm * random.normal();
    return noise;
  }
  const std::vector<Wave> waves = random_waves(options.correlation_mm, random);
  const double amplitude = options.sd_mm * std::sqrt(2.0 / static_cast<double>(waves.size()));
#pragma omp parallel for schedule(static)
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (const Wave& wave : waves)
      noise[p] += (wave.frequency.dot(points[p]) + wave.phase.array()).cos().matrix();
    noise[p] *= amplitude;
  }
  return noise;
}

} // namespace f2b
