#include "Core/material/stability.hpp"
#include "Logic/Core/material_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

using namespace testing;

/// A row of the paper's Table 1 and the stretches at which design.md says that stability is lost.
struct Table1Row
{
  const char* tissue;
  double c10_gf, c01_gf; ///< [gf/mm^2]
  double mu_kpa, lowest_uniaxial, highest_equibiaxial;

  IsochoricMooneyRivlin law() const { return {c10_gf * 9.80665e-3, c01_gf * 9.80665e-3}; }
  Law with(VolumetricLaw::Kind kind, double nu) const
  {
    return MooneyRivlin{law(), {kind, bulk_from(law().shear_modulus(), nu)}};
  }
};

const Table1Row table1[] = {{"skin", 18.9834, -15.4072, 70.14, 0.8957, 1.0523},
                            {"muscle", 9.8454, -7.7433, 41.23, 0.8800, 1.0603},
                            {"fat", 16.6131, -16.0127, 11.78, 0.9816, 1.0092}};

TEST(Stability, Table1LosesItAtTheStretchesOfTheDesign)
{
  std::printf("        mu [kPa]  uniaxial below  equibiaxial above\n");
  for (const Table1Row& row : table1)
  {
    const Law law = row.with(VolumetricLaw::Kind::Barrier, 0.49);
    const DeformationRange one =
        growing_range(law, Loading::Uniaxial, Compressibility::Incompressible);
    const DeformationRange two =
        growing_range(law, Loading::Equibiaxial, Compressibility::Incompressible);
    std::printf("%-8s  %6.2f      %.4f          %.4f\n", row.tissue, 1000 * shear_modulus(law),
                one.lowest, two.highest);
    EXPECT_NEAR(1000 * shear_modulus(law), row.mu_kpa, 0.005);
    EXPECT_NEAR(one.lowest, row.lowest_uniaxial, 1e-3 * row.lowest_uniaxial);
    EXPECT_NEAR(two.highest, row.highest_equibiaxial, 1e-3 * row.highest_equibiaxial);
    EXPECT_TRUE(std::isinf(one.highest));
  }
}

TEST(Stability, MusclesOwnCompressibilityMovesTheLimits)
{
  for (const auto& [kind, name] : {std::pair{VolumetricLaw::Kind::Quadratic, "quadratic"},
                                   {VolumetricLaw::Kind::Logarithmic, "log"},
                                   {VolumetricLaw::Kind::Barrier, "barrier"}})
  {
    const Law muscle = table1[1].with(kind, 0.30);
    const double lowest =
        growing_range(muscle, Loading::Uniaxial, Compressibility::OfTheLaw).lowest;
    const double highest =
        growing_range(muscle, Loading::Equibiaxial, Compressibility::OfTheLaw).highest;
    std::printf("muscle at nu = 0.30, %-9s  %.4f  %.4f\n", name, lowest, highest);
    // design.md's pair is the quadratic law's; the others lie within 0.2 % of it
    const double tolerance = kind == VolumetricLaw::Kind::Quadratic ? 5e-5 : 2e-3;
    EXPECT_NEAR(lowest, 0.8716, tolerance);
    EXPECT_NEAR(highest, 1.0786, tolerance);
  }
}

/// The margin from second differences of the energy over all isochoric directions.
double margin_by_differences(const MooneyRivlin& law, const Vec3& stretches)
{
  const double h = 1e-4;
  double smallest = 1e9;
  for (int direction = 0; direction < 720; ++direction)
  {
    const double angle = direction * M_PI / 720;
    const Vec3 e = std::cos(angle) * Vec3(1, -1, 0) / std::sqrt(2.0) +
                   std::sin(angle) * Vec3(1, 1, -2) / std::sqrt(6.0);
    auto energy = [&](double step)
    {
      const Vec3 moved = stretches.cwiseProduct(Vec3::Ones() + step * e);
      return law.isochoric_energy(moved.asDiagonal().toDenseMatrix());
    };
    const double second = (energy(h) - 2 * energy(0) + energy(-h)) / (h * h);
    smallest = std::min(smallest, second / (2 * shear_modulus(law)));
  }
  return smallest;
}

TEST(Stability, MarginIsTheSmallestSecondDifferenceOfTheEnergy)
{
  const MooneyRivlin law =
      std::get<MooneyRivlin>(table1[0].with(VolumetricLaw::Kind::Barrier, 0.49));
  for (const Vec3& stretches : {Vec3(1, 1, 1), Vec3(1.1, 0.9, 1.05), Vec3(0.88, 1.07, 1.07),
                                Vec3(1.3, 1.2, 0.9), Vec3(0.7, 0.7, 0.7)})
    EXPECT_NEAR(stability_margin(law, stretches.asDiagonal().toDenseMatrix()),
                margin_by_differences(law, stretches), 2e-4);
}

