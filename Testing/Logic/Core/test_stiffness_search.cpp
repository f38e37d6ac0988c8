#include "Core/inverse/stiffness_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace f2b
{
namespace
{

/// Tries what the search asks for; returns the number of trials.
template <class Residual>
int run(StiffnessSearch& search, const Residual& residual, int most = 40)
{
  for (int trials = 0; trials < most; ++trials)
  {
    const auto stiffness = search.next();
    if (!stiffness)
      return trials;
    EXPECT_GT(*stiffness, 0);
    EXPECT_TRUE(std::isfinite(*stiffness));
    search.tell({*stiffness, residual(*stiffness)});
  }
  return most;
}

TEST(StiffnessSearch, MeetsTheResidualOfSpringsInSeriesWhateverTheTissue)
{
  for (const double tissue : {1e-4, 1e-3, 0.01, 0.1, 1.0})
    for (const double wanted : {0.05, 0.5, 5.0})
    {
      StiffnessSearch search(7, wanted, 0.02);
      const int trials = run(search, [&](double K) { return 7 / (1 + K / tissue); });
      SCOPED_TRACE(tissue);
      EXPECT_TRUE(search.met());
      EXPECT_GE(search.best().residual_mm, 0.9 * wanted);
      EXPECT_LE(trials, 6);
    }
}

TEST(StiffnessSearch, MeetsTheResidualOfManySpringsOfDifferentSoftness)
{
  auto residual = [](double K)
  { return 3 / (1 + K / 1e-3) + 3 / (1 + K / 0.02) + 1 / (1 + K / 0.8); };
  StiffnessSearch search(7, 0.5, 0.02);
  EXPECT_LE(run(search, residual), 5);
  EXPECT_TRUE(search.met());
  EXPECT_GE(search.best().residual_mm, 0.45);
}

TEST(StiffnessSearch, FindsTheLeastOfALoadThatOvershoots)
{
  // a dead load: the skin goes as far as the load is large; a part of the target stays out of reach
  auto residual = [](double K) { return 0.8 + 6 * std::abs(1 - K / 3e-4); };
  StiffnessSearch search(6.8, 0.5, 0.02);
  const int trials = run(search, residual);
  EXPECT_FALSE(search.met());
  EXPECT_NEAR(search.best().stiffness, 3e-4, 0.1 * 3e-4);
  EXPECT_LE(trials, 20);
  StiffnessSearch easier(6.8, 1.5, 0.02);
  run(easier, residual);
  EXPECT_TRUE(easier.met());
}

TEST(StiffnessSearch, GoesAsFarAsThereIsAnEquilibrium)
{
  auto residual = [](double K)
  { return K > 0.05 ? std::numeric_limits<double>::infinity() : 7 / (1 + K / 0.01); };
  StiffnessSearch out_of_reach(7, 0.5, 0.02), within_reach(7, 1.4, 0.02);
  run(out_of_reach, residual);
  EXPECT_FALSE(out_of_reach.met());
  EXPECT_NEAR(out_of_reach.best().stiffness, 0.05, 0.006);
  run(within_reach, residual);
  EXPECT_TRUE(within_reach.met());
}

TEST(StiffnessSearch, EndsWithoutForceWhereNothingHelps)
{
  StiffnessSearch search(7, 0.5, 0.02);
  const int trials = run(search, [](double) { return std::numeric_limits<double>::infinity(); });
  EXPECT_LT(trials, 15);
  EXPECT_EQ(search.best().stiffness, 0);
  StiffnessSearch deaf(7, 0.5, 0.02);
  EXPECT_LT(run(deaf, [](double) { return 7.0; }), 15);
  EXPECT_FALSE(deaf.met());
}

} // namespace
} // namespace f2b
