#pragma once

#include "Core/geometry/vectors.hpp"

#include <cstdint>
#include <random>

/// How does a measured surface err? Seeded, so that a study can be repeated; mm, RAS.
namespace f2b
{

/// Numbers that are the same with every compiler and library, other than those of std's
/// distributions.
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed) : m_generator(seed) {}

  double between(double low, double high);
  double normal();  ///< mean 0, standard deviation 1
  Vec3 direction(); ///< uniform on the unit sphere

private:
  std::mt19937_64 m_generator;
};

/// Noise of points whose neighbours err alike.
struct NoiseOptions
{
  double sd_mm = 0.5;        ///< of each component
  double correlation_mm = 5; ///< l of exp(-r^2 / (2 l^2)); 0: no point knows of another
  std::uint64_t seed = 1;
};

/// A Gaussian error vector per point, its components independent.
///
/// With a correlation length it is a sum of 500 plane waves with random frequencies and phases,
/// whose covariance is exp(-r^2 / (2 l^2)) on average over seeds. Reference: M. Shinozuka,
/// J. Acoust. Soc. Am. 49 (1971) 357.
std::vector<Vec3> correlated_noise(const std::vector<Vec3>& points, const NoiseOptions& options);

} // namespace f2b
