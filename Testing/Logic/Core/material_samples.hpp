#pragma once

#include "Core/material/law.hpp"

#include <random>
#include <string>
#include <vector>

/// Laws and deformations that every material test goes through.
namespace f2b::testing
{

struct NamedLaw
{
  std::string name;
  Law law;
};

/// Table 1's skin (paper, converted from gf/mm^2), and laws of its stiffness of the other kinds.
inline constexpr double skin_c10 = 18.9834 * 9.80665e-3, skin_c01 = -15.4072 * 9.80665e-3;
inline constexpr double skin_mu = 2 * (skin_c10 + skin_c01);

/// Every isochoric law with every volumetric law, and the linear one.
inline std::vector<NamedLaw> every_law(double poisson_ratio = 0.49)
{
  const double K = bulk_from(skin_mu, poisson_ratio);
  std::vector<NamedLaw> laws = {{"linear", LinearElastic{skin_mu, K}}};
  for (const auto& [kind, name] : {std::pair{VolumetricLaw::Kind::Quadratic, "quadratic"},
                                   {VolumetricLaw::Kind::Logarithmic, "log"},
                                   {VolumetricLaw::Kind::Barrier, "barrier"}})
  {
    const VolumetricLaw U{kind, K};
    const std::string with = std::string(" with ") + name;
    laws.push_back({"neo-Hookean" + with, NeoHookean{{skin_mu / 2}, U}});
    laws.push_back({"Mooney-Rivlin" + with, MooneyRivlin{{skin_c10, skin_c01}, U}});
    laws.push_back({"Yeoh" + with, Yeoh{{skin_mu / 2, 0.02, 0.4}, U}});
  }
  return laws;
}

/// The identity and something of up to `size` in every entry.
inline Mat3 random_deformation(std::mt19937& generator, double size = 0.25)
{
  std::uniform_real_distribution<double> entry(-size, size);
  return Mat3::Identity() + Mat3::NullaryExpr([&] { return entry(generator); });
}

} // namespace f2b::testing
