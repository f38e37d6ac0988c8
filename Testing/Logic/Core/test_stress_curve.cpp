#include "Core/material/stress_curve.hpp"
#include "Logic/Core/material_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using namespace testing;

const VolumetricLaw no_matter{VolumetricLaw::Kind::Barrier, 1};

// Textbook forms, written for each law apart: R. W. Ogden, Non-linear Elastic Deformations, 1984;
// Yeoh's from his 1993 paper.
double textbook(const IsochoricNeoHookean& W, Loading loading, double s)
{
  return 2 * W.c10 *
         (loading == Loading::Uniaxial      ? s - 1 / (s * s)
          : loading == Loading::Equibiaxial ? s - std::pow(s, -5)
                                            : s);
}

double textbook(const IsochoricMooneyRivlin& W, Loading loading, double s)
{
  if (loading == Loading::Uniaxial)
    return 2 * (W.c10 + W.c01 / s) * (s - 1 / (s * s));
  if (loading == Loading::Equibiaxial)
    return 2 * (W.c10 + W.c01 * s * s) * (s - std::pow(s, -5));
  return 2 * (W.c10 + W.c01) * s;
}

double textbook(const IsochoricYeoh& W, Loading loading, double s)
{
  const double e = (loading == Loading::Uniaxial      ? s * s + 2 / s
                    : loading == Loading::Equibiaxial ? 2 * s * s + std::pow(s, -4)
                                                      : 3 + s * s) -
                   3;
  return textbook(IsochoricNeoHookean{W.c1 + 2 * W.c2 * e + 3 * W.c3 * e * e}, loading, s);
}

/// Calls `check(isochoric law, loading, deformation)` over tests and deformations.
template <class Check>
void for_every_curve(const Check& check)
{
  for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial, Loading::SimpleShear})
    for (const double strain : {-0.1, -0.03, 0.02, 0.04, 0.3})
    {
      const double s = rest_of(loading) + strain;
      check(IsochoricNeoHookean{0.03}, loading, s);
      check(IsochoricMooneyRivlin{0.02, 0.01}, loading, s);
      check(IsochoricYeoh{0.03, 0.02, 0.4}, loading, s);
      if (std::abs(strain) < 0.05) // inside Table 1's stable range
        check(IsochoricMooneyRivlin{skin_c10, skin_c01}, loading, s);
    }
}

TEST(StressCurve, IncompressibleFormsAreTheTextbooks)
{
  for_every_curve(
      [](const auto& W, Loading loading, double s)
      {
        const Law law = Hyperelastic<std::decay_t<decltype(W)>>{W, no_matter};
        const double expected = textbook(W, loading, s);
        EXPECT_NEAR(incompressible_response(law, loading, s).stress, expected,
                    1e-13 * std::abs(expected) + 1e-16);
      });
}

/// A law with the stiffness W and another Poisson's ratio.
template <class Isochoric>
Law with_poisson_ratio(const Isochoric& W, double nu)
{
  return Hyperelastic<Isochoric>{W,
                                 {VolumetricLaw::Kind::Barrier, bulk_from(W.shear_modulus(), nu)}};
}

TEST(StressCurve, CompressibleMatterTendsToTheClosedFormAsItsVolumeStiffens)
{
  double worst = 0;
  for_every_curve(
      [&](const auto& W, Loading loading, double s)
      {
        const double expected = textbook(W, loading, s);
        const double size = std::max(std::abs(expected), W.shear_modulus());
        auto error = [&](double nu)
        {
          const auto point = compressible_response(with_poisson_ratio(W, nu), loading, s);
          return point ? std::abs(point->stress - expected) / size : 1.0;
        };
        const double coarse = error(0.499), middle = error(0.4999), fine = error(0.49999);
        worst = std::max(worst, fine);
        if (loading == Loading::SimpleShear)
        {
          EXPECT_LT(coarse, 1e-13); // the volume does not change
          return;
        }
        EXPECT_LT(fine, 3e-3);
        EXPECT_NEAR(middle / fine, 10, 0.5); // in proportion to mu / K
        EXPECT_LT(middle, 0.2 * coarse);
      });
  std::printf("compressible curve at nu = 0.49999 against the closed form: %.1e at worst\n", worst);
}

TEST(StressCurve, FreeSidesOfTheLinearLawGiveYoungsModulus)
{
  const double mu = 0.05, nu = 0.3;
  const Law law = LinearElastic{mu, bulk_from(mu, nu)};
  const double E = 2 * mu * (1 + nu);
  EXPECT_NEAR(compressible_response(law, Loading::Uniaxial, 1.2)->stress, 0.2 * E, 1e-15);
  EXPECT_NEAR(compressible_response(law, Loading::Equibiaxial, 1.2)->stress, 0.2 * E / (1 - nu),
              1e-15);
  EXPECT_NEAR(compressible_response(law, Loading::SimpleShear, 0.2)->stress, 0.2 * mu, 1e-15);
  EXPECT_NEAR(incompressible_response(law, Loading::Uniaxial, 1.2).stress, 0.2 * 3 * mu, 1e-15);
  EXPECT_NEAR(incompressible_response(law, Loading::Equibiaxial, 1.2).stress, 0.2 * 6 * mu, 1e-15);
}

TEST(StressCurve, SlopesAreTheDerivativesOfTheStress)
{
  for (const NamedLaw& named : every_law(0.3))
    for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial, Loading::SimpleShear})
      for (const double strain : {-0.08, 0.03})
      {
        const double s = rest_of(loading) + strain, h = 1e-5;
        auto compressible = [&](double at)
        { return compressible_response(named.law, loading, at)->stress; };
        auto closed = [&](double at)
        { return incompressible_response(named.law, loading, at).stress; };
        EXPECT_NEAR(compressible_response(named.law, loading, s)->slope,
                    (compressible(s + h) - compressible(s - h)) / (2 * h), 1e-7)
            << named.name;
        EXPECT_NEAR(incompressible_response(named.law, loading, s).slope,
                    (closed(s + h) - closed(s - h)) / (2 * h), 1e-7)
            << named.name;
      }
}

} // namespace
} // namespace f2b
