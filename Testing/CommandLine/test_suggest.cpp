#include "CommandLine/coarse_case.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace f2b::test
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

/// The coarse case with all of the chin, meshed with two other cuts; made once, copied for each
/// test.
const Path& meshed_case()
{
  static const Path folder = []
  {
    const Path dir = scratch_folder() / "meshed";
    json document = coarse_case();
    document["region_ras"] = {{"min", {-70, -5, -134}}, {"max", {70, 115, 10}}};
    document["osteotomies"] = {{{"template", "le-fort-1"}}, {{"template", "genioplasty"}}};
    const Path file = write_case(scratch_folder(), document);
    EXPECT_EQ(run_program({"segment", file.string(), "-o", dir.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"cut", dir.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"mesh", dir.string()}).exit_code, 0);
    return dir;
  }();
  return folder;
}

struct Suggest : ::testing::Test
{
  Suggest() { fs::copy(meshed_case(), dir, fs::copy_options::recursive); }

  Answer done(const Arguments& arguments) const
  {
    const Answer answer = run_program(arguments, folder.path());
    EXPECT_EQ(answer.exit_code, 0) << arguments[0] << ": " << answer.err;
    EXPECT_EQ(answer.err, "");
    return answer;
  }

  /// The face that these movements of the case's own fragments give.
  void aim_at(const Arguments& movements) const
  {
    Arguments arguments = {"target", "case"};
    for (const std::string& movement : movements)
      arguments.insert(arguments.end(), {"--movement", movement});
    done(arguments);
  }

  json suggested() const { return json::parse(read_text(dir / "suggest.json")); }

  const TemporaryFolder folder;
  const Path dir = folder / "case";
};

using Cuts = std::vector<std::string>;

const std::string chin_forward = "chin:0,5,1,0,0,0", maxilla_forward = "maxilla:0,4,0,0,0,0";

TEST_F(Suggest, AChinTargetRanksTheGenioplastyFirstAndSaysHow)
{
  aim_at({chin_forward});
  const Answer answer = done({"suggest", "case"});
  const json told = suggested();
  const json& best = told.at("suggestions").at(0);
  EXPECT_EQ(best.at("cuts").get<Cuts>(), Cuts{"genioplasty"}) << answer.out;
  EXPECT_GT(best.at("reached"), 0.9);
  const json& chin = best.at("fragments").at(0);
  EXPECT_EQ(chin.at("name"), "chin");
  EXPECT_NEAR(chin.at("translation_mm").at("anterior"), 5, 0.5);
  EXPECT_NEAR(chin.at("translation_mm").at("superior"), 1, 0.5);
  EXPECT_NE(chin.at("movement").get<std::string>().find("mm forward"), std::string::npos);
  for (const char* part : {"genioplasty", "mm forward", "Cannot be combined: le-fort-1 + le-fort-3",
                           "not a medical device"})
    EXPECT_NE(answer.out.find(part), std::string::npos) << part << " is not in\n" << answer.out;
  EXPECT_EQ(told.at("suggestions").size() + told.at("not_possible").size(), 10u);
  for (const json& s : told.at("suggestions"))
    EXPECT_LE(s.at("reached"), 1);

  // what it rests on makes it stale, other steps do not
  done({"mesh", "case"});
  EXPECT_TRUE(fs::exists(dir / "suggest.json"));
  aim_at({maxilla_forward});
  EXPECT_FALSE(fs::exists(dir / "suggest.json"));
}

TEST_F(Suggest, ATargetOfTheMaxillaRanksLeFortOneFirst)
{
  aim_at({maxilla_forward});
  const Answer answer = done({"suggest", "case"});
  const json best = suggested().at("suggestions").at(0);
  EXPECT_EQ(best.at("cuts").get<Cuts>(), Cuts{"le-fort-1"}) << answer.out;
  EXPECT_NEAR(best.at("fragments").at(0).at("translation_mm").at("anterior"), 4, 0.5);
}

TEST_F(Suggest, ATargetOfBothRanksThePairFirstAndAFullSolveConfirmsIt)
{
  aim_at({maxilla_forward, chin_forward});
  const Answer answer = done({"suggest", "case", "--confirm"});
  const json told = suggested();
  const json& best = told.at("suggestions").at(0);
  EXPECT_EQ(best.at("cuts").get<Cuts>(), (Cuts{"genioplasty", "le-fort-1"})) << answer.out;
  EXPECT_NEAR(best.at("confirmed").at("reached").get<double>(), best.at("reached").get<double>(),
              0.05)
      << answer.out;
  EXPECT_TRUE(told.at("suggestions").at(1).contains("confirmed"));
  EXPECT_FALSE(told.at("suggestions").at(2).contains("confirmed"));
  EXPECT_NE(answer.out.find("full solve:"), std::string::npos);
}

TEST_F(Suggest, WhatIsNotPossibleHereIsSaidAndTheRestRanked)
{
  json landmarks = json::parse(read_text(dir / "landmarks.mrk.json"));
  json& points = landmarks["markups"][0]["controlPoints"];
  points.erase(std::find_if(points.begin(), points.end(),
                            [](const json& point) { return point.at("label") == "Go_R"; }));
  write_case(dir, landmarks, "landmarks.mrk.json");
  aim_at({maxilla_forward});
  const Answer answer = done({"suggest", "case", "-q"});
  for (const char* part :
       {"Not possible here: bsso (template 'bsso': the landmark 'Go_R' is not there",
        "Not possible here: genioplasty"})
    EXPECT_NE(answer.out.find(part), std::string::npos) << part << " is not in\n" << answer.out;
  EXPECT_EQ(suggested().at("suggestions").size(), 2u);
}

TEST_F(Suggest, RefusesInOneLine)
{
  expect_refusal({"suggest", dir.string()}, {"target.vtp", "run 'facetobone target'"}, dir);
  aim_at({"chin:0,0,0,0,0,0"});
  expect_refusal({"suggest", dir.string()}, {"target", "no change"}, dir);
  fs::remove(dir / "landmarks.mrk.json");
  expect_refusal({"suggest", dir.string()}, {"no landmarks"}, dir);
  expect_refusal({"suggest", (folder / "nowhere").string()}, {"no such case folder"},
                 folder.path());
  expect_refusal({"suggest", dir.string(), "--density", "nan"}, {"nan", "0.02"}, dir);
}

} // namespace
} // namespace f2b::test
