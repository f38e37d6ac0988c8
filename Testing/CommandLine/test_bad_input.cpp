#include "CommandLine/bad_volumes.hpp"
#include "CommandLine/coarse_case.hpp"
#include "temporary_folder.hpp"

#include <Bridge/markups.hpp>
#include <Bridge/vtk_surface.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace f2b::test
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;
using Parts = std::vector<std::string>;

/// `run` refuses a case; the folder of its results is not made.
void expect_case_refused(const TemporaryFolder& folder, const json& document, const Parts& parts)
{
  const Path file = write_case(folder.path(), document);
  expect_refusal({"run", file.string(), "-o", (folder / "out").string()}, parts, folder.path());
}

void expect_ct_refused(const TemporaryFolder& folder, const Path& ct, Parts parts)
{
  json document = coarse_case();
  document["ct"] = ct.string();
  parts.push_back(ct.filename().string());
  expect_case_refused(folder, document, parts);
}

json with(const char* pointer, const json& value)
{
  json document = coarse_case();
  document[json::json_pointer(pointer)] = value;
  return document;
}

/// A ball of soft tissue around a ball of bone.
int head(int i, int j, int k)
{
  const double r = std::hypot(i - 20, j - 20, k - 20);
  return r < 10 ? 900 : r < 15 ? 40 : -1000;
}

/// The coarse case after `segment` and `cut`; made once.
Path segmented_case()
{
  static const Path folder = []
  {
    const Path path = scratch_folder() / "segmented";
    const Path file = write_case(scratch_folder(), coarse_case());
    EXPECT_EQ(run_program({"segment", file.string(), "-o", path.string()}).exit_code, 0);
    EXPECT_EQ(run_program({"cut", path.string()}).exit_code, 0);
    return path;
  }();
  return folder;
}

TEST(BadInput, MissingFiles)
{
  const TemporaryFolder folder;
  expect_refusal({"run", (folder / "absent.json").string(), "-o", (folder / "out").string()},
                 {"absent.json"}, folder.path());
  expect_ct_refused(folder, folder / "absent.nrrd", {});
  expect_case_refused(folder, with("/landmarks", "absent.mrk.json"),
                      {"absent.mrk.json", "/landmarks"});
  expect_case_refused(folder, with("/target", {{"mesh", "absent.vtp"}}),
                      {"absent.vtp", "/target/mesh"});
  expect_case_refused(folder, with("/target/warp/to", "absent.mrk.json"),
                      {"absent.mrk.json", "/target/warp/to"});
  expect_case_refused(folder, with("/materials", "absent.json"), {"absent.json", "table1-stable"});
  expect_case_refused(
      folder,
      with("/osteotomies",
           {{{"fragment", "x"}, {"planes", {"absent.json"}}, {"fragment_point_ras", {0, 0, 0}}}}),
      {"absent.json", "/osteotomies"});
}

TEST(BadInput, EmptyFolder)
{
  const TemporaryFolder folder;
  fs::create_directory(folder / "dicom");
  expect_ct_refused(folder, folder / "dicom", {});
}

TEST(BadInput, TruncatedVolume)
{
  const TemporaryFolder folder;
  const std::string whole = read_text(coarse_sample() / "ct.nrrd");
  expect_ct_refused(folder, folder.write("half.nrrd", whole.substr(0, whole.size() / 2)), {});
  expect_ct_refused(folder, folder.write("header.nrrd", whole.substr(0, 200)), {});
  expect_ct_refused(folder, folder.write("nothing.nrrd", ""), {});
  Volume volume;
  volume.value = head;
  write_nrrd(folder / "raw.nrrd", volume);
  fs::resize_file(folder / "raw.nrrd", fs::file_size(folder / "raw.nrrd") - 1000);
  expect_ct_refused(folder, folder / "raw.nrrd", {});
}

