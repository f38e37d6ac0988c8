#include "CommandLine/program.hpp"

#include "temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace f2b::test
{
namespace
{

const std::string table = "# cheek, invented for this test\n# test: uniaxial\n"
                          "strain_percent,true_stress_kPa\n0,0\n5,3.1\n10,6.9\n20,16.2\n30,30.5\n";

TEST(FitMaterial, WritesMaterialAndPlotAndTellsWhatItFound)
{
  const TemporaryFolder folder;
  const std::string data = folder.write("cheek.csv", table).string();
  const Answer answer = run_program({"fit-material", data, "--law", "yeoh", "--stable",
                                     "--poisson-ratio", "0.45", "-o", (folder / "out").string()});
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.err, "");
  for (const char* part : {"cheek.csv: uniaxial test, 5 points, stretch 1 to 1.3", "c1 ", "kPa",
                           "RMS residual", "0.45", "stable at        every stretch",
                           "cheek-stable-yeoh.json", "cheek-stable-yeoh.png"})
    EXPECT_NE(answer.out.find(part), std::string::npos) << part << " is not in\n" << answer.out;
  const auto material = nlohmann::json::parse(read_text(folder / "out" / "cheek-stable-yeoh.json"));
  EXPECT_EQ(material["law"], "yeoh");
  EXPECT_EQ(material["units"], "MPa");
  EXPECT_EQ(material["poisson_ratio"], 0.45);
  EXPECT_GE(material["c2"], 0);
  EXPECT_EQ(read_text(folder / "out" / "cheek-stable-yeoh.png").substr(1, 3), "PNG");
}

TEST(FitMaterial, Table1AndItsTissuesNeedNoFile)
{
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const Answer all = run_program({"fit-material", "--table1", "--stable", "-o", out});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  for (const char* part : {"skin:", "fat:", "muscle:", "47.96368 kPa", "table1-stable.json"})
    EXPECT_NE(all.out.find(part), std::string::npos) << part << " is not in\n" << all.out;
  const Answer fat =
      run_program({"fit-material", "--table1", "fat", "--law", "mooney-rivlin", "-o", out});
  EXPECT_EQ(fat.exit_code, 0) << fat.err;
  EXPECT_NE(fat.out.find("0.9816"), std::string::npos) << fat.out;
}

TEST(FitMaterial, MistakesAreToldInOneLine)
{
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const std::string good = folder.write("good.csv", table).string();
  const std::string bad =
      folder.write("bad.csv", "# test: uniaxial\nstretch,nominal_stress_kPa\n1.1;abc\n").string();
  const std::pair<Arguments, std::vector<std::string>> mistakes[] = {
      {{"fit-material"}, {"DATA.csv", "--table1"}},
      {{"fit-material", (folder / "absent.csv").string()}, {"absent.csv", "cannot be read"}},
      {{"fit-material", bad, "-o", out}, {"bad.csv:3:", "'abc'"}},
      {{"fit-material", good, "--law", "yeo", "-o", out}, {"'yeo'", "did you mean 'yeoh'"}},
      {{"fit-material", good, "--poisson-ratio", "0.5"}, {"--poisson-ratio", "0.4999"}},
      {{"fit-material", good, "--poisson-ratio", "nan"}, {"--poisson-ratio"}},
      {{"fit-material", "--table1", "bone", "-o", out}, {"'bone'", "skin, fat, muscle"}}};
  for (const auto& [arguments, parts] : mistakes)
    expect_refusal(arguments, parts, folder.path());
}

} // namespace
} // namespace f2b::test
