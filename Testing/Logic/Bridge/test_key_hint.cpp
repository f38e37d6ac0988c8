#include <Bridge/key_hint.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

TEST(KeyHint, NamesTheNearestWordOrAllOfThem)
{
  EXPECT_EQ(hint_for("untis", {"name", "units"}), "did you mean 'units'?");
  EXPECT_EQ(hint_for("density", {"name", "units"}), "known keys here: name, units");
  EXPECT_EQ(hint_for("psi", {"MPa", "kPa"}, "units"), "known units: MPa, kPa");
  EXPECT_EQ(hint_for("x", {}), "known keys here: ");
}

} // namespace
} // namespace f2b