TEST(Stability, MarginIsOneAtRestAndTheSameInEveryFrame)
{
  std::mt19937 generator(5);
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const NamedLaw& named : every_law())
  {
    EXPECT_NEAR(stability_margin(named.law, R), 1, 1e-13) << named.name;
    const Mat3 F = random_deformation(generator, 0.1);
    EXPECT_NEAR(stability_margin(named.law, R * F), stability_margin(named.law, F), 1e-12);
    EXPECT_NEAR(stability_margin(named.law, F * R), stability_margin(named.law, F), 1e-12);
    EXPECT_NEAR(stability_margin(named.law, 1.2 * F), stability_margin(named.law, F), 1e-12);
  }
}

TEST(Stability, GuardSwitchesBetweenTheTwoTestsOfTheSameDeformation)
{
  // Equibiaxial tension and uniaxial compression are one deformation under two pressures; the
  // guard, which leaves the pressure to the surroundings, gives way between their limits.
  for (const Table1Row& row : table1)
  {
    const Law law = row.with(VolumetricLaw::Kind::Barrier, 0.49);
    const DeformationRange one = guarded_range(law, Loading::Uniaxial);
    const DeformationRange two = guarded_range(law, Loading::Equibiaxial);
    std::printf("%-8s guard: uniaxial %.4f to %.4f, equibiaxial to %.4f\n", row.tissue, one.lowest,
                one.highest, two.highest);
    EXPECT_NEAR(one.lowest, 1 / (two.highest * two.highest), 1e-9);
    EXPECT_GT(one.lowest, row.lowest_uniaxial - 5e-5);
    EXPECT_GT(two.highest, row.highest_equibiaxial - 5e-5);
    EXPECT_NEAR(one.lowest, row.lowest_uniaxial, 4e-3);
    EXPECT_NEAR(two.highest, row.highest_equibiaxial, 4e-3);
    // pulled along one direction, Table 1 gives way sideways inside the fitted range of 1.0 to 1.3
    EXPECT_LT(one.highest, 1.15);
  }
}

TEST(Stability, LawsWithPositiveCoefficientsHoldEverywhere)
{
  const Law yeoh = Yeoh{{0.048, 0.052, 0.01}, {VolumetricLaw::Kind::Barrier, 2}};
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> log_stretch(-1.5, 1.5);
  for (int sample = 0; sample < 2000; ++sample)
  {
    const Vec3 stretches = Vec3::NullaryExpr([&] { return std::exp(log_stretch(generator)); });
    EXPECT_GT(stability_margin(yeoh, stretches.asDiagonal().toDenseMatrix()), 0.5);
  }
  for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial, Loading::SimpleShear})
  {
    EXPECT_TRUE(growing_range(yeoh, loading, Compressibility::Incompressible).is_everywhere());
    EXPECT_TRUE(guarded_range(yeoh, loading).is_everywhere());
  }
}

MaterialSet literal_table1()
{
  const VolumetricLaw::Kind kind = VolumetricLaw::Kind::Barrier;
  return {"table1",
          {table1[0].with(kind, 0.49), table1[2].with(kind, 0.49), table1[1].with(kind, 0.30)}};
}

TEST(StabilityReport, CountsByTissueAndNamesTheWorstPlace)
{
  const MaterialSet materials = literal_table1();
  StabilityReport report(materials);
  const auto stretched = [](double s) -> Mat3
  { return Vec3(s, s, 1 / (s * s)).asDiagonal().toDenseMatrix(); };
  report.add({Tissue::Skin, stretched(1.01), {1, 2, 3}, 4});
  report.add({Tissue::Fat, stretched(1.00), {0, 0, 0}, 6});
  report.add({Tissue::Fat, stretched(1.02), {10, 20, 30}, 1});
  report.add({Tissue::Fat, stretched(1.05), {-11.04, 21, 31}, 1});
  report.add({Tissue::Fat, stretched(1.03), {12, 22, 32}, 2});
  EXPECT_FALSE(report.all_inside());
  const TissueStability& fat = report.of(Tissue::Fat);
  EXPECT_EQ(fat.points, 4);
  EXPECT_EQ(fat.points_outside, 3);
  EXPECT_DOUBLE_EQ(fat.share_outside(), 0.4);
  EXPECT_EQ(fat.worst_place, Vec3(-11.04, 21, 31));
  EXPECT_NEAR(fat.worst_margin, stability_margin(materials.of(Tissue::Fat), stretched(1.05)),
              1e-15);
  EXPECT_EQ(report.of(Tissue::Skin).points_outside, 0);
  const auto warnings = report.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  for (const char* part : {"fat", "40 %", "3 of 4 points", "R -11.0 A 21.0 S 31.0 mm"})
    EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
}

TEST(StabilityReport, InvertedMatterIsOutsideAndRestIsNot)
{
  const MaterialSet materials = literal_table1();
  StabilityReport report(materials);
  report.add({Tissue::Muscle, Mat3::Identity(), {0, 0, 0}, 1});
  EXPECT_TRUE(report.all_inside());
  EXPECT_TRUE(report.warnings().empty());
  report.add({Tissue::Muscle, Vec3(1, 1, -1).asDiagonal().toDenseMatrix(), {5, 5, 5}, 1});
  EXPECT_FALSE(report.all_inside());
  EXPECT_EQ(report.of(Tissue::Muscle).worst_place, Vec3(5, 5, 5));
}

} // namespace
} // namespace f2b