TEST(BadInput, NoCt)
{
  const TemporaryFolder folder;
  Volume volume;
  volume.value = [](int i, int j, int k)
  { return head(i, j, k) < 0 ? (i * 7 + j * 3 + k) % 20 : 200 + (i * j + k) % 300; };
  write_nrrd(folder / "mr.nrrd", volume);
  expect_ct_refused(folder, folder / "mr.nrrd", {});
  volume.type = "uchar";
  volume.value = [](int i, int j, int k) { return head(i, j, k) < 0 ? 0 : 128; };
  write_nrrd(folder / "8bit.nrrd", volume);
  expect_ct_refused(folder, folder / "8bit.nrrd", {});
}

TEST(BadInput, SingleSlice)
{
  const TemporaryFolder folder;
  Volume volume;
  volume.value = head;
  volume.size[2] = 1;
  write_nrrd(folder / "slice.nrrd", volume);
  expect_ct_refused(folder, folder / "slice.nrrd", {});
}

TEST(BadInput, SpacingZeroOrNaN)
{
  const TemporaryFolder folder;
  for (const char* spacing : {"0", "nan", "inf"})
  {
    Volume volume;
    volume.value = head;
    volume.spacing[1] = spacing;
    write_nrrd(folder / "ct.nrrd", volume);
    expect_ct_refused(folder, folder / "ct.nrrd", {"spacing"});
  }
}

TEST(BadInput, TwoSeries)
{
  const TemporaryFolder folder;
  fs::create_directory(folder / "dicom");
  write_dicom_series(folder / "dicom", "first", "1.2.826.0.1.3680043.2.1125.1");
  write_dicom_series(folder / "dicom", "second", "1.2.826.0.1.3680043.2.1125.2");
  expect_ct_refused(folder, folder / "dicom", {"2"});
}

TEST(BadInput, ThresholdsThatSelectNothing)
{
  const TemporaryFolder folder;
  expect_case_refused(folder, with("/thresholds", {{"bone_hu", 9000}}), {"bone", "9000"});
  expect_case_refused(folder, with("/thresholds", {{"skin_hu", 8000}, {"bone_hu", 9000}}),
                      {"skin", "8000"});
  expect_case_refused(folder, with("/thresholds", {{"skin_hu", -5000}}), {"skin", "-5000"});
}

TEST(BadInput, RegionWithoutBoneOrSkin)
{
  const TemporaryFolder folder;
  expect_case_refused(folder,
                      with("/region_ras", {{"min", {500, 500, 500}}, {"max", {600, 600, 600}}}),
                      {"region"});
  // in front of the face: air alone; in the neck: skin alone is cut; deep in the cheek: no skin
  expect_case_refused(
      folder, with("/region_ras", {{"min", {-20, 116, -20}}, {"max", {20, 124, 20}}}), {"region"});
  expect_case_refused(folder, with("/region_ras", {{"min", {-6, -20, 20}}, {"max", {6, -8, 32}}}),
                      {"region"});
}

TEST(BadInput, PlaneThatMissesTheBone)
{
  const TemporaryFolder folder;
  BoundedPlane plane;
  plane.name = "stray";
  plane.center = {0, 200, 0};
  write_planes(folder / "stray.mrk.json", {plane});
  expect_case_refused(folder,
                      with("/osteotomies", {{{"fragment", "x"},
                                             {"planes", {"stray.mrk.json"}},
                                             {"fragment_point_ras", {0, 60, -40}}}}),
                      {"'stray'", "misses the bone"});
}

TEST(BadInput, TargetThatIsNotTheSkin)
{
  const TemporaryFolder folder;
  const Path segmented = segmented_case();
  TriangleMesh skin = to_triangle_mesh(read_surface(segmented / "skin.vtp"));
  auto refused = [&](const char* name, const TriangleMesh& mesh, const Parts& parts)
  {
    write_surface(folder / name, to_polydata(mesh));
    expect_refusal({"target", segmented.string(), "--mesh", (folder / name).string()}, parts,
                   segmented);
  };
  TriangleMesh other = skin;
  other.points.push_back({0, 0, 0});
  refused("more.vtp", other,
          {"more.vtp", std::to_string(skin.points.size()), std::to_string(skin.points.size() + 1)});
  other = skin;
  other.points[17].x() = std::nan("");
  refused("nan.vtp", other, {"nan.vtp", "not finite"});
  other = skin;
  std::swap(other.triangles[5][0], other.triangles[900][1]);
  refused("order.vtp", other, {"order.vtp", "triangles"});
  other = skin;
  for (Vec3& p : other.points)
    p.x() += 300;
  refused("far.vtp", other, {"far.vtp", "300.0 mm"});
  expect_refusal({"target", segmented.string(), "--mesh", (folder / "absent.vtp").string()},
                 {"absent.vtp"}, segmented);
}

