#include "Bridge/vtk_surface.hpp"
#include "CommandLine/coarse_case.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <unistd.h>

namespace f2b::test
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

/// A name that is hard to print: markup, quotes, an emoji, Hebrew.
const std::string hostile_name =
    "<b>\"O'Neil\"</b> & \xf0\x9f\x99\x82 \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d";

json read(const Path& file)
{
  return json::parse(read_text(file));
}

/// A coarse case, planned and reported once, in a folder that stays for the browser's test.
struct PlannedCase
{
  Path folder = COARSE_REPORT;
  Answer answer;

  PlannedCase()
  {
    json document = coarse_case();
    document["name"] = hostile_name;
    document["notes"] = "seen by nobody";
    document["mesh"]["density"] = 0.2; // fewer load steps than on a still coarser mesh
    document["solver"]["step_tolerance_mm"] = 1e-8;
    fs::remove_all(folder);
    answer = run_program(
        {"run", write_case(scratch_folder(), document).string(), "-o", folder.string(), "-q"});
  }
};
const PlannedCase& planned_case()
{
  static const PlannedCase planned;
  return planned;
}

/// The planned case once more, to be changed.
Path copy_of_case(const TemporaryFolder& folder, const char* name)
{
  fs::copy(planned_case().folder, folder / name, fs::copy_options::recursive);
  return folder / name;
}

/// What a JSON Schema of ours finds in a document; empty if nothing.
std::string faults(const json& document, const char* schema_name)
{
  valijson::Schema schema;
  const json text = read(Path(FACETOBONE_SCHEMAS) / schema_name);
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::ValidationResults results;
  valijson::Validator validator;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results))
    return {};
  std::string found = "does not hold";
  valijson::ValidationResults::Error fault;
  while (results.popError(fault))
  {
    for (const std::string& part : fault.context)
      found += part;
    found += ": " + fault.description + "\n";
  }
  return found;
}

/// Processes that have a variable of this test in their environment.
int processes_with(const std::string& mark)
{
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc"))
  {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        name != std::to_string(::getpid()) &&
        read_text(entry.path() / "environ").find(mark) != std::string::npos)
      ++count;
  }
  return count;
}

TEST(Report, RunEndsWithAReportOfAllKinds)
{
  const PlannedCase& planned = planned_case();
  ASSERT_EQ(planned.answer.exit_code, 0) << planned.answer.err;
  for (const char* name :
       {"report.html", "report.json", "tables/movements.csv", "tables/cephalometry.csv",
        "pictures/distance_map.png", "pictures/ct_slices.png", "pictures/contact_surfaces.png"})
    EXPECT_TRUE(fs::exists(planned.folder / name)) << name;
  const std::string pdf = read_text(planned.folder / "report.pdf");
  EXPECT_EQ(pdf.compare(0, 5, "%PDF-"), 0);
  EXPECT_EQ(pdf.find("/JavaScript"), std::string::npos);
}

/// What another program prints; nothing where it is not installed.
std::string printed_by(const std::string& command)
{
  std::string text;
  if (FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r"))
  {
    char part[4096];
    while (const std::size_t count = std::fread(part, 1, sizeof part, pipe))
      text.append(part, count);
    ::pclose(pipe);
  }
  return text;
}

Answer without_weasyprint_and_three_js(const TemporaryFolder& folder, const Arguments& arguments)
{
  fs::create_directory(folder / "bin");
  for (const char* name : {"Xvfb", "xkbcomp"})
    if (fs::exists(Path("/usr/bin") / name))
      fs::create_symlink(Path("/usr/bin") / name, folder.path() / "bin" / name);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder / "bin").c_str(), 1);
  ::setenv("FACETOBONE_THREE_JS", "/nowhere", 1);
  const Answer answer = run_program(arguments);
  ::setenv("PATH", path.c_str(), 1);
  ::unsetenv("FACETOBONE_THREE_JS");
  return answer;
}

TEST(Report, PdfHasItsFontsPageNumbersUnitsAndNames)
{
  const std::string pdf = "'" + (planned_case().folder / "report.pdf").string() + "'";
  const std::string text = printed_by("pdftotext -layout " + pdf + " -");
  if (text.empty())
    GTEST_SKIP() << "no pdftotext here";
  const std::string pages = std::to_string(std::count(text.begin(), text.end(), '\f'));
  for (const std::string& part :
       {"1 / " + pages, pages + " / " + pages, std::string("[mm]"), std::string("[\u00b0]"),
        std::string("O'Neil"), std::string("not a medical device")})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  std::istringstream fonts(printed_by("pdffonts " + pdf));
  int count = 0;
  for (std::string line; std::getline(fonts, line);)
    if (line.find("TrueType") != std::string::npos || line.find("Type") != std::string::npos)
      count += line.find(" yes ") != std::string::npos;
  EXPECT_GE(count, 2);
}

