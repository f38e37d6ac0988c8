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

/// How far points of the face should go forwards [mm]; those that are not named stay.
using Wish = std::map<std::string, double>;

/// Two files of fiducials: points of the sample's face, and where they should go.
std::pair<Path, Path> write_wish(const Path& folder, const Wish& wish)
{
  json from = json::parse(read_text(coarse_sample() / "landmarks.mrk.json"));
  json& points = from["markups"][0]["controlPoints"];
  const std::vector<std::string> on_skin = {"N'", "Or'_R", "Or'_L", "prn", "sn", "ls",
                                            "li", "ch_R",  "ch_L",  "Pg'", "Me'"};
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const json& point)
                              {
                                const std::string label = point.at("label");
                                return std::count(on_skin.begin(), on_skin.end(), label) == 0;
                              }),
               points.end());
  json to = from;
  for (json& point : to["markups"][0]["controlPoints"])
    if (const auto asked = wish.find(point.at("label").get<std::string>()); asked != wish.end())
      point["position"][1] = point["position"][1].get<double>() - asked->second; // LPS
  return {write_case(folder, from, "from.mrk.json"), write_case(folder, to, "to.mrk.json")};
}

const Wish chin_forward = {{"Pg'", 5}, {"Me'", 5}};
const Wish upper_lip_forward = {{"prn", 3}, {"sn", 5}, {"ls", 5}, {"ch_R", 3}, {"ch_L", 3}};

Wish both(Wish a, const Wish& b)
{
  a.insert(b.begin(), b.end());
  return a;
}

/// The coarse case with all of the chin, segmented; made once, copied for each test.
const Path& segmented_case()
{
  static const Path folder = []
  {
    const Path dir = scratch_folder() / "segmented";
    json document = coarse_case();
    document["region_ras"] = {{"min", {-70, -5, -134}}, {"max", {70, 115, 10}}};
    const Path file = write_case(scratch_folder(), document);
    EXPECT_EQ(run_program({"segment", file.string(), "-o", dir.string()}).exit_code, 0);
    return dir;
  }();
  return folder;
}

struct Suggest : ::testing::Test
{
  Suggest() { fs::copy(segmented_case(), dir, fs::copy_options::recursive); }

  Answer done(const Arguments& arguments) const
  {
    const Answer answer = run_program(arguments, folder.path());
    EXPECT_EQ(answer.exit_code, 0) << arguments[0] << ": " << answer.err;
    EXPECT_EQ(answer.err, "");
    return answer;
  }

  void wish_for(const Wish& wish) const
  {
    const auto [from, to] = write_wish(folder.path(), wish);
    done({"target", "case", "--warp-from", from.string(), "--warp-to", to.string(), "--warp-radius",
          "60"});
  }

  json suggested() const { return json::parse(read_text(dir / "suggest.json")); }

  const TemporaryFolder folder;
  const Path dir = folder / "case";
};

using Cuts = std::vector<std::string>;

TEST_F(Suggest, AChinTargetRanksTheGenioplastyFirstAndSaysHow)
{
  wish_for(chin_forward);
  const Answer answer = done({"suggest", "case"});
  const json told = suggested();
  const json& best = told.at("suggestions").at(0);
  EXPECT_EQ(best.at("cuts").get<Cuts>(), Cuts{"genioplasty"}) << answer.out;
  EXPECT_GT(best.at("reached"), 0.5);
  const json& chin = best.at("fragments").at(0);
  EXPECT_EQ(chin.at("name"), "chin");
  EXPECT_GT(chin.at("translation_mm").at("anterior"), 2);
  EXPECT_LT(chin.at("translation_mm").at("anterior"), 10);
  EXPECT_NE(chin.at("movement").get<std::string>().find("mm forward"), std::string::npos);
  for (const char* part : {"genioplasty", "mm forward", "Cannot be combined: le-fort-1 + le-fort-3",
                           "not a medical device"})
    EXPECT_NE(answer.out.find(part), std::string::npos) << part << " is not in\n" << answer.out;
  EXPECT_EQ(told.at("suggestions").size() + told.at("not_possible").size(), 10u);
  for (const json& s : told.at("suggestions"))
    EXPECT_LE(s.at("reached"), 1);

  // what it rests on makes it stale, other steps do not
  done({"cut", "case"});
  EXPECT_TRUE(fs::exists(dir / "suggest.json"));
  wish_for(upper_lip_forward);
  EXPECT_FALSE(fs::exists(dir / "suggest.json"));
}

TEST_F(Suggest, AnUpperLipTargetRanksALeFortFirst)
{
  wish_for(upper_lip_forward);
  const Answer answer = done({"suggest", "case"});
  const json best = suggested().at("suggestions").at(0);
  ASSERT_EQ(best.at("cuts").size(), 1u) << answer.out;
  EXPECT_EQ(best.at("cuts").at(0).get<std::string>().substr(0, 7), "le-fort") << answer.out;
  EXPECT_GT(best.at("fragments").at(0).at("translation_mm").at("anterior"), 1);
}

TEST_F(Suggest, ATargetOfLipAndChinRanksAPairFirstAndAFullSolveConfirmsIt)
{
  wish_for(both(upper_lip_forward, chin_forward));
  const Answer answer = done({"suggest", "case", "--confirm"});
  const json told = suggested();
  const json& best = told.at("suggestions").at(0);
  const Cuts cuts = best.at("cuts");
  ASSERT_EQ(cuts.size(), 2u) << answer.out;
  EXPECT_EQ(cuts[0], "genioplasty") << answer.out;
  EXPECT_EQ(cuts[1].substr(0, 7), "le-fort") << answer.out;
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
  wish_for(upper_lip_forward);
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
  wish_for({});
  expect_refusal({"suggest", dir.string()}, {"target", "no change"}, dir);
  fs::remove(dir / "landmarks.mrk.json");
  expect_refusal({"suggest", dir.string()}, {"no landmarks"}, dir);
  expect_refusal({"suggest", (folder / "nowhere").string()}, {"no such case folder"},
                 folder.path());
  expect_refusal({"suggest", dir.string(), "--density", "nan"}, {"nan", "0.02"}, dir);
}

} // namespace
} // namespace f2b::test
