#include "Case/evaluation_tables.hpp"
#include "Case/target_recipes.hpp"
#include "Case/virtual_truth.hpp"
#include "Core/error.hpp"
#include "expect_error.hpp"

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

TEST(EvaluationTables, CsvQuotesWhatWouldBreakIt)
{
  const Table table{"t", {"a", "b"}, {{"x, y", "said \"so\""}, {"1", ""}}};
  EXPECT_EQ(to_csv(table), "a,b\r\n\"x, y\",\"said \"\"so\"\"\"\r\n1,\r\n");
  EXPECT_EQ(to_markdown(table),
            "### t\n\n| a | b |\n| --- | --- |\n| x, y | said \"so\" |\n| 1 |  |\n\n");
}

TEST(TargetRecipes, PeakAtFiveToEightMillimetresAndOnlyTheLastWarpsTheChin)
{
  const std::vector<TargetRecipe> recipes = target_recipes();
  ASSERT_EQ(recipes.size(), 3u);
  for (const TargetRecipe& recipe : recipes)
  {
    double peak = 0;
    for (const auto& [landmark, shift] : recipe.points)
      peak = std::max(peak, shift.norm());
    EXPECT_GE(peak, 5) << recipe.name;
    EXPECT_LE(peak, 8) << recipe.name;
    EXPECT_EQ(recipe.warps_chin, recipe.name == "c");
  }
}

TEST(TargetRecipes, TakeTheVerticesNearestToTheLandmarksThere)
{
  TargetRecipe recipe;
  recipe.name = "t";
  recipe.radius_mm = 10;
  recipe.points = {{"A", {0, 3, 0}}, {"B", {0, 0, 0}}};
  const std::vector<Vec3> skin = {{0, 0, 0}, {8, 0, 0}, {40, 0, 0}};
  const auto d = recipe.displacement(skin, {{"A", {1, -2, 0}}, {"B", {9, 0, 1}}});
  EXPECT_NEAR((d[0] - Vec3(0, 3, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(d[1].norm(), 0, 1e-12);
  EXPECT_EQ(d[2].norm(), 0);
  TargetRecipe between = recipe;
  between.points = {{"A|B", {0, 0, 2}}}; // their middle is nearest to the second vertex
  EXPECT_NEAR(between.displacement(skin, {{"A", {1, 0, 0}}, {"B", {11, 0, 0}}})[1].z(), 2, 1e-12);
  test::expect_error(
      [&] {
        (void)recipe.displacement(skin, {{"A", {1, -2, 0}}});
      },
      {"target 't'", "'B' is not there", "--experiments 1,2"});
}

TEST(VirtualTruth, HasAnotherLawOfTheStatedStiffness)
{
  MaterialSet plan{"plan", {}};
  for (Law& law : plan.laws)
    law = Yeoh{{0.03, 0.01, 0.002}, {VolumetricLaw::Kind::Barrier, bulk_from(0.06, 0.49)}};
  const TruthOptions options;
  const MaterialSet truth = truth_materials(plan, options);
  for (std::size_t t = 0; t < truth.laws.size(); ++t)
  {
    EXPECT_TRUE(std::holds_alternative<NeoHookean>(truth.laws[t]));
    EXPECT_NEAR(shear_modulus(truth.laws[t]), options.stiffness[t] * 0.06, 1e-12);
    EXPECT_NEAR(poisson_ratio(truth.laws[t]), 0.45, 1e-9);
  }
}

} // namespace
} // namespace f2b
