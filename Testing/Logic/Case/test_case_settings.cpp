#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Case/case_settings.hpp>
#include <Case/settings_paths.hpp>

#include <cstdlib>

namespace f2b
{
namespace
{

using nlohmann::json;
using test::expect_error;

const Path source = "/cases/patient 1/case.json";

json good_document()
{
  return {{"schema", "facetobone-case/1"},
          {"ct", "ct.nrrd"},
          {"landmarks", "points/landmarks.mrk.json"},
          {"osteotomies", {{{"fragment", "mid-face"}, {"template", "le-fort-3"}}}},
          {"target", {{"mesh", "edited.vtp"}}}};
}

json with(const char* pointer, const json& value)
{
  json document = good_document();
  document[json::json_pointer(pointer)] = value;
  return document;
}

void refused(const json& document, std::vector<std::string> parts)
{
  SCOPED_TRACE(document.dump());
  parts.push_back(source.string() + ": ");
  expect_error([&] { parse_settings(document, source); }, parts);
}

TEST(CaseSettings, ShortestCaseHasTheStatedDefaults)
{
  const CaseSettings s = parse_settings(good_document(), source);
  EXPECT_EQ(s.name, "case");
  EXPECT_EQ(s.ct, "/cases/patient 1/ct.nrrd");
  EXPECT_EQ(s.landmarks, "/cases/patient 1/points/landmarks.mrk.json");
  EXPECT_EQ(s.target.mesh, "/cases/patient 1/edited.vtp");
  EXPECT_EQ(s.materials, "table1-stable");
  EXPECT_FALSE(s.skin_threshold_hu || s.bone_threshold_hu || s.region_ras);
  EXPECT_EQ(s.skin_thickness_mm, 1.5);
  EXPECT_EQ(s.spacing_mm, 1);
  EXPECT_EQ(s.head_closing_mm, 5);
  EXPECT_EQ(s.bone_closing_mm, 8);
  EXPECT_EQ(s.mesh_density, 1);
  EXPECT_EQ(s.release_margin_mm, 5);
  EXPECT_EQ(s.contact_tolerance_mm, 2);
  EXPECT_EQ(s.osteotomies.at(0).kerf_mm, 1);
  EXPECT_EQ(s.target.mask_mm, 0);
  EXPECT_EQ(s.threads, 0);
  EXPECT_EQ(s.max_newton_iterations, 25);
  EXPECT_EQ(s.max_fit_iterations, 40);
}

TEST(CaseSettings, EveryKeyIsTaken)
{
  const json movement = {{"translation_mm", {{"right", 2}, {"anterior", 11}, {"superior", -5}}},
                         {"rotation_deg", {{"pitch", 5}, {"roll", 2.5}, {"yaw", 1}}}};
  const json document = {
      {"schema", "facetobone-case/1"},
      {"name", "A"},
      {"notes", "for people"},
      {"ct", "/data/dicom"},
      {"landmarks", "/data/points.mrk.json"},
      {"thresholds", {{"skin_hu", -300}, {"bone_hu", 220.5}}},
      {"region_ras", {{"min", {-70, 0, -90}}, {"max", {70, 110, 40}}}},
      {"segmentation", {{"spacing_mm", 0.8}, {"head_closing_mm", 4}, {"bone_closing_mm", 7}}},
      {"skin_thickness_mm", 2},
      {"skin_thickness_by_region_mm", {{"nose", 2.5}, {"upper_lip", 1}}},
      {"osteotomies",
       {{{"fragment", "chin"},
         {"planes", {"a.mrk.json", "../b.mrk.json"}},
         {"fragment_point_ras", {1, 2, 3}},
         {"kerf_mm", 0.5}}}},
      {"target", {{"from_movement", {{"chin", movement}}}, {"mask_mm", 0.5}}},
      {"materials", "own.json"},
      {"mesh", {{"density", 0.5}, {"release_margin_mm", 4}, {"contact_tolerance_mm", 3}}},
      {"solver",
       {{"threads", 2},
        {"max_newton_iterations", 30},
        {"step_tolerance_mm", 1e-7},
        {"max_fit_iterations", 20},
        {"virtual_force",
         {{"stiffness_n_per_mm3", 0.05},
          {"residual_mm", 0.3},
          {"load", "dead"},
          {"rest_length_mm", 1.5},
          {"landmarks", {"A", "B", "C"}}}}}},
      {"predict", {{"chin", movement}}}};
  const CaseSettings s = parse_settings(document, source);
  EXPECT_EQ(s.name, "A");
  EXPECT_EQ(s.ct, "/data/dicom");
  EXPECT_EQ(s.landmarks, "/data/points.mrk.json");
  EXPECT_EQ(*s.skin_threshold_hu, -300);
  EXPECT_EQ(*s.bone_threshold_hu, 220.5);
  EXPECT_EQ(s.region_ras->max, Vec3(70, 110, 40));
  EXPECT_EQ(s.spacing_mm, 0.8);
  EXPECT_EQ(s.head_closing_mm, 4);
  EXPECT_EQ(s.bone_closing_mm, 7);
  EXPECT_EQ(s.skin_thickness_mm, 2);
  EXPECT_EQ(s.skin_thickness_by_region_mm,
            (std::map<std::string, double>{{"nose", 2.5}, {"upper_lip", 1}}));
  EXPECT_EQ(s.osteotomies.at(0).planes.at(1).lexically_normal(), "/cases/b.mrk.json");
  EXPECT_EQ(*s.osteotomies.at(0).fragment_point, Vec3(1, 2, 3));
  EXPECT_EQ(s.osteotomies.at(0).kerf_mm, 0.5);
  EXPECT_EQ(s.target.movements.at("chin").translation, Vec3(2, 11, -5));
  EXPECT_EQ(s.target.movements.at("chin").rotation_deg, Vec3(5, 2.5, 1));
  EXPECT_EQ(s.target.mask_mm, 0.5);
  EXPECT_EQ(s.materials, "/cases/patient 1/own.json");
  EXPECT_EQ(s.mesh_density, 0.5);
  EXPECT_EQ(s.release_margin_mm, 4);
  EXPECT_EQ(s.contact_tolerance_mm, 3);
  EXPECT_EQ(s.threads, 2);
  EXPECT_EQ(s.max_newton_iterations, 30);
  EXPECT_EQ(s.step_tolerance_mm, 1e-7);
  EXPECT_EQ(s.max_fit_iterations, 20);
  EXPECT_EQ(s.virtual_force.stiffness_n_per_mm3, 0.05);
  EXPECT_EQ(s.virtual_force.residual_mm, 0.3);
  EXPECT_EQ(s.virtual_force.load, "dead");
  EXPECT_EQ(s.virtual_force.rest_length_mm, 1.5);
  EXPECT_EQ(s.virtual_force.landmarks, (std::vector<std::string>{"A", "B", "C"}));
  EXPECT_EQ(s.predict.count("chin"), 1u);
}

TEST(CaseSettings, VirtualForceTakesANumberOrAuto)
{
  const char* key = "/solver/virtual_force/stiffness_n_per_mm3";
  EXPECT_EQ(parse_settings(good_document(), source).virtual_force.stiffness_n_per_mm3, 0.02);
  EXPECT_FALSE(parse_settings(with(key, "auto"), source).virtual_force.stiffness_n_per_mm3);
  refused(with(key, "automatic"), {key, "automatic", "or auto"});
  refused(with(key, 0), {key, "above 0"});
  refused(with("/solver/virtual_force/load", "live"), {"following", "dead"});
  refused(with("/solver/virtual_force/landmarks", {"A", "B"}), {"landmarks", "minItems 3"});
  refused(with("/solver/virtual_force_stiffness_n_per_mm3", 0.02), {"virtual_force"});
  nlohmann::json document = with("/solver/virtual_force/landmarks", {"A", "B", "C"});
  document.erase("landmarks");
  document["osteotomies"] = {
      {{"fragment", "chin"}, {"planes", {"a.mrk.json"}}, {"fragment_point_ras", {1, 2, 3}}}};
  refused(document, {"/solver/virtual_force/landmarks", "'/landmarks' is absent"});
}

TEST(CaseSettings, WarpIsTaken)
{
  const CaseSettings s = parse_settings(
      with("/target", {{"warp", {{"from", "f.json"}, {"to", "/t.json"}, {"radius_mm", 30}}}}),
      source);
  EXPECT_EQ(s.target.warp_from, "/cases/patient 1/f.json");
  EXPECT_EQ(s.target.warp_to, "/t.json");
  EXPECT_EQ(s.target.warp_radius_mm, 30);
}

TEST(CaseSettings, UnknownKeysAreNamedWithASuggestion)
{
  refused(with("/treshold", 1), {"'/treshold'", "thresholds"});
  refused(with("/mesh", {{"dencity", 1}}), {"'/mesh/dencity'", "did you mean 'density'?"});
  refused(with("/osteotomies/0/kerf", 1), {"'/osteotomies/0/kerf'", "kerf_mm"});
  refused(with("/target/from_movement", {{"mid-face", {{"wrong", json::object()}}}}),
          {"'/target/from_movement/mid-face/wrong'", "rotation_deg, translation_mm"});
  refused(with("/solver", {{"x", 1}}), {"'/solver/x'", "known keys here: ", "threads"});
}

TEST(CaseSettings, KeysWithLineBreaksAreRefusedInOneLine)
{
  refused(with("/target", {{"from_movement", {{"a\nb", json::object()}}}}),
          {"\"a\\nb\"", "control character"});
}

TEST(CaseSettings, WrongTypesAreNamedWithTheValue)
{
  refused(with("/ct", 7), {"'/ct' is 7", "give string"});
  refused(with("/mesh", {{"density", "fine"}}), {"'/mesh/density' is \"fine\"", "give number"});
  refused(with("/solver", {{"threads", 1.5}}), {"'/solver/threads' is 1.5", "give integer"});
  refused(with("/region_ras", {{"min", {0, 0}}, {"max", {1, 1, 1}}}),
          {"'/region_ras/min' is [0,0]", "minItems 3"});
  refused(with("/region_ras", {{"min", {0, 0, "a"}}, {"max", {1, 1, 1}}}),
          {"'/region_ras/min/2' is \"a\"", "give number"});
  refused(with("/osteotomies", json::object()), {"'/osteotomies' is {}", "give array"});
  refused(with("/target/from_movement", {{"a~b/c", 5}}),
          {"'/target/from_movement/a~0b~1c' is 5", "give object"});
  refused(with("/thresholds", nullptr), {"'/thresholds' is null", "give object"});
  refused(json::array(), {"the document is []", "give object"});
  refused("text", {"the document is \"text\""});
}

TEST(CaseSettings, RangesAreNamed)
{
  refused(with("/segmentation", {{"spacing_mm", 0.1}}),
          {"'/segmentation/spacing_mm' is 0.1", "minimum 0.3", "maximum 3"});
  refused(with("/mesh", {{"density", 0}}), {"'/mesh/density' is 0", "minimum 0.02"});
  refused(with("/solver", {{"step_tolerance_mm", 0}}),
          {"'/solver/step_tolerance_mm' is 0", "exclusiveMinimum 0"});
  refused(with("/osteotomies/0/kerf_mm", -1), {"'/osteotomies/0/kerf_mm' is -1"});
  refused(with("/osteotomies/0/fragment", "../x"),
          {"'/osteotomies/0/fragment' is \"../x\"", "pattern"});
  refused(with("/osteotomies/0/fragment", ""), {"'/osteotomies/0/fragment' is \"\""});
  refused(with("/schema", "facetobone-case/9"),
          {"'/schema' is \"facetobone-case/9\"", "facetobone-case/1"});
  refused(with("/ct", ""), {"'/ct' is \"\""});
  refused(with("/target/from_movement", {{"mid-face", {{"rotation_deg", {{"yaw", 120}}}}}}),
          {"'/target/from_movement/mid-face/rotation_deg/yaw' is 120", "maximum 90"});
}

TEST(CaseSettings, CutsAndTargetAreAskedForWhereTheyAreNeeded)
{
  json document = good_document();
  document.erase("osteotomies");
  document.erase("target");
  const CaseSettings s = parse_settings(document, "/data/case.json");
  EXPECT_TRUE(s.osteotomies.empty());
  expect_error([&] { require_cuts(s); }, {"'/osteotomies' is absent", "le-fort-1"});
  expect_error([&] { require_target(s); }, {"'/target' is absent", "from_movement"});
  require_cuts(parse_settings(good_document(), "/data/case.json"));
  require_target(parse_settings(good_document(), "/data/case.json"));
}

TEST(CaseSettings, ACtIsACaseOfItsOwn)
{
  const test::TemporaryFolder folder;
  for (const char* name : {"head.nrrd", "head.NII.GZ", "slice.dcm"})
  {
    const Path ct = folder.write(name, "");
    const CaseSettings s = parse_settings(read_case(ct), ct);
    EXPECT_EQ(s.ct, ct);
    EXPECT_EQ(s.name, ct.stem().string());
  }
  EXPECT_EQ(parse_settings(read_case(folder.path()), "x").ct, folder.path()) << "of DICOM slices";
  folder.write("case.json", good_document().dump());
  expect_error([&] { read_case(folder.path()); }, {folder.path().string(), "case.json"});
  EXPECT_EQ(read_case(folder / "case.json"), good_document());
}

TEST(CaseSettings, MissingKeysAreNamed)
{
  for (const char* key : {"schema", "ct"})
  {
    json document = good_document();
    document.erase(key);
    refused(document, {std::string("'/") + key + "' is absent"});
  }
  refused(with("/target", {{"warp", {{"from", "f.json"}}}}), {"'/target/warp/to' is absent"});
  refused(with("/region_ras", {{"min", {0, 0, 0}}}), {"'/region_ras/max' is absent"});
}

TEST(CaseSettings, CutsAreATemplateOrDrawnOrATemplateThatWasEdited)
{
  refused(with("/osteotomies/0", {{"fragment", "x"}}),
          {"'/osteotomies/0'", "neither template nor planes nor curves", "draw the cuts"});
  const CaseSettings edited =
      parse_settings(with("/osteotomies/0/planes", {"a.json"}), "/cases/case.json");
  EXPECT_FALSE(edited.osteotomies[0].template_name.empty());
  EXPECT_TRUE(edited.osteotomies[0].drawn());
  const CaseSettings curves = parse_settings(
      with("/osteotomies/0",
           {{"fragment", "x"},
            {"fragment_point_ras", {1, 2, 3}},
            {"curves", {{{"markup", "c.mrk.json"}, {"depth_mm", 12}, {"straight", true}}}}}),
      "/cases/case.json");
  const CurveSettings& curve = curves.osteotomies[0].curves.at(0);
  EXPECT_EQ(curve.markup.lexically_normal(), "/cases/c.mrk.json");
  EXPECT_EQ(curve.depth_mm, 12);
  EXPECT_EQ(curve.lead_mm, 5);
  EXPECT_TRUE(curve.straight);
  EXPECT_FALSE(curve.direction);
  refused(with("/osteotomies/0", {{"fragment", "x"}, {"planes", {"a.json"}}}),
          {"'/osteotomies/0'", "fragment_point_ras"});
  refused(with("/osteotomies/0", {{"planes", {"a.json"}}, {"fragment_point_ras", {1, 2, 3}}}),
          {"'/osteotomies/0'", "name"});
  refused(with("/osteotomies/0/template", "le-fort-9"),
          {"'/osteotomies/0'", "le-fort-9", "le-fort-1"});
}

TEST(CaseSettings, ProtectedStructuresAreACurveOrAMesh)
{
  const json nerve = {{"name", "nerve"}, {"curve", "n.mrk.json"}, {"margin_mm", 3}};
  const CaseSettings s = parse_settings(with("/protected", json::array({nerve})), "/c/case.json");
  EXPECT_EQ(s.protected_structures.at(0).margin_mm, 3);
  EXPECT_EQ(s.protected_structures.at(0).curve.lexically_normal(), "/c/n.mrk.json");
  json both = nerve;
  both["mesh"] = "roots.vtp";
  refused(with("/protected", json::array({both})), {"'/protected'", "'nerve'", "both"});
}

TEST(CaseSettings, SeriesAndGreyValuesAreRead)
{
  const CaseSettings s = parse_settings(with("/series", "2"), "/c/case.json");
  EXPECT_EQ(s.reading.series, "2");
  EXPECT_FALSE(s.reading.shifted_grey_values);
  EXPECT_TRUE(
      parse_settings(with("/grey_values", "cbct"), "/c/case.json").reading.shifted_grey_values);
}

TEST(CaseSettings, ExactlyOneTarget)
{
  refused(with("/target", {{"mask_mm", 1}}), {"'/target'", "0 of", "exactly one"});
  refused(with("/target/warp", {{"from", "f"}, {"to", "t"}}), {"'/target'", "2 of", "exactly one"});
  refused(with("/target", json::object()), {"'/target'", "exactly one"});
}

TEST(CaseSettings, KeysMustFitTogether)
{
  const json cut = {{"fragment", "mid face"}, {"template", "le-fort-1"}},
             twin = {{"fragment", "mid_face"}, {"template", "genioplasty"}};
  refused(with("/osteotomies", {cut, twin}), {"'mid_face'", "own name"});
  refused(with("/osteotomies/0/fragment", "predicted"), {"'predicted'", "own name"});
  json document = good_document();
  document.erase("landmarks");
  refused(document, {"le-fort-3", "'/landmarks' is absent"});
  refused(with("/region_ras", {{"min", {0, 5, 0}}, {"max", {1, 5, 1}}}), {"'/region_ras'", "min"});
  refused(with("/thresholds", {{"skin_hu", 300}, {"bone_hu", 200}}), {"'/thresholds/skin_hu'"});
  refused(with("/skin_thickness_by_region_mm", {{"nostril", 2}}), {"nostril", "nose, "});
}

TEST(CaseSettings, PathsMayUseTheEnvironment)
{
  setenv("FACETOBONE_TEST_DATA", "/data sets", 1);
  EXPECT_EQ(parse_settings(with("/ct", "${FACETOBONE_TEST_DATA}/a/ct.nrrd"), source).ct,
            "/data sets/a/ct.nrrd");
  unsetenv("FACETOBONE_TEST_DATA");
  refused(with("/ct", "${FACETOBONE_TEST_DATA}/ct.nrrd"), {"FACETOBONE_TEST_DATA", "not set"});
  refused(with("/ct", "${FACETOBONE"), {"FACETOBONE"});
}

TEST(CaseSettings, KeptDocumentHasAbsolutePaths)
{
  json document = with("/target", {{"warp", {{"from", "f.json"}, {"to", "../t.json"}}}});
  document["materials"] = "own.json";
  const json kept = with_absolute_paths(document, source);
  EXPECT_EQ(kept["ct"], "/cases/patient 1/ct.nrrd");
  EXPECT_EQ(kept["landmarks"], "/cases/patient 1/points/landmarks.mrk.json");
  EXPECT_EQ(kept["target"]["warp"]["to"], "/cases/t.json");
  EXPECT_EQ(kept["materials"], "/cases/patient 1/own.json");
  EXPECT_EQ(with_absolute_paths(kept, "/elsewhere/case.json"), kept);
  EXPECT_EQ(with_absolute_paths(with("/materials", "table1-stable"), source)["materials"],
            "table1-stable");
}

TEST(CaseSettings, FilesWithinACaseFolderAreNamedByIt)
{
  json document =
      with("/target", {{"warp", {{"from", "/case ü/f.json"}, {"to", "/cases/t.json"}}}});
  document["osteotomies"][0]["planes"] = {"/case ü/cut_1.mrk.json", "/case ü/../p.mrk.json"};
  document["osteotomies"][0]["curves"] = {{{"markup", "/case ü/in/c.mrk.json"}}};
  document["protected"] = {{{"name", "nerve"}, {"curve", "/case ü/n.mrk.json"}}};
  const json kept = with_folder_paths(document, "/case ü");
  EXPECT_EQ(kept["target"]["warp"], (json{{"from", "f.json"}, {"to", "/cases/t.json"}}));
  EXPECT_EQ(kept["osteotomies"][0]["planes"], (json{"cut_1.mrk.json", "/case ü/../p.mrk.json"}));
  EXPECT_EQ(kept["osteotomies"][0]["curves"][0]["markup"], "in/c.mrk.json");
  EXPECT_EQ(kept["protected"][0]["curve"], "n.mrk.json");
  EXPECT_EQ(with_absolute_paths(kept, "/elsewhere/case.json")["target"]["warp"]["from"],
            "/elsewhere/f.json");
}

TEST(CaseSettings, MovementsOfUnknownFragmentsAreNamed)
{
  Movements movements;
  movements["nose"] = {};
  expect_error(
      [&] {
        require_known_fragments(movements, {"chin", "mid-face"}, "'/predict'");
      },
      {"'/predict'", "'nose'", "use 'chin', 'mid-face'"});
}

} // namespace
} // namespace f2b
