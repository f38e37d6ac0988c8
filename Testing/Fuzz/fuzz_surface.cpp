#include "Fuzz/fuzzed_file.hpp"

#include <Bridge/vtk_surface.hpp>

/// The first byte chooses the format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const char* const formats[] = {".obj", ".ply"};
  if (size == 0)
    return 0;
  const auto file = f2b::fuzz::file_of(data + 1, size - 1, formats[data[0] % 2]);
  return f2b::fuzz::expect_orderly([&] { (void)f2b::read_surface(file); });
}
