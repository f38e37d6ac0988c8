#include "CommandLine/coarse_case.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace f2b::test
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

/// The visible files of a folder, with their contents.
std::map<std::string, std::string> results(const Path& folder)
{
  auto files = snapshot(folder);
  for (auto file = files.begin(); file != files.end();)
    file = file->first[0] == '.' ? files.erase(file) : std::next(file);
  return files;
}

json read(const Path& file)
{
  return json::parse(read_text(file));
}

/// A plan without what may differ from one run to the next.
json lasting(json plan)
{
  plan.erase("timing_s");
  plan.erase("peak_rss_mb");
  return plan;
}

bool has_control_characters(const std::string& text)
{
  return std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return c < ' ' && c != '\n'; });
}

/// The coarse case, made by `run`; once.
struct FinishedRun
{
  Path case_file = write_case(scratch_folder(), coarse_case());
  Path folder = scratch_folder() / "run";
  Answer answer = run_program({"run", case_file.string(), "-o", folder.string()});
};
const FinishedRun& finished_run()
{
  static const FinishedRun run;
  return run;
}

TEST(WholeWay, RunPrintsThePlanAndNothingElse)
{
  const Answer& answer = finished_run().answer;
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.err, "");
  EXPECT_FALSE(has_control_characters(answer.out));
  for (const char* part : {"Movement of the bone fragments, rigid-fit", "virtual-force", "mid-face",
                           "What these cuts reach", "Overjet", "not a medical device"})
    EXPECT_NE(answer.out.find(part), std::string::npos) << part;
  EXPECT_NE(
      answer.out.find("Report: " + (fs::canonical(finished_run().folder) / "report.html").string()),
      std::string::npos)
      << answer.out;
}

TEST(WholeWay, RunLeavesTheStatedFilesAndNoOthers)
{
  const auto files = results(finished_run().folder);
  for (const char* name :
       {"case.json", "plan.json", "report.html", "skin.vtp", "bone.vtp", "target.vtp", "mesh.vtu",
        "fragment_mid-face.vtp", "predicted_rigid-fit.vtp", "predicted_virtual-force.vtp",
        "mid-face_rigid-fit.tfm", "mid-face_rigid-fit.h5", "mid-face_virtual-force.tfm",
        "cuts.mrk.json", "landmarks.mrk.json", "uncut_bone.vtp"})
    EXPECT_EQ(files.count(name), 1u) << name;
  EXPECT_FALSE(fs::exists(finished_run().folder / ".facetobone-new"));
  EXPECT_GE(std::count_if(files.begin(), files.end(),
                          [](const auto& file) { return Path(file.first).extension() == ".png"; }),
            3);
}

TEST(WholeWay, PlanHoldsWhatIsPromised)
{
  const json plan = read(finished_run().folder / "plan.json");
  for (const char* key : {"prisms", "tets", "nodes", "dofs", "min_dihedral_deg"})
    EXPECT_TRUE(plan.at("mesh").at(key).is_number()) << key;
  for (const char* method : {"rigid-fit", "virtual-force"})
  {
    const json& m = plan.at("methods").at(method);
    const json& fragment = m.at("fragments").at(0);
    EXPECT_EQ(fragment.at("name"), "mid-face");
    EXPECT_EQ(fragment.at("matrix_ras").size(), 16u);
    EXPECT_EQ(fragment.at("reference_point_ras").size(), 3u);
    for (const char* key : {"right", "anterior", "superior"})
      EXPECT_TRUE(fragment.at("translation_mm").at(key).is_number()) << key;
    for (const char* key : {"pitch", "roll", "yaw"})
      EXPECT_TRUE(fragment.at("rotation_deg").at(key).is_number()) << key;
    for (const char* key : {"mean", "sd", "variance", "median", "p90", "p95", "max", "under_1mm",
                            "under_2mm", "signed_mean"})
      EXPECT_TRUE(m.at("skin_error_mm").at(key).is_number()) << key;
    for (const char* region : {"nose", "upper_lip", "chin"})
      EXPECT_TRUE(m.at("skin_error_mm").at("by_region").at(region).at("mean").is_number())
          << region;
    const json& contact = m.at("bone_contacts").at(0);
    EXPECT_EQ(contact.at("between"), json({"mid-face", "uncut bone"}));
    EXPECT_GT(contact.at("gap").at("cut_mm2"), 0);
    EXPECT_TRUE(contact.at("overlap").at("depth_mm").is_number());
    EXPECT_TRUE(plan.at("bite").at(method).at("overjet_mm").is_number());
  }
  EXPECT_EQ(plan.at("bite").at("landmarks_ride_on").at("U1"), "mid-face");
  EXPECT_EQ(plan.at("bite").at("landmarks_ride_on").at("L1"), "uncut bone");
  EXPECT_GE(plan.at("reachability").at("sentences").size(), 1u);
  EXPECT_TRUE(plan.at("reachability").at("regions").at("nose").at("left_mm").at("p90").is_number());
  EXPECT_TRUE(plan.at("methods").at("virtual-force").contains("load_residual_mm"));
  EXPECT_FALSE(plan.at("methods").at("rigid-fit").contains("load_residual_mm"));
  for (const char* key : {"segment", "mesh", "plan", "total"})
    EXPECT_TRUE(plan.at("timing_s").at(key).is_number()) << key;
  EXPECT_GT(plan.at("peak_rss_mb"), 0);
  EXPECT_EQ(plan.at("schema"), "facetobone-plan/1");
}