TEST(Report, JsonHoldsWhatItsSchemasPromise)
{
  const Path& folder = planned_case().folder;
  EXPECT_EQ(faults(read(folder / "plan.json"), "plan.schema.json"), "");
  EXPECT_EQ(faults(read(folder / "report.json"), "report.schema.json"), "");
  json plan = read(folder / "plan.json");
  plan["methods"]["rigid-fit"]["fragments"][0]["matrix_ras"].erase(0);
  EXPECT_NE(faults(plan, "plan.schema.json"), "") << "the schema is not empty";
}

TEST(Report, TablesHoldThePlansNumbersInFull)
{
  const json plan = read(planned_case().folder / "plan.json");
  const json report = read(planned_case().folder / "report.json");
  const double anterior =
      plan["methods"]["rigid-fit"]["fragments"][0]["translation_mm"]["anterior"];
  bool found = false;
  for (const json& table : report.at("tables"))
    if (table.at("id") == "movements")
    {
      EXPECT_EQ(table.at("columns").at(3).at("key"), "anterior");
      EXPECT_EQ(table.at("rows").at(0).at(3), anterior);
      found = true;
    }
  EXPECT_TRUE(found);
  const std::string csv = read_text(planned_case().folder / "tables/movements.csv");
  EXPECT_NE(csv.find("," + json(anterior).dump() + ","), std::string::npos) << csv;
}

TEST(Report, CephalometryFollowsTheBoneAndTheFace)
{
  const json report = read(planned_case().folder / "report.json");
  std::map<std::string, json> measures;
  for (const json& m : report.at("cephalometry"))
    measures[m.at("name")] = m;
  const json& convexity = measures.at("convexity"); // A rides on the mid-face, N and Pg do not
  EXPECT_GT(convexity.at("predicted").get<double>(), convexity.at("before").get<double>() + 0.5);
  EXPECT_FALSE(convexity.contains("target")) << "a target is a face, not bone";
  EXPECT_TRUE(measures.at("E line to ls").contains("target"));
  for (const char* name : {"SNA", "ANB"}) // S and N stay, A goes forwards
    EXPECT_GT(measures.at(name).at("predicted").get<double>(),
              measures.at(name).at("before").get<double>() + 0.5);
  EXPECT_EQ(measures.size(), 20U) << "the virtual patient lacks no landmark";
}