TEST(BadInput, TargetMeshIsCheckedByRunToo)
{
  const TemporaryFolder folder;
  write_surface(folder / "t.vtp", to_polydata({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}));
  expect_case_refused(folder, with("/target", {{"mesh", "t.vtp"}}), {"t.vtp", "3 vertices"});
}

TEST(BadInput, TargetWordsThatMakeNoSense)
{
  const TemporaryFolder folder;
  const std::string dir = segmented_case().string();
  expect_refusal({"target", dir, "--movement", "mid-face:1,2,3"}, {"--movement", "mid-face:1,2,3"},
                 dir);
  expect_refusal({"target", dir, "--movement", "mid-face:1,2,3,4,5,nan"}, {"--movement"}, dir);
  expect_refusal({"target", dir, "--movement", "mid-face:1,2,300,4,5,6"},
                 {"superior", "300", "command line"}, dir);
  expect_refusal({"target", dir, "--movement", "mid-face:0,0,0,0,0,0", "--mesh", "a.vtp"},
                 {"command line", "2 of"}, dir);
  write_landmarks(folder / "a.json", {{"prn", {0, 100, -40}}});
  write_landmarks(folder / "b.json", {{"sn", {0, 100, -40}}});
  expect_refusal({"target", dir, "--warp-from", (folder / "a.json").string(), "--warp-to",
                  (folder / "b.json").string()},
                 {"b.json", "'prn'"}, dir);
  expect_refusal({"target", dir, "--warp-from", (folder / "a.json").string(), "--warp-to",
                  (folder / "a.json").string(), "--warp-radius", "-1"},
                 {"radius_mm", "-1"}, dir);
  write_landmarks(folder / "c.json", {{"prn", {0, 260, -40}}});
  expect_refusal({"target", dir, "--warp-from", (folder / "a.json").string(), "--warp-to",
                  (folder / "c.json").string()},
                 {"target", "moves the skin by up to 1", "100.0 mm"}, dir);
}

TEST(BadInput, AScanThatDoesNotOverlapTheFace)
{
  const TemporaryFolder folder;
  const Path segmented = segmented_case();
  TriangleMesh scan = to_triangle_mesh(read_surface(segmented / "skin.vtp"));
  for (Vec3& p : scan.points)
    p.x() += 300;
  write_surface(folder / "scan.vtp", to_polydata(scan));
  expect_refusal({"target", segmented.string(), "--scan", (folder / "scan.vtp").string()},
                 {"scan.vtp", "overlaps the face in 0 of", "register the scan"}, segmented);
}

TEST(BadInput, StepsBeforeTheirTurn)
{
  const std::string dir = segmented_case().string();
  expect_refusal({"plan", dir}, {"mesh.vtu", "facetobone mesh"}, dir);
  expect_refusal({"predict", dir}, {"mesh.vtu", "facetobone mesh"}, dir);
  expect_refusal({"report", dir}, {"plan.json", "facetobone plan"}, dir);
}

TEST(BadInput, DamagedCaseFiles)
{
  const TemporaryFolder folder;
  fs::copy(segmented_case(), folder / "case", fs::copy_options::recursive);
  const Path dir = folder / "case";
  auto refused =
      [&](const char* name, const std::string& text, const char* verb, const Parts& parts)
  {
    const std::string whole = read_text(dir / name);
    folder.write(std::string("case/") + name, text);
    expect_refusal({verb, dir.string()}, parts, dir);
    folder.write(std::string("case/") + name, whole);
  };
  refused("case.json", "{", "cut", {"case.json", "line 1"});
  refused("case.json", "[]", "cut", {"case.json", "array, not an object"});
  refused("bone_distance.nrrd", "NRRD0004\n", "cut", {"bone_distance.nrrd", "segment"});
  refused("landmarks.mrk.json", "{}", "cut", {"landmarks.mrk.json"});
  refused("skin.vtp", "<VTKFile>", "target", {"skin.vtp"});
}

