#include "Fuzz/fuzzed_file.hpp"

#include <Bridge/material_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto file = f2b::fuzz::file_of(data, size, ".json");
  return f2b::fuzz::expect_orderly([&] { (void)f2b::read_materials(file.string()); });
}
