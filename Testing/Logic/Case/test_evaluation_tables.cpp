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

TEST(TargetRecipes, PeakAtFiveToEightMillimetresAndOnlyTheLastMovesTheChin)
{
  const std::vector<TargetRecipe> recipes = target_recipes();
  ASSERT_EQ(recipes.size(), 3u);
  for (const TargetRecipe& recipe : recipes)
  {
    double peak = 0;
    for (const BrushStroke& stroke : recipe.strokes)
      for (const BrushStroke::PathPoint& point : stroke.path)
        peak = std::max(peak, point.shift.norm());
    EXPECT_GE(peak, 5) << recipe.name;
    EXPECT_LE(peak, 8) << recipe.name;
    EXPECT_EQ(recipe.moves_chin, recipe.name == "c");
  }
}

/// From the vertex nearest to A to the one nearest to B, 3 to 5 mm forwards.
TargetRecipe stroke_from_a_to_b()
{
  return {"t", "", false, {{{{"A", {0, 3, 0}}, {"B", {0, 5, 0}}}, 2, 6}}};
}

TEST(TargetRecipes, MoveSkinAlongAStrokeEvenlyAndFadeBesideIt)
{
  const std::vector<Vec3> skin = {{0, 0, 0}, {8, 0, 0}, {4, 0, 1.9}, {4, 0, 4}, {4, 0, 6.1}};
  const Landmarks landmarks = {{"A", {1, -2, 0}}, {"B", {9, 0, 1}}};
  const auto d = stroke_from_a_to_b().displacement(skin, landmarks);
  const double forwards[] = {3, 5, 4, 2, 0}; // halfway between full_mm and reach_mm, half of it
  for (std::size_t v = 0; v < skin.size(); ++v)
    EXPECT_NEAR((d[v] - Vec3(0, forwards[v], 0)).norm(), 0, 1e-12) << v;
}

TEST(TargetRecipes, DoNotAddUpStrokesThatOverlap)
{
  TargetRecipe recipe = stroke_from_a_to_b();
  recipe.strokes.push_back(recipe.strokes.front());
  const std::vector<Vec3> skin = {{0, 0, 0}, {8, 0, 0}, {4, 0, 4}};
  const auto d = recipe.displacement(skin, {{"A", {0, 0, 0}}, {"B", {8, 0, 0}}});
  EXPECT_NEAR((d[1] - Vec3(0, 5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((d[2] - Vec3(0, 3, 0)).norm(), 0, 1e-12); // untouched by both: a quarter of it
}

TEST(TargetRecipes, TakeTheMeanOfLandmarksAndNameTheOneThatIsNotThere)
{
  TargetRecipe recipe = stroke_from_a_to_b();
  const std::vector<Vec3> skin = {{0, 0, 0}, {8, 0, 0}, {40, 0, 0}};
  recipe.strokes[0].path = {{"A|B|B", {0, 0, 2}}}; // their mean is nearest to the second vertex
  const auto d = recipe.displacement(skin, {{"A", {2, 0, 0}}, {"B", {11, 0, 0}}});
  EXPECT_NEAR(d[1].z(), 2, 1e-12);
  EXPECT_EQ(d[2].norm(), 0);
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
