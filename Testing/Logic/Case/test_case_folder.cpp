#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Case/case_folder.hpp>

#include <chrono>
#include <map>
#include <random>
#include <thread>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace f2b
{
namespace
{

using test::expect_error;
using test::read_text;
using test::TemporaryFolder;
namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

/// Every visible file with its content.
Files visible(const Path& folder)
{
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename().string()[0] != '.')
      files[entry.path().lexically_relative(folder).string()] = read_text(entry.path());
  return files;
}

void commit(CaseFolder& folder, const std::string& step, const Files& files)
{
  CaseChange change(folder);
  for (const auto& [name, text] : files)
    std::ofstream(change.file(name)) << text;
  change.commit(step);
}

/// One file per step, named after it.
void make_case(CaseFolder& folder)
{
  for (const char* step : {"segment", "cut", "mesh", "target", "suggest", "plan", "predict",
                           "report", "export calculix", "export febio", "export vtu"})
    commit(folder, step, {{std::string(step) + ".txt", step}, {"case.json", step}});
}

TEST(CaseFolder, FilesAppearTogetherAtCommit)
{
  const TemporaryFolder temporary;
  CaseFolder folder(temporary.path());
  CaseChange change(folder);
  std::ofstream(change.file("skin.vtp")) << "skin";
  std::ofstream(change.file("pictures/a.png")) << "a";
  EXPECT_TRUE(visible(temporary.path() / ".facetobone-new").count("skin.vtp"));
  EXPECT_FALSE(folder.has("skin.vtp"));
  change.commit("segment");
  EXPECT_EQ(visible(temporary.path()), (Files{{"skin.vtp", "skin"}, {"pictures/a.png", "a"}}));
  EXPECT_FALSE(folder.has(".facetobone-new"));
}

TEST(CaseFolder, DroppedChangeLeavesNothing)
{
  const TemporaryFolder temporary;
  {
    CaseFolder folder(temporary.path());
    CaseChange change(folder);
    std::ofstream(change.file("skin.vtp")) << "skin";
  }
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(CaseFolder, StaleResultsGoAndOthersStay)
{
  const std::map<std::string, std::vector<std::string>> stale = {
      {"segment",
       {"cut", "mesh", "target", "suggest", "plan", "predict", "report", "export calculix",
        "export febio", "export vtu"}},
      {"cut",
       {"mesh", "plan", "predict", "report", "export calculix", "export febio", "export vtu"}},
      {"mesh", {"plan", "predict", "report", "export calculix", "export febio", "export vtu"}},
      {"suggest", {"report"}},
      {"target",
       {"suggest", "plan", "predict", "report", "export calculix", "export febio", "export vtu"}},
      {"plan", {"predict", "report", "export calculix", "export febio", "export vtu"}},
      {"predict", {"report"}},
      {"export calculix", {}},
      {"report", {}}};
  for (const auto& [step, gone] : stale)
  {
    const TemporaryFolder temporary;
    temporary.write("my notes.txt", "mine");
    CaseFolder folder(temporary.path());
    make_case(folder);
    Files expected = visible(temporary.path());
    for (const std::string& name : gone)
      expected.erase(name + ".txt");
    expected.erase(step + ".txt");
    expected["other.txt"] = "new";
    commit(folder, step, {{"other.txt", "new"}});
    EXPECT_EQ(visible(temporary.path()), expected) << step;
    EXPECT_TRUE(folder.has("my notes.txt")) << step;
    EXPECT_TRUE(folder.has("case.json")) << step;
  }
}

TEST(CaseFolder, EmptiedPictureFolderGoesUnlessTheUserHasAFileInIt)
{
  const TemporaryFolder temporary;
  CaseFolder folder(temporary.path());
  commit(folder, "report", {{"pictures/a.png", "a"}});
  commit(folder, "plan", {{"plan.json", "{}"}});
  EXPECT_FALSE(folder.has("pictures"));
  commit(folder, "report", {{"pictures/a.png", "a"}});
  temporary.write("pictures/mine.png", "mine");
  commit(folder, "plan", {{"plan.json", "{}"}});
  EXPECT_EQ(visible(temporary.path()), (Files{{"plan.json", "{}"}, {"pictures/mine.png", "mine"}}));
}

TEST(CaseFolder, UsersFileInTheWayIsNeverOverwritten)
{
  for (const char* name : {"ct.nrrd", "case.json", "pictures"})
  {
    const TemporaryFolder temporary;
    const Path mine = temporary.write(name, "mine");
    CaseFolder folder(temporary.path());
    expect_error(
        [&] {
          commit(folder, "segment",
                 {{"ct.nrrd", "ct"}, {"case.json", "{}"}, {"pictures/a.png", "a"}});
        },
        {mine.string(), "in the way", "another folder"});
    EXPECT_EQ(visible(temporary.path()), (Files{{name, "mine"}}));
    EXPECT_FALSE(folder.has(".facetobone-new"));
  }
}

TEST(CaseFolder, SampleIsNoCaseToOverwrite)
{
  const TemporaryFolder temporary;
  CaseFolder folder(temporary.path());
  const Files sample = {{"ct.nrrd", "sample"}, {"case.json", "sample"}};
  commit(folder, "sample", sample);
  commit(folder, "sample", sample); // repeats safely
  expect_error([&] { folder.require_replaceable(case_file_names(), "segment"); }, {"case.json"});
  expect_error([&] { commit(folder, "segment", {{"ct.nrrd", "ct"}}); }, {"ct.nrrd"});
  EXPECT_EQ(visible(temporary.path()), sample);
}

TEST(CaseFolder, WholeCaseMadeAsideIsCommittedAtOnce)
{
  const TemporaryFolder temporary;
  CaseFolder folder(temporary.path());
  make_case(folder);
  {
    CaseChange whole(folder);
    {
      CaseFolder aside(whole.folder());
      commit(aside, "segment", {{"segment.txt", "2"}, {"case.json", "2"}});
      commit(aside, "cut", {{"cut.txt", "2"}});
      commit(aside, "plan", {{"plan.txt", "2"}});
    }
    EXPECT_EQ(read_text(temporary / "cut.txt"), "cut") << "the old case stays meanwhile";
    whole.commit("segment");
  }
  const Files expected = {
      {"segment.txt", "2"}, {"case.json", "2"}, {"cut.txt", "2"}, {"plan.txt", "2"}};
  EXPECT_EQ(visible(temporary.path()), expected);
  commit(folder, "cut", {{"cut.txt", "3"}});
  EXPECT_FALSE(folder.has("plan.txt")) << "the ledger knows who made it";
}

TEST(CaseFolder, JournalOfAKilledProcessIsFinished)
{
  const TemporaryFolder temporary;
  {
    CaseFolder folder(temporary.path());
    make_case(folder);
  }
  // killed after one of two files was put in place
  temporary.write("cut.txt", "new");
  temporary.write(".facetobone-new/mesh.txt", "new");
  temporary.write(".facetobone-new/COMMIT",
                  R"({"install": ["cut.txt", "mesh.txt"], "remove": ["plan.txt", "report.txt"]})");
  const CaseFolder folder(temporary.path());
  EXPECT_EQ(read_text(temporary / "cut.txt"), "new");
  EXPECT_EQ(read_text(temporary / "mesh.txt"), "new");
  EXPECT_FALSE(folder.has("plan.txt"));
  EXPECT_FALSE(folder.has("report.txt"));
  EXPECT_TRUE(folder.has("target.txt"));
  EXPECT_FALSE(folder.has(".facetobone-new"));
}

TEST(CaseFolder, HalfMadeFilesOfAKilledProcessAreDropped)
{
  const TemporaryFolder temporary;
  temporary.write("skin.vtp", "old");
  temporary.write(".facetobone-new/skin.vtp", "half");
  temporary.write(".facetobone-new/journal.new", "{\"install\": [\"skin");
  const CaseFolder folder(temporary.path());
  EXPECT_EQ(visible(temporary.path()), (Files{{"skin.vtp", "old"}}));
  EXPECT_FALSE(folder.has(".facetobone-new"));
}

/// Commits versions of a case of eight files until it is killed.
[[noreturn]] void commit_for_ever(const Path& path)
{
  for (int version = 0;; ++version)
  {
    CaseFolder folder(path);
    Files files;
    for (int i = 0; i < 8; ++i)
      files["file" + std::to_string(i)] = std::to_string(version);
    commit(folder, "segment", files);
  }
}

TEST(CaseFolder, KilledAtAnyMomentItIsWholeWhenOpenedAgain)
{
  const TemporaryFolder temporary;
  std::mt19937 random(4711);
  for (int kill_number = 0; kill_number < 25; ++kill_number)
  {
    const Path path = temporary / std::to_string(kill_number);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0)
    {
      try
      {
        commit_for_ever(path);
      }
      catch (const std::exception&)
      {
        _exit(1);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(2000 + random() % 30000));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it should commit until it is killed";
    {
      const CaseFolder folder(path); // finishes or drops
    }
    const Files files = fs::exists(path) ? visible(path) : Files{};
    EXPECT_TRUE(files.empty() || files.size() == 8) << files.size();
    for (const auto& [name, version] : files)
      EXPECT_EQ(version, files.begin()->second) << name;
  }
}

TEST(CaseFolder, OneProcessAtATime)
{
  const TemporaryFolder temporary;
  {
    const CaseFolder mine(temporary.path());
    expect_error([&] { CaseFolder other(temporary.path()); },
                 {temporary.path().string(), "another FaceToBone"});
  }
  EXPECT_NO_THROW(CaseFolder(temporary.path()));
}

TEST(CaseFolder, FoldersThatStayEmptyAreRemovedAgain)
{
  const TemporaryFolder temporary;
  {
    const CaseFolder folder(temporary / "a/b/c/");
    EXPECT_TRUE(fs::is_directory(temporary / "a/b/c"));
  }
  EXPECT_TRUE(fs::is_empty(temporary.path()));
  fs::create_directory(temporary / "mine");
  {
    const CaseFolder folder(temporary / "mine");
  }
  EXPECT_TRUE(fs::is_empty(temporary / "mine")) << "the user's empty folder stays, and stays empty";
}

TEST(CaseFolder, PlacesThatCannotHoldACaseAreNamed)
{
  const TemporaryFolder temporary;
  const Path file = temporary.write("file", "x");
  expect_error([&] { CaseFolder folder(file); }, {file.string(), "not a folder"});
  expect_error([&] { CaseFolder folder(file / "deeper"); }, {file.string(), "cannot be made"});
  expect_error([] { CaseFolder folder("/proc/facetobone/case"); },
               {"/proc/facetobone/case", "cannot be made"});
  expect_error([] { CaseFolder folder(""); }, {"cannot be made"});
  EXPECT_EQ(visible(temporary.path()), (Files{{"file", "x"}}));
}

TEST(CaseFolder, ReadOnlyFolderIsNamedAndLeftAlone)
{
  const TemporaryFolder temporary;
  fs::permissions(temporary.path(), fs::perms(0555));
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0)
  {
    if (geteuid() == 0 && setuid(65534) != 0)
      _exit(77);
    try
    {
      CaseFolder folder(temporary.path());
    }
    catch (const Error& error)
    {
      _exit(std::string(error.what()).find("read-only; choose") != std::string::npos ? 0 : 2);
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(fs::is_empty(temporary.path()));
  fs::permissions(temporary.path(), fs::perms(0755));
}

TEST(CaseFolder, MissingResultNamesTheStepThatMakesIt)
{
  const TemporaryFolder temporary;
  const CaseFolder folder(temporary.path());
  expect_error([&] { (void)folder.require("mesh.vtu", "mesh"); },
               {temporary.path().string(), "mesh.vtu", "facetobone mesh"});
  expect_error([&] { (void)folder.require("skin.vtp", "segment"); },
               {"skin.vtp", "facetobone segment CASE.json -o"});
}

TEST(CaseFolder, DamagedLedgerIsNamed)
{
  const TemporaryFolder temporary;
  temporary.write(".facetobone-files.json", R"({"cut": 3})");
  CaseFolder folder(temporary.path());
  expect_error([&] { commit(folder, "cut", {{"cut.txt", "1"}}); }, {".facetobone-files.json"});
}

} // namespace
} // namespace f2b
