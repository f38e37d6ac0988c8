#include "CommandLine/coarse_case.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

namespace f2b::test
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

const char* const movement = "mid-face:1,2,-1,2,1,0";

/// The coarse case, meshed; made once, copied for each test.
const Path& meshed_case()
{
  static const Path folder = []
  {
    const Path dir = scratch_folder() / "meshed";
    const Path file = write_case(scratch_folder(), coarse_case());
    EXPECT_EQ(run_program({"segment", file.string(), "-o", dir.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"cut", dir.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"mesh", dir.string()}).exit_code, 0);
    return dir;
  }();
  return folder;
}

struct Forward : ::testing::Test
{
  Forward() { fs::copy(meshed_case(), dir, fs::copy_options::recursive); }

  Answer done(const Arguments& arguments) const
  {
    const Answer answer = run_program(arguments, folder.path());
    EXPECT_EQ(answer.exit_code, 0) << arguments[0] << ": " << answer.err;
    EXPECT_EQ(answer.err, "");
    return answer;
  }

  const TemporaryFolder folder;
  const Path dir = folder / "case";
};

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t times = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++times;
  return times;
}

TEST_F(Forward, BundlesTheSceneWithItsData)
{
  done({"export", "case", "--format", "mrb"});
  const std::string scene = read_text(dir / "case.mrml");
  ASSERT_NE(scene, "") << "the case's own scene stays";
  done({"export", "case", "--format", "mrb", "-o", "sent.mrb"});
  for (const Path& bundle : {dir / "export.mrb", folder / "sent.mrb"})
  {
    const std::string bytes = read_text(bundle);
    EXPECT_EQ(bytes.compare(0, 2, "PK"), 0) << bundle;
    for (const char* part : {".mrml", "skin.vt", "bone.vt", "mesh.vt"})
      EXPECT_NE(bytes.find(part), std::string::npos) << bundle << " lacks " << part;
  }
  const Answer refused =
      run_program({"export", "case", "--format", "mrb", "-o", "sent.zip"}, folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("sent.zip"), std::string::npos) << refused.err;
}

TEST_F(Forward, ExportsIntoTheCaseOrElsewhereAndLeavesItsMovementAlone)
{
  const json before = json::parse(read_text(dir / "case.json"));
  const json mesh = json::parse(read_text(dir / "mesh.json"));
  done({"export", "case", "--format", "febio", "--movement", movement});
  const std::string deck = read_text(dir / "export.feb");
  EXPECT_EQ(count(deck, "<elem id="),
            mesh.at("prisms").get<std::size_t>() + mesh.at("tets").get<std::size_t>());
  EXPECT_NE(deck.find("<!-- FRAGMENT_1_MID_FACE is fragment 'mid-face': right 1, anterior 2"),
            std::string::npos);
  done({"export", "case", "--format", "febio", "--movement", movement, "--split-prisms",
        "--increments", "3", "-o", "split.feb"});
  const std::string split = read_text(folder / "split.feb");
  EXPECT_EQ(count(split, "<elem id="),
            3 * mesh.at("prisms").get<std::size_t>() + mesh.at("tets").get<std::size_t>());
  EXPECT_NE(split.find("<time_steps>3</time_steps>"), std::string::npos);
  done({"export", "case", "--format", "vtu", "--movement", movement});
  EXPECT_NE(read_text(dir / "export.vtu").find("prescribed_displacement"), std::string::npos);
  EXPECT_TRUE(fs::exists(dir / "export.feb"));
  EXPECT_EQ(json::parse(read_text(dir / "case.json")), before);

  done({"mesh", "case"}); // the decks are of the mesh that is gone
  EXPECT_FALSE(fs::exists(dir / "export.feb"));
  EXPECT_FALSE(fs::exists(dir / "export.vtu"));
  EXPECT_TRUE(fs::exists(folder / "split.feb"));
}

TEST_F(Forward, PredictsWithEveryModelAndSaysWhich)
{
  std::map<std::string, std::string> faces;
  for (const std::string model : {"lfem", "mtm", "nfem", "nfm-em"})
  {
    done({"predict", "case", "--model", model, "--movement", movement, "-q"});
    const json told = json::parse(read_text(dir / "predict.json"));
    EXPECT_EQ(told.at("model"), model);
    EXPECT_GT(told.at("time_s").at("total"), 0) << model;
    if (model == "mtm")
    {
      EXPECT_LE(told.at("relaxation").at("residual"), 1e-5);
    }
    else
    {
      EXPECT_GE(told.at("factorizations"), 1) << model;
    }
    faces[read_text(dir / "predicted.vtp")] = model;
    EXPECT_TRUE(fs::exists(dir / "predicted.vtu")) << model;
    // the case keeps what differs from the defaults, of which the mixed elements are one
    const json kept = json::parse(read_text(dir / "case.json")).value("solver", json::object());
    EXPECT_EQ(kept.value("predict_model", "nfm-em"), model);
  }
  EXPECT_EQ(faces.size(), 4u) << "two models predict the very same face";
  expect_refusal({"predict", dir.string(), "--model", "nfm_em", "--movement", movement},
                 {"predict_model", "nfm_em", "did you mean 'nfm-em'?"}, folder.path());
}

TEST_F(Forward, ExportRefusesInOneLine)
{
  const std::string at = dir.string(), out = (folder / "no such folder/x.inp").string();
  const std::pair<Arguments, std::vector<std::string>> mistakes[] = {
      {{"export", at, "--format", "calculix", "--movement", movement},
       {"barrier", "CalculiX has quadratic"}},
      {{"export", at, "--format", "febio"}, {"no movement", "--movement"}},
      {{"export", at, "--format", "febio", "--movement", "chin:1,2,3,0,0,0"}, {"chin", "mid-face"}},
      {{"export", at, "--format", "abaqus", "--movement", movement}, {"abaqus", "calculix"}},
      {{"export", at, "--movement", movement}, {"--format"}},
      {{"export", at, "--format", "vtu", "--movement", movement, "-o", at + "/mesh.vtu"},
       {"mesh.vtu", "lies in the case"}},
      {{"export", at, "--format", "febio", "--movement", movement, "-o", out}, {"no such folder"}},
      {{"export", at, "--format", "vtu", "--movement", movement, "-o", out}, {"no such folder"}}};
  for (const auto& [arguments, parts] : mistakes)
    expect_refusal(arguments, parts, folder.path());
}

} // namespace
} // namespace f2b::test
