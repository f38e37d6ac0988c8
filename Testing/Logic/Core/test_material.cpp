#include "Core/geometry/rigid_motion.hpp"
#include "Core/material/yeoh.hpp"

#include <gtest/gtest.h>

#include <random>

namespace f2b
{
namespace
{

const Yeoh law{0.035, 0.012, 0.4, Yeoh::bulk_from(0.07, 0.49)};

Mat3 random_deformation(std::mt19937& generator)
{
  std::uniform_real_distribution<double> entry(-0.25, 0.25);
  return Mat3::Identity() + Mat3::NullaryExpr([&] { return entry(generator); });
}

TEST(Yeoh, StressIsTheDerivativeOfTheEnergy)
{
  std::mt19937 generator(1);
  for (int sample = 0; sample < 50; ++sample)
  {
    const Mat3 F = random_deformation(generator);
    const Mat3 P = law.stress(F);
    for (int i = 0; i < 9; ++i)
    {
      const double h = 1e-6;
      Mat3 plus = F, minus = F;
      plus(i) += h;
      minus(i) -= h;
      const double difference = (law.energy(plus) - law.energy(minus)) / (2 * h);
      EXPECT_NEAR(P(i), difference, 1e-6 * std::max(1.0, P.norm()));
    }
  }
}

TEST(Yeoh, TangentIsTheDerivativeOfTheStressAndSymmetric)
{
  std::mt19937 generator(2);
  for (int sample = 0; sample < 50; ++sample)
  {
    const Mat3 F = random_deformation(generator);
    Mat9 tangent;
    const Mat3 P = law.stress(F, tangent);
    EXPECT_LT((P - law.stress(F)).norm(), 1e-14 * (1 + P.norm()));
    EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-12 * tangent.norm());
    for (int i = 0; i < 9; ++i)
    {
      const double h = 1e-6;
      Mat3 plus = F, minus = F;
      plus(i) += h;
      minus(i) -= h;
      const Mat3 difference = (law.stress(plus) - law.stress(minus)) / (2 * h);
      EXPECT_LT((Eigen::Map<const Mat3>(tangent.col(i).data()) - difference).norm(),
                1e-6 * tangent.norm());
    }
  }
}

TEST(Yeoh, RestIsFreeOfStressAndRotationCostsNothing)
{
  EXPECT_LT(law.stress(Mat3::Identity()).norm(), 1e-15);
  const Mat3 R = rotation_from_vector({0.3, -1.1, 0.7});
  std::mt19937 generator(3);
  const Mat3 F = random_deformation(generator);
  EXPECT_NEAR(law.energy(R * F), law.energy(F), 1e-12);
  EXPECT_LT((law.stress(R * F) - R * law.stress(F)).norm(), 1e-12);
}

TEST(Yeoh, SmallStrainTangentIsLinearElasticity)
{
  Mat9 tangent;
  (void)law.stress(Mat3::Identity(), tangent);
  const double mu = law.shear_modulus(), lambda = law.bulk_modulus - 2 * mu / 3;
  EXPECT_NEAR(tangent(0, 0), lambda + 2 * mu, 1e-12);
  EXPECT_NEAR(tangent(0, 4), lambda, 1e-12);
  EXPECT_NEAR(tangent(1, 1), mu, 1e-12);
  EXPECT_NEAR(tangent(1, 3), mu, 1e-12);
}

TEST(Yeoh, InvertedMatterHasInfiniteEnergy)
{
  Mat3 F = Mat3::Identity();
  F(2, 2) = -0.1;
  EXPECT_TRUE(std::isinf(law.energy(F)));
  F(2, 2) = 0;
  EXPECT_TRUE(std::isinf(law.energy(F)));
}

} // namespace
} // namespace f2b
