#include "Fuzz/fuzzed_file.hpp"

#include <Case/case_settings.hpp>

#include <nlohmann/json.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const nlohmann::json document = nlohmann::json::parse(data, data + size, nullptr, false);
  if (document.is_discarded())
    return 0; // read_json says so: fuzz_markups reads through it
  return f2b::fuzz::expect_orderly([&] { (void)f2b::parse_settings(document, "/case.json"); });
}
