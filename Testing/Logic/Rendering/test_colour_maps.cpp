#include <Rendering/colour_maps.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

f2b::Colour colour_at(vtkLookupTable* map, double value)
{
  f2b::Colour colour{};
  map->GetColor(value, colour.data());
  return colour;
}

TEST(ColourMaps, DivergingIsBlueBehindWhiteOnRedInFront)
{
  const auto map = f2b::diverging_map(2);
  const f2b::Colour behind = colour_at(map, -2), on = colour_at(map, 0), front = colour_at(map, 2);
  EXPECT_GT(behind[2], behind[0] + 0.3);
  EXPECT_NEAR(on[0], on[2], 0.05);
  EXPECT_GT(on[0], 0.9);
  EXPECT_GT(front[0], front[2] + 0.3);
}

TEST(ColourMaps, SequentialDarkensSteadily)
{
  const auto map = f2b::sequential_map(10);
  double previous = std::numeric_limits<double>::infinity();
  for (double value = 0; value <= 10; value += 0.5)
  {
    const f2b::Colour c = colour_at(map, value);
    const double luminance = 0.21 * c[0] + 0.72 * c[1] + 0.07 * c[2];
    EXPECT_LT(luminance, previous) << "at " << value;
    previous = luminance;
  }
}

TEST(ColourMaps, NiceCeilingRoundsUpAndKeepsNiceValues)
{
  EXPECT_DOUBLE_EQ(f2b::nice_ceiling(1.21), 1.5);
  EXPECT_DOUBLE_EQ(f2b::nice_ceiling(2.0), 2.0);
  EXPECT_DOUBLE_EQ(f2b::nice_ceiling(11), 15);
  EXPECT_NEAR(f2b::nice_ceiling(0.3), 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(f2b::nice_ceiling(99), 100);
  EXPECT_DOUBLE_EQ(f2b::nice_ceiling(0), 0);
}

TEST(ColourMaps, RangeHoldsTheAskedShareAndIgnoresUnknownValues)
{
  std::vector<double> values(1000, 0.4);
  values[0] = -50; // one outlier does not set the scale
  values[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(f2b::nice_range(values, 0.99, 0.1), 0.4);
  EXPECT_DOUBLE_EQ(f2b::nice_range(values, 1.0, 0.1), 50);
  EXPECT_DOUBLE_EQ(f2b::nice_range({}, 0.99, 0.5), 0.5);
}

} // namespace
