#pragma once

#include "Core/material/hyperelastic.hpp"
#include "Core/material/linear_elastic.hpp"

#include <variant>

/// Which law does a tissue follow? Any of these; loops over points visit it once, outside.
namespace f2b
{

using Law = std::variant<LinearElastic, NeoHookean, MooneyRivlin, Yeoh>;

inline double shear_modulus(const LinearElastic& law)
{
  return law.shear_modulus;
}
inline double bulk_modulus(const LinearElastic& law)
{
  return law.bulk_modulus;
}

template <class Isochoric>
double shear_modulus(const Hyperelastic<Isochoric>& law)
{
  return law.isochoric.shear_modulus();
}
template <class Isochoric>
double bulk_modulus(const Hyperelastic<Isochoric>& law)
{
  return law.volumetric.bulk_modulus;
}

/// Small-strain shear modulus mu [MPa].
inline double shear_modulus(const Law& law)
{
  return std::visit([](const auto& l) { return shear_modulus(l); }, law);
}
/// Small-strain bulk modulus K [MPa].
inline double bulk_modulus(const Law& law)
{
  return std::visit([](const auto& l) { return bulk_modulus(l); }, law);
}
/// Bulk modulus of a shear modulus [MPa] and Poisson's ratio in (-1, 0.5).
inline double bulk_from(double shear_modulus, double poisson_ratio)
{
  return 2 * shear_modulus * (1 + poisson_ratio) / (3 * (1 - 2 * poisson_ratio));
}
inline double poisson_ratio(const Law& law)
{
  const double K = bulk_modulus(law), mu = shear_modulus(law);
  return (3 * K - 2 * mu) / (2 * (3 * K + mu));
}

} // namespace f2b
