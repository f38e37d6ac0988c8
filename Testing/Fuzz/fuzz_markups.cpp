#include "Fuzz/fuzzed_file.hpp"

#include <Bridge/markups.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto file = f2b::fuzz::file_of(data, size, ".mrk.json");
  f2b::fuzz::expect_orderly([&] { (void)f2b::read_points(file); });
  f2b::fuzz::expect_orderly([&] { (void)f2b::read_landmarks(file); });
  return f2b::fuzz::expect_orderly([&] { (void)f2b::read_planes(file); });
}
