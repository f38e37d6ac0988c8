#include "Core/error.hpp"
#include "Core/material/law_fit.hpp"
#include "Core/material/stability.hpp"
#include "Logic/Core/material_samples.hpp"
#include "expect_error.hpp"

#include <cmath>

namespace f2b
{
namespace
{

using namespace testing;
using f2b::test::expect_error;

const VolumetricLaw U{VolumetricLaw::Kind::Barrier, 1};

StressCurve curve_of(const Law& law, Loading loading)
{
  const double rest = rest_of(loading);
  StressCurve curve = sampled_curve(law, loading, rest - 0.1, rest + 0.4, 26);
  curve.source = "own curve";
  return curve;
}

FitOptions options_for(FittedLaw law, bool stable = false)
{
  FitOptions options;
  options.law = law;
  options.stable = stable;
  return options;
}

TEST(LawFit, FindsTheCoefficientsThatMadeTheCurve)
{
  for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial, Loading::SimpleShear})
  {
    const LawFit neo = fit_law(curve_of(NeoHookean{{0.03}, U}, loading),
                               options_for(FittedLaw::OneTermNeoHookean));
    EXPECT_NEAR(std::get<NeoHookean>(neo.law).isochoric.c10, 0.03, 1e-14);
    const LawFit yeoh = fit_law(curve_of(Yeoh{{0.03, -0.01, 0.2}, U}, loading),
                                options_for(FittedLaw::ThreeTermYeoh));
    const IsochoricYeoh& found = std::get<Yeoh>(yeoh.law).isochoric;
    EXPECT_NEAR(found.c1, 0.03, 1e-12);
    EXPECT_NEAR(found.c2, -0.01, 1e-11);
    EXPECT_NEAR(found.c3, 0.2, 1e-10);
    EXPECT_LT(yeoh.rms_residual, 1e-14);
    EXPECT_NEAR(poisson_ratio(yeoh.law), 0.49, 1e-12);
  }
  const LawFit mooney = fit_law(curve_of(MooneyRivlin{{skin_c10, skin_c01}, U}, Loading::Uniaxial),
                                options_for(FittedLaw::TwoTermMooneyRivlin));
  EXPECT_NEAR(std::get<MooneyRivlin>(mooney.law).isochoric.c01, skin_c01, 1e-12);
}

TEST(LawFit, IsAMinimumUnderItsConstraints)
{
  const StressCurve curve = curve_of(MooneyRivlin{{skin_c10, skin_c01}, U}, Loading::Uniaxial);
  const auto residual = [&](const IsochoricYeoh& W)
  {
    double sum = 0;
    for (std::size_t i = 0; i < curve.stress.size(); ++i)
    {
      const double s =
          incompressible_response(Yeoh{W, U}, Loading::Uniaxial, curve.deformation[i]).stress;
      sum += (s - curve.stress[i]) * (s - curve.stress[i]);
    }
    return std::sqrt(sum / double(curve.stress.size()));
  };
  const LawFit fit = fit_law(curve, options_for(FittedLaw::ThreeTermYeoh, true));
  const IsochoricYeoh best = std::get<Yeoh>(fit.law).isochoric;
  EXPECT_NEAR(residual(best), fit.rms_residual, 1e-15);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> change(-1, 1);
  for (const double size : {1e-5, 1e-3, 1e-1})
    for (int sample = 0; sample < 300; ++sample)
    {
      const IsochoricYeoh other{std::max(0.0, best.c1 + size * change(generator)),
                                std::max(0.0, best.c2 + size * change(generator)),
                                std::max(0.0, best.c3 + size * change(generator))};
      EXPECT_GE(residual(other), fit.rms_residual * (1 - 1e-12));
    }
}

TEST(LawFit, StableFitsAreStableAtEveryStretchAndOthersSayWhereTheyAreNot)
{
  const StressCurve curve = curve_of(MooneyRivlin{{skin_c10, skin_c01}, U}, Loading::Uniaxial);
  for (const FittedLaw law :
       {FittedLaw::OneTermNeoHookean, FittedLaw::TwoTermMooneyRivlin, FittedLaw::ThreeTermYeoh})
  {
    const LawFit fit = fit_law(curve, options_for(law, true));
    for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial, Loading::SimpleShear})
      EXPECT_TRUE(growing_range(fit.law, loading, Compressibility::Incompressible).is_everywhere());
    EXPECT_GT(fit.rms_residual, 1e-4);
  }
  const LawFit literal = fit_law(curve, options_for(FittedLaw::TwoTermMooneyRivlin));
  EXPECT_NEAR(growing_range(literal.law, Loading::Uniaxial, Compressibility::Incompressible).lowest,
              0.8957, 1e-4);
}

TEST(LawFit, PointsThatCannotTellAreRefused)
{
  expect_error(
      []
      {
        fit_law(curve_of(NeoHookean{{0.03}, U}, Loading::SimpleShear),
                options_for(FittedLaw::TwoTermMooneyRivlin));
      },
      {"own curve", "2 coefficients apart", "fewer coefficients"});
  StressCurve one{"one point", Loading::Uniaxial, {1.1}, {0.02}};
  expect_error([&] { fit_law(one, options_for(FittedLaw::ThreeTermYeoh)); },
               {"one point", "3 coefficients"});
  StressCurve rest{"rest", Loading::Uniaxial, {1, 1, 1}, {0, 0, 0}};
  expect_error([&] { fit_law(rest, options_for(FittedLaw::OneTermNeoHookean)); },
               {"rest", "apart"});
  StressCurve wrong{"signs", Loading::Uniaxial, {1.1, 1.2, 1.3}, {-0.1, -0.2, -0.3}};
  for (const bool stable : {false, true})
    expect_error([&] { fit_law(wrong, options_for(FittedLaw::OneTermNeoHookean, stable)); },
                 {"signs", "positive stiffness"});
}

} // namespace
} // namespace f2b