TEST(Report, NamesAreTextAndThePatientsAreLeftOut)
{
  const std::string html = read_text(planned_case().folder / "report.html");
  EXPECT_EQ(html.find("<b>\"O"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;&quot;O&#39;Neil&quot;&lt;/b&gt; &amp; \xf0\x9f\x99\x82"),
            std::string::npos);
  EXPECT_EQ(html.find("seen by nobody"), std::string::npos);
  EXPECT_EQ(html.find("ct.nrrd</bdi></td>"), std::string::npos) << "the scan's own name";
}

/// What the landmarks do not allow is said, and a method that failed is left out.
TEST(Report, TellsWhatIsMissing)
{
  const TemporaryFolder folder;
  const Path dir = copy_of_case(folder, "case");
  json plan = read(dir / "plan.json");
  plan["cephalometry"]["left_out"] = {"SNA", "SNB"};
  plan["cephalometry"]["missing_landmarks"] = {"S"};
  plan["patient_frame"] = {{"missing_landmarks", {"Po_R", "Po_L"}}};
  plan["methods"].erase("virtual-force");
  fs::remove(dir / "plan_virtual-force.vtu");
  plan["methods_failed"] = {{"virtual-force", "no equilibrium"}};
  plan["warnings"].push_back("virtual-force gives no plan: no equilibrium");
  EXPECT_EQ(faults(plan, "plan.schema.json"), "");
  std::ofstream(dir / "plan.json") << plan;
  const Answer answer = without_weasyprint_and_three_js(folder, {"report", dir.string(), "-q"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const std::string html = read_text(dir / "report.html");
  for (const char* said :
       {"For want of the landmarks S these are left out: SNA, SNB.",
        "need the landmarks Po_R, Po_L", "virtual-force gives no plan: no equilibrium",
        "install the Debian package weasyprint", "data:image/png"})
    EXPECT_NE(html.find(said), std::string::npos) << said;
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_FALSE(fs::exists(dir / "report.pdf")) << "a stale one";
  EXPECT_FALSE(fs::exists(dir / "pictures/contact_surfaces.png")) << "a stale one";
  std::ofstream(dir / "plan.json") << R"({"methods": {}})";
  expect_refusal({"report", dir.string()}, {"plan.json", "facetobone plan"}, dir);
  std::ofstream(dir / "plan.json") << "[]";
  expect_refusal({"report", dir.string()}, {"plan.json", "array, not an object"}, dir);
}

TEST(Report, ChecksumsAreThoseOfTheInputs)
{
  const json inputs = read(planned_case().folder / "plan.json").at("inputs");
  std::map<std::string, std::string> sums;
  for (const json& input : inputs)
    sums[input.at("input")] = input.at("sha256");
  const std::string scan = "'" + (coarse_sample() / "ct.nrrd").string() + "'";
  EXPECT_EQ(sums.at("scan"), printed_by("sha256sum " + scan).substr(0, 64));
  EXPECT_EQ(sums.count("landmarks") + sums.count("target"), 2U);
  const std::string html = read_text(planned_case().folder / "report.html");
  EXPECT_NE(html.find(sums.at("scan")), std::string::npos);
  const std::string mesh = "'" + (planned_case().folder / "mesh.vtu").string() + "'";
  EXPECT_NE(html.find(printed_by("sha256sum " + mesh).substr(0, 64)), std::string::npos);
}

TEST(Report, TwoAtOnceAreEqualBitForBitAndLeaveNothing)
{
  const TemporaryFolder folder;
  const Path first = copy_of_case(folder, "first"), second = copy_of_case(folder, "second");
  fs::create_directory(folder / "tmp");
  const std::string mark = "FACETOBONE_TEST_MARK=" + std::to_string(::getpid());
  ::setenv("FACETOBONE_TEST_MARK", std::to_string(::getpid()).c_str(), 1);
  ::setenv("TMPDIR", (folder / "tmp").c_str(), 1);
  ::unsetenv("DISPLAY");
  Answer other;
  std::thread beside([&] { other = run_program({"report", second.string(), "-q"}); });
  const Answer answer = run_program({"report", first.string(), "-q"});
  beside.join();
  ::unsetenv("TMPDIR");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_EQ(processes_with(mark), 0);
  EXPECT_TRUE(fs::is_empty(folder / "tmp"));
  for (const auto& picture : fs::directory_iterator(first / "pictures"))
  {
    const std::string name = picture.path().filename().string();
    EXPECT_EQ(read_text(picture.path()), read_text(second / "pictures" / name)) << name;
    EXPECT_EQ(read_text(picture.path()), read_text(planned_case().folder / "pictures" / name))
        << name;
  }
}

TEST(Report, KilledLeavesNoProcessNoFileAndThePreviousReport)
{
  const TemporaryFolder folder;
  const Path dir = copy_of_case(folder, "case");
  const auto before = snapshot(dir);
  fs::create_directory(folder / "tmp");
  const std::string mark = "FACETOBONE_KILL_MARK=" + std::to_string(::getpid());
  ::setenv("FACETOBONE_KILL_MARK", std::to_string(::getpid()).c_str(), 1);
  ::setenv("TMPDIR", (folder / "tmp").c_str(), 1);
  for (const int after_ms : {700, 2500})
  {
    EXPECT_TRUE(run_and_kill({"report", dir.string()}, after_ms));
    EXPECT_EQ(processes_with(mark), 0);
    EXPECT_TRUE(snapshot(dir) == before) << "not even a hidden file";
    EXPECT_TRUE(fs::is_empty(folder / "tmp"));
  }
  ::unsetenv("TMPDIR");
}

/// The coordinates of a text STL's vertices, in its file's frame.
std::vector<Vec3> stl_vertices(const Path& file)
{
  std::istringstream words(read_text(file));
  std::vector<Vec3> points;
  for (std::string word; words >> word;)
    if (word == "vertex")
    {
      Vec3 p;
      words >> p.x() >> p.y() >> p.z();
      points.push_back(p);
    }
  return points;
}

TEST(Report, StlIsTheRestFragmentMovedByTheReportedMatrix)
{
  const TemporaryFolder folder;
  const Answer answer = run_program({"export", planned_case().folder.string(), "--format", "stl",
                                     "-o", (folder / "print").string(), "-q"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const auto rest = stl_vertices(folder / "print/mid-face_rest.stl");
  const auto planned = stl_vertices(folder / "print/mid-face_planned.stl");
  ASSERT_GT(rest.size(), 1000u);
  ASSERT_EQ(rest.size(), planned.size());
  const json m = read(planned_case().folder /
                      "plan.json")["methods"]["rigid-fit"]["fragments"][0]["matrix_ras"];
  auto entry = [&](int r, int c) { return m[static_cast<std::size_t>(4 * r + c)].get<double>(); };
  double worst = 0, largest_move = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
  {
    const Vec3 p(-rest[i].x(), -rest[i].y(), rest[i].z()); // LPS in the file, RAS in the matrix
    Vec3 moved;
    for (int r = 0; r < 3; ++r)
      moved[r] = entry(r, 0) * p.x() + entry(r, 1) * p.y() + entry(r, 2) * p.z() + entry(r, 3);
    const Vec3 told(-planned[i].x(), -planned[i].y(), planned[i].z());
    worst = std::max(worst, (moved - told).norm());
    largest_move = std::max(largest_move, (moved - p).norm());
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_GT(largest_move, 0.5);
}

TEST(Report, PlyHoldsTheSameFragmentAsTheCase)
{
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"export", planned_case().folder.string(), "--format", "ply", "-o",
                         folder.path().string(), "-q"})
                .exit_code,
            0);
  const auto told = points_of(read_surface(folder / "mid-face_rest.ply"));
  const auto mine = points_of(read_surface(planned_case().folder / "fragment_mid-face.vtp"));
  ASSERT_EQ(told.size(), mine.size());
  for (std::size_t i = 0; i < told.size(); ++i)
    ASSERT_LT((told[i] - mine[i]).norm(), 2e-5) << "VTK reads single precision";
}

TEST(Report, TheJsonsMovementGivesThePredictedFaceAgain)
{
  const TemporaryFolder folder;
  const Path dir = copy_of_case(folder, "case");
  const json f = read(dir / "plan.json")["methods"]["rigid-fit"]["fragments"][0];
  std::string movement = "mid-face:";
  const json &t = f["translation_mm"], &r = f["rotation_deg"];
  for (const json& value :
       {t["right"], t["anterior"], t["superior"], r["pitch"], r["roll"], r["yaw"]})
    movement += (movement.back() == ':' ? "" : ",") + value.dump();
  const Answer answer = run_program({"predict", dir.string(), "--movement", movement, "-q"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(faults(read(dir / "predict.json"), "predict.schema.json"), "");
  const auto again = points_of(read_surface(dir / "predicted.vtp"));
  const auto planned = points_of(read_surface(dir / "predicted_rigid-fit.vtp"));
  double worst = 0;
  for (std::size_t i = 0; i < again.size(); ++i)
    worst = std::max(worst, (again[i] - planned[i]).norm());
  EXPECT_LT(worst, 1e-6);
}

TEST(Screenshot, DrawsWhatItIsAskedForAndRefusesTheRest)
{
  const TemporaryFolder folder;
  const std::string dir = planned_case().folder.string();
  const Path picture = folder / "x.png";
  ASSERT_EQ(run_program({"screenshot", dir + "/plan.json", "--show", "fragments-after", "--view",
                         "profile-left,top", "--size", "60x30mm", "--dpi", "254", "-o",
                         picture.string(), "-q"})
                .exit_code,
            0);
  const std::string png = read_text(picture);
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\2\x58\0\0\1\x2c", 8)) << "600 x 300";
  expect_refusal({"screenshot", dir, "--show", "face-befor", "-o", picture.string()},
                 {"'face-befor'", "face-before"}, folder.path());
  expect_refusal({"screenshot", dir, "--view", "above", "-o", picture.string()}, {"'above'", "top"},
                 folder.path());
  expect_refusal({"screenshot", dir, "--size", "20x20", "-o", picture.string()}, {"20 x 20", "100"},
                 folder.path());
  expect_refusal({"screenshot", dir, "-o", (folder / "x.jpg").string()}, {".png"}, folder.path());
  const Path views =
      folder.write("views.json",
                   R"({"schema": "facetobone-views/1", "pictures": [{"name": "a", "shows": []}]})");
  expect_refusal({"screenshot", dir, "--definition", views.string(), "-o", folder.path().string()},
                 {"views.json", "shows", "show"}, folder.path());
}

TEST(Screenshot, FilmHasItsFrames)
{
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"screenshot", planned_case().folder.string(), "--show", "morph", "--morph",
                         "3", "--size", "200x160", "-o", (folder / "film").string(), "-q"})
                .exit_code,
            0);
  const std::string first = read_text(folder / "film/frame_0000.png");
  const std::string last = read_text(folder / "film/frame_0002.png");
  EXPECT_FALSE(first.empty());
  EXPECT_NE(first, last);
  EXPECT_FALSE(fs::exists(folder / "film/frame_0003.png"));
}

} // namespace
} // namespace f2b::test