TEST(WholeWay, SampleIsReproducible)
{
  const TemporaryFolder folder;
  ASSERT_EQ(
      run_program({"sample", "--spacing", "2.5", "--out", (folder / "again").string()}).exit_code,
      0);
  auto first = results(coarse_sample());
  EXPECT_TRUE(results(folder / "again") == first);
  for (const char* name :
       {"case.json", "ct.nrrd", "landmarks.mrk.json", "true_skin.vtp", "true_bone.vtp"})
    EXPECT_EQ(first.count(name), 1u) << name;
}

/// The verbs one by one over a case, in a folder with a file of the user's own.
TEST(WholeWay, VerbsInOrderGiveTheRunsPlanAndStaleResultsGo)
{
  const TemporaryFolder folder;
  const Path dir = folder / "case";
  folder.write("case/my notes.txt", "mine");
  auto done = [&](const Arguments& arguments)
  {
    const Answer answer = run_program(arguments, folder.path());
    EXPECT_EQ(answer.exit_code, 0) << arguments[0] << ": " << answer.err;
    EXPECT_EQ(answer.err, "") << arguments[0];
    EXPECT_FALSE(has_control_characters(answer.out)) << arguments[0];
    return answer;
  };
  done({"segment", finished_run().case_file.string(), "-o", "case"});
  for (const char* verb : {"cut", "mesh", "target", "plan"})
    done({verb, "case"});
  EXPECT_EQ(lasting(read(dir / "plan.json")), lasting(read(finished_run().folder / "plan.json")));
  done({"predict", "case"});
  const json by_plan = read(dir / "predict.json");
  EXPECT_TRUE(fs::exists(dir / "predicted.vtp"));
  EXPECT_TRUE(fs::exists(dir / "mid-face_moved.vtp"));
  done({"predict", "case", "--movement", "mid-face:0,1,0,0,0,0", "-q"});
  EXPECT_EQ(
      read(dir / "case.json").at("predict").at("mid-face").at("translation_mm").at("anterior"), 1);

  done({"cut", "case"});
  for (const char* stale :
       {"mesh.vtu", "plan.json", "predicted.vtp", "mid-face_rigid-fit.tfm", "report.html"})
    EXPECT_FALSE(fs::exists(dir / stale)) << stale;
  for (const char* kept :
       {"skin.vtp", "target.vtp", "case.json", "my notes.txt", "fragment_mid-face.vtp"})
    EXPECT_TRUE(fs::exists(dir / kept)) << kept;
  expect_refusal({"report", dir.string()}, {"plan.json", "facetobone plan"}, dir);
  done({"mesh", "case"});
  done({"target", "case", "--movement", "mid-face:0,1,0,0,0,0"});
  EXPECT_EQ(read(dir / "target.json").at("kind"), "from_movement");
  EXPECT_NEAR(read(dir / "target.json").at("peak_displacement_mm").get<double>(), 1, 0.3);
}

TEST(WholeWay, KilledRunsLeaveThePreviousResultsWhole)
{
  ASSERT_EQ(finished_run().answer.exit_code, 0);
  const TemporaryFolder folder;
  const Path dir = folder / "results";
  fs::copy(finished_run().folder, dir, fs::copy_options::recursive);
  const auto before = results(dir);
  json other = coarse_case();
  other["skin_thickness_mm"] = 1.3;
  const Path file = write_case(folder.path(), other);
  std::mt19937 random(20);
  int killed = 0;
  for (int attempt = 0; attempt < 5; ++attempt)
  {
    killed += run_and_kill({"run", file.string(), "-o", dir.string()},
                           200 + static_cast<int>(random() % 5000));
    EXPECT_TRUE(results(dir) == before) << "attempt " << attempt;
  }
  EXPECT_EQ(killed, 5) << "no run was quick enough to end";
  // the next command tidies up
  EXPECT_EQ(run_program({"cut", dir.string()}).exit_code, 0);
  EXPECT_FALSE(fs::exists(dir / ".facetobone-new"));
  EXPECT_FALSE(fs::exists(dir / "mesh.vtu"));
  EXPECT_EQ(read_text(dir / "skin.vtp"), before.at("skin.vtp"));
}

TEST(WholeWay, ASecondProcessIsKeptOut)
{
  const TemporaryFolder folder;
  ASSERT_EQ(finished_run().answer.exit_code, 0);
  const Path dir = finished_run().folder;
  // a shell holds the folder's lock while facetobone tries
  const std::string command = "flock -n '" + dir.string() + "' '" FACETOBONE_PROGRAM "' cut '" +
                              dir.string() + "' 2> '" + (folder / "err").string() + "'";
  const int status = std::system(command.c_str());
  if (WEXITSTATUS(status) == 127)
    GTEST_SKIP() << "no flock here";
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(read_text(folder / "err").find("another FaceToBone"), std::string::npos);
}

} // namespace
} // namespace f2b::test