TEST(BadInput, ReadOnlyOutput)
{
  const TemporaryFolder folder;
  const Path file = write_case(folder.path(), coarse_case());
  expect_refusal({"run", file.string(), "-o", "/proc/facetobone"}, {"/proc/facetobone"},
                 folder.path());
  expect_refusal({"run", file.string(), "-o", file.string()}, {"case.json", "not a folder"},
                 folder.path());
  expect_refusal({"sample", "-o", "/proc/facetobone"}, {"/proc/facetobone"}, folder.path());
  expect_refusal({"run", file.string(), "-o", ""}, {"cannot be made"}, folder.path());
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms(0555));
  expect_one_line_refusal(run_as_nobody({"run", file.string(), "-o", (folder / "locked").string()}),
                          {"locked", "read-only"});
  expect_one_line_refusal(
      run_as_nobody({"run", file.string(), "-o", (folder / "locked/deeper").string()}), {"deeper"});
  EXPECT_TRUE(fs::is_empty(folder / "locked"));
  fs::permissions(folder / "locked", fs::perms(0755));
}

TEST(BadInput, ResultsNeverReplaceTheUsersFiles)
{
  const TemporaryFolder folder;
  folder.write("out/ct.nrrd", "mine");
  const Path file = write_case(folder.path(), coarse_case());
  expect_refusal({"run", file.string(), "-o", (folder / "out").string()}, {"ct.nrrd", "in the way"},
                 folder.path());
  expect_refusal({"segment", file.string(), "-o", (folder / "out").string()},
                 {"ct.nrrd", "in the way"}, folder.path());
  const Path inside = write_case(coarse_sample(), coarse_case(), "inside.json");
  expect_refusal({"run", inside.string(), "-o", coarse_sample().string()},
                 {"ct.nrrd", "another folder"}, coarse_sample());
  fs::remove(inside);
}

TEST(BadInput, MalformedJsonAndUnknownKeys)
{
  const TemporaryFolder folder;
  for (const char* text : {"", "{", "{\"schema\": \"facetobone-case/1\",}", "\xff\xfe",
                           "{\"ct\": NaN}", "{\"ct\": 1e999}"})
  {
    const Path file = folder.write("case.json", text);
    expect_refusal({"run", file.string(), "-o", (folder / "out").string()}, {"case.json"},
                   folder.path());
  }
  expect_case_refused(folder, with("/mesh/dencity", 1),
                      {"case.json", "/mesh/dencity", "did you mean 'density'?"});
  expect_case_refused(folder, with("/mesh/density", "fine"),
                      {"case.json", "/mesh/density", "\"fine\"", "number"});
  expect_case_refused(folder, json::array(), {"case.json"});
  expect_case_refused(folder, with("/target/from_movement", {{"nose", json::object()}}),
                      {"case.json", "/target"});
  expect_case_refused(folder, with("/predict", {{"nose", json::object()}}),
                      {"'nose'", "'mid-face'"});
}

TEST(BadInput, LandmarksThatDoNotServe)
{
  const TemporaryFolder folder;
  Landmarks landmarks = read_landmarks(coarse_sample() / "landmarks.mrk.json");
  landmarks.erase("PNS");
  write_landmarks(folder / "l.mrk.json", landmarks);
  expect_case_refused(folder, with("/landmarks", "l.mrk.json"), {"'PNS'", "landmark"});
  folder.write("l.mrk.json", read_text(coarse_sample() / "target_to.mrk.json").substr(0, 500));
  expect_case_refused(folder, with("/landmarks", "l.mrk.json"), {"l.mrk.json", "JSON"});
}

} // namespace
} // namespace f2b::test
