#include "Core/geometry/rigid_motion.hpp"
#include "Logic/Core/material_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace f2b
{
namespace
{

using namespace testing;

/// df/dF(i), to fourth order in the step.
template <class Function>
auto difference(const Function& f, const Mat3& F, int i)
{
  const double h = 1e-3;
  auto at = [&](double step)
  {
    Mat3 moved = F;
    moved(i) += step;
    return f(moved);
  };
  const auto near = at(h), behind = at(-h), far = at(2 * h), far_behind = at(-2 * h);
  return decltype(near)((8 * (near - behind) - (far - far_behind)) / (12 * h));
}

/// Calls `check(law, F)` with the law's own type for samples of every law.
template <class Check>
void for_every_law(const Check& check)
{
  for (const NamedLaw& named : every_law())
  {
    SCOPED_TRACE(named.name);
    std::mt19937 generator(1);
    for (int sample = 0; sample < 40; ++sample)
    {
      const Mat3 F = random_deformation(generator);
      std::visit([&](const auto& law) { check(law, F); }, named.law);
    }
  }
}

TEST(Material, StressIsTheDerivativeOfTheEnergy)
{
  double worst = 0;
  for_every_law(
      [&](const auto& law, const Mat3& F)
      {
        Mat3 differences;
        for (int i = 0; i < 9; ++i)
          differences(i) = difference([&](const Mat3& G) { return law.energy(G); }, F, i);
        const Mat3 P = law.stress(F);
        worst = std::max(worst, (P - differences).norm() / P.norm());
        EXPECT_LT((P - differences).norm(), 1e-6 * P.norm());
      });
  std::printf("stress against differences of the energy: %.1e relative at worst\n", worst);
}

TEST(Material, TangentIsTheDerivativeOfTheStressAndSymmetric)
{
  double worst = 0;
  for_every_law(
      [&](const auto& law, const Mat3& F)
      {
        Mat9 tangent, differences;
        const Mat3 P = law.stress(F, tangent);
        EXPECT_LT((P - law.stress(F)).norm(), 1e-14 * tangent.norm());
        EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-13 * tangent.norm());
        for (int i = 0; i < 9; ++i)
          Eigen::Map<Mat3>(differences.col(i).data()) =
              difference([&](const Mat3& G) { return law.stress(G); }, F, i);
        worst = std::max(worst, (tangent - differences).norm() / tangent.norm());
        EXPECT_LT((tangent - differences).norm(), 1e-6 * tangent.norm());
      });
  std::printf("tangent against differences of the stress: %.1e relative at worst\n", worst);
}

TEST(Material, TheIsochoricPartIsWhatTheVolumetricLawLeaves)
{
  for_every_law(
      [](const auto& law, const Mat3& F)
      {
        if constexpr (!std::is_same_v<std::decay_t<decltype(law)>, LinearElastic>)
        {
          auto shape_only = law;
          shape_only.volumetric.bulk_modulus = 0;
          Mat9 tangent, expected;
          const Mat3 P = law.isochoric_stress(F, tangent);
          EXPECT_LT((P - shape_only.stress(F, expected)).norm(), 1e-15);
          EXPECT_LT((tangent - expected).norm(), 1e-15 + 1e-14 * expected.norm());
          EXPECT_LT((law.isochoric_stress(F) - P).norm(), 1e-14);
          EXPECT_NEAR(law.isochoric_energy(F), shape_only.energy(F), 1e-15);
          // a change of volume alone costs it nothing
          EXPECT_NEAR(law.isochoric_energy(1.3 * F), law.isochoric_energy(F), 1e-13);
        }
      });
}

TEST(Material, RestIsFreeOfStressAndEnergy)
{
  for (const NamedLaw& named : every_law())
    std::visit(
        [&](const auto& law)
        {
          EXPECT_LT(law.stress(Mat3::Identity()).norm(), 1e-14) << named.name;
          EXPECT_NEAR(law.energy(Mat3::Identity()), 0, 1e-15) << named.name;
        },
        named.law);
}

TEST(Material, RotatingTheBodyRotatesTheStressAndCostsNothing)
{
  const Mat3 R = rotation_from_vector({0.3, -1.1, 0.7});
  for_every_law(
      [&](const auto& law, const Mat3& F)
      {
        if constexpr (!std::is_same_v<std::decay_t<decltype(law)>, LinearElastic>)
        {
          EXPECT_NEAR(law.energy(R * F), law.energy(F), 1e-12);
          EXPECT_LT((law.stress(R * F) - R * law.stress(F)).norm(), 1e-12);
          // isotropy: turning the matter first
          EXPECT_LT((law.stress(F * R) - law.stress(F) * R).norm(), 1e-12);
        }
      });
}

TEST(Material, SmallStrainTangentIsLinearElasticity)
{
  for (const NamedLaw& named : every_law())
  {
    const double mu = shear_modulus(named.law), K = bulk_modulus(named.law);
    EXPECT_NEAR(mu, skin_mu, 1e-15);
    EXPECT_NEAR(poisson_ratio(named.law), 0.49, 1e-14);
    Mat9 tangent, linear;
    (void)LinearElastic{mu, K}.stress(Mat3::Identity(), linear);
    std::visit([&](const auto& law) { (void)law.stress(Mat3::Identity(), tangent); }, named.law);
    EXPECT_LT((tangent - linear).norm(), 1e-14 * linear.norm()) << named.name;
  }
}

TEST(Material, InvertedMatterHasInfiniteEnergyExceptInTheLinearLaw)
{
  for (const NamedLaw& named : every_law())
    for (const double thickness : {-0.1, 0.0})
    {
      Mat3 F = Mat3::Identity();
      F(2, 2) = thickness;
      const bool finite = std::holds_alternative<LinearElastic>(named.law);
      const double energy = std::visit([&](const auto& law) { return law.energy(F); }, named.law);
      EXPECT_EQ(std::isfinite(energy), finite) << named.name;
      EXPECT_FALSE(std::isnan(energy)) << named.name;
    }
}

} // namespace
} // namespace f2b
