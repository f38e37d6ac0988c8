#include <Core/error.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

TEST(Error, StaysInOneLineWhateverTheFileSays)
{
  const Error error("a\nb.json", "'/k\rey' is \x1b[31mred\x7f", "remove\tit");
  EXPECT_STREQ(error.what(), "a\\nb.json: '/k\\x0dey' is \\x1b[31mred\\x7f; remove\\tit");
}

TEST(Error, LeavesNamesInOtherScriptsAlone)
{
  EXPECT_STREQ(Error("Schädel.nrrd", "глаз", "目").what(), "Schädel.nrrd: глаз; 目");
}

} // namespace
} // namespace f2b
