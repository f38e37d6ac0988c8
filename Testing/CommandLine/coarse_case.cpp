#include "CommandLine/coarse_case.hpp"

#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include <unistd.h>

namespace f2b::test
{

using nlohmann::json;

Path coarse_sample()
{
  static const bool there = std::filesystem::exists(Path(COARSE_SAMPLE) / "case.json");
  static const int made =
      there ? 0 : run_program({"sample", "--spacing", "2.5", "-o", COARSE_SAMPLE}).exit_code;
  EXPECT_EQ(made, 0);
  return COARSE_SAMPLE;
}

json coarse_case()
{
  json document = json::parse(read_text(coarse_sample() / "case.json"));
  auto make_absolute = [](json& path)
  { path = (coarse_sample() / path.get<std::string>()).string(); };
  make_absolute(document["ct"]);
  make_absolute(document["landmarks"]);
  make_absolute(document["target"]["warp"]["from"]);
  make_absolute(document["target"]["warp"]["to"]);
  document["region_ras"] = {{"min", {-60, 5, -120}}, {"max", {60, 115, 10}}};
  document["segmentation"] = {{"spacing_mm", 2}};
  document["mesh"] = {{"density", 0.1}};
  document["solver"] = {{"max_fit_iterations", 2}, {"step_tolerance_mm", 1e-4}};
  return document;
}

Path write_case(const Path& folder, const json& document, const std::string& name)
{
  std::ofstream(folder / name) << document.dump(1);
  return folder / name;
}

namespace
{

struct Scratch
{
  Path path =
      std::filesystem::temp_directory_path() / ("f2b commands " + std::to_string(::getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
};

} // namespace

Path scratch_folder()
{
  static const Scratch scratch;
  return scratch.path;
}

} // namespace f2b::test
