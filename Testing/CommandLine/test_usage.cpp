#include "CommandLine/program.hpp"

#include "temporary_folder.hpp"

#include <gtest/gtest.h>

namespace f2b::test
{
namespace
{

const char* const verbs[] = {"sample", "run",     "segment", "cut",    "mesh",         "target",
                             "plan",   "predict", "export",  "report", "fit-material", "suggest"};

TEST(Usage, HelpTellsEveryVerbAndTheFirstCommand)
{
  const Answer help = run_program({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  for (const char* verb : verbs)
    EXPECT_NE(help.out.find(std::string("\n  ") + verb), std::string::npos) << verb;
  EXPECT_NE(help.out.find("facetobone sample -o patient && facetobone run"), std::string::npos);
  EXPECT_NE(help.out.find("not a medical device"), std::string::npos);
}

TEST(Usage, EveryVerbHasHelp)
{
  for (const char* verb : verbs)
  {
    const Answer help = run_program({verb, "--help"});
    EXPECT_EQ(help.exit_code, 0) << verb;
    EXPECT_EQ(help.err, "") << verb;
    EXPECT_GT(help.out.size(), 100u) << verb;
  }
}

TEST(Usage, VersionIsOneLine)
{
  const Answer version = run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.find("facetobone "), 0u);
  EXPECT_EQ(version.out.find('\n'), version.out.size() - 1);
}

TEST(Usage, MistakesAreToldInOneLine)
{
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const std::pair<Arguments, std::vector<std::string>> mistakes[] = {
      {{}, {"facetobone --help"}},
      {{"frobnicate"}, {"frobnicate", "--help"}},
      {{"run"}, {"facetobone run --help"}},
      {{"run", "case.json"}, {"output", "facetobone run --help"}},
      {{"cut"}, {"DIR", "facetobone cut --help"}},
      {{"cut", out, "--fast"}, {"--fast"}},
      {{"sample", "-o", out, "--spacing", "9"}, {"--spacing", "9"}},
      {{"sample", "-o", out, "--spacing", "nan"}, {"--spacing"}},
      {{"sample", "-o", out, "--seed", "x"}, {"--seed", "x"}},
      {{"target", out, "--warp-from", "a.json"}, {"--warp-to"}}};
  for (const auto& [arguments, parts] : mistakes)
    expect_refusal(arguments, parts, folder.path());
}

TEST(Usage, VerbsOnWhatIsNoCaseSayHowToMakeOne)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "empty");
  for (const char* verb : {"cut", "mesh", "target", "plan", "predict", "report"})
  {
    expect_refusal({verb, (folder / "absent").string()},
                   {"absent", "facetobone segment CASE.json -o"}, folder.path());
    expect_refusal({verb, (folder / "empty").string()},
                   {"empty", "case.json", "facetobone segment"}, folder.path());
  }
}

} // namespace
} // namespace f2b::test
