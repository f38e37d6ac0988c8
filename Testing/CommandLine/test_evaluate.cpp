#include "CommandLine/coarse_case.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

namespace f2b::test
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

const Path& meshed_case()
{
  static const Path folder = []
  {
    const Path dir = scratch_folder() / "meshed";
    json document = coarse_case();
    document["region_ras"] = {{"min", {-70, -5, -134}}, {"max", {70, 115, 10}}};
    const Path file = write_case(scratch_folder(), document);
    EXPECT_EQ(run_program({"segment", file.string(), "-o", dir.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"cut", dir.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"mesh", dir.string()}).exit_code, 0);
    return dir;
  }();
  return folder;
}

TEST(Evaluate, GivesTheThreeExperimentsAsTablesAndPictures)
{
  const Path dir = meshed_case();
  const Answer answer =
      run_program({"evaluate", dir.string(), "--movement", "mid-face:1,3,-1,1,1,0", "--no-search"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  for (const char* part :
       {"tetrahedra only", "neo-Hookean", "Experiment 1: the least mean error has", "paper Table 4",
        "nothing was tuned", "chin", "not a medical device"})
    EXPECT_NE(answer.out.find(part), std::string::npos) << part << " is not in\n" << answer.out;
  for (const char* name :
       {"evaluation.json", "evaluation.md", "table3.csv", "table4.csv", "experiment3.csv",
        "experiment1.png", "experiment2_S1.png", "experiment2_S2.png", "experiment3.png"})
    EXPECT_GT(fs::file_size(dir / "evaluation" / name), 100u) << name;

  const json told = json::parse(read_text(dir / "evaluation/evaluation.json"));
  EXPECT_EQ(told.at("experiment1").at("rows").size(), 4u);
  const json& s2 = told.at("experiment2").at("rows").at(1);
  const double rigid = s2.at("methods").at("rigid-fit").at("bone_error_mm").at("mean");
  EXPECT_GT(rigid, 0.01); // judged by another model than its own
  EXPECT_GT(s2.at("virtual_force_over_rigid_fit"), 1);
  const json& c = told.at("experiment3").at("rows").at(2);
  EXPECT_LT(c.at("with_genioplasty").at("chin").at("left_rms_mm"),
            c.at("chin").at("left_rms_mm").get<double>());

  // a new mesh makes it stale
  EXPECT_EQ(run_program({"mesh", dir.string()}).exit_code, 0);
  EXPECT_FALSE(fs::exists(dir / "evaluation"));
}

TEST(Evaluate, RefusesInOneLine)
{
  const Path dir = meshed_case();
  expect_refusal({"evaluate", dir.string(), "--experiments", "4"}, {"4", "evaluate --help"}, dir);
  expect_refusal({"evaluate", dir.string(), "--box", "0,0,0,9,9,9"}, {"no post-operative CT"}, dir);
  expect_refusal({"evaluate", dir.string(), "--movement", "chin:0,1,0,0,0,0"}, {"chin"}, dir);
  expect_refusal({"evaluate", dir.string(), "--postoperative", "nowhere.nrrd"}, {"nowhere.nrrd"},
                 dir);
  expect_refusal(
      {"evaluate", dir.string(), "--postoperative", "x.nrrd", "--movement", "mid-face:0,1,0,0,0,0"},
      {"both", "give one"}, dir);
}

} // namespace
} // namespace f2b::test
