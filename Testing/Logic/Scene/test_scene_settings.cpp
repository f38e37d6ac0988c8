#include "Logic/Scene/logic_case.hpp"

#include "Bridge/resources.hpp"
#include "Case/case_settings.hpp"
#include "Scene/scene_settings.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace f2b::test
{
namespace
{

using nlohmann::json;

/// Six different numbers, one a coordinate.
json for_each_coordinate(const std::function<json(double)>& value)
{
  json members;
  double number = 1;
  for (const char* key : {"right", "anterior", "superior", "pitch", "roll", "yaw"})
    members[key] = value(number++);
  return members;
}

json full_osteotomies()
{
  json upper = {{"fragment", "mid-face"}, {"template", "le-fort-3"}, {"kerf_mm", 0.7}};
  upper["movement"] = {{"locked", {"roll", "yaw"}},
                       {"bounds", for_each_coordinate(
                                      [](double n) {
                                        return json{-n, n / 3};
                                      })},
                       {"prior", for_each_coordinate(
                                     [](double n) {
                                       return json{{"expected", n}, {"sd", n / 7}};
                                     })},
                       {"bite", {{"with", "chin"}, {"splint", "/a/s.tfm"}, {"tolerance_mm", 0.5}}}};
  json lower = {{"fragment", "chin"},
                {"planes", {"/a/p1.mrk.json", "/a/p2.mrk.json"}},
                {"fragment_point_ras", {0.5, 80.25, -100.125}}};
  lower["curves"] = {{{"markup", "/a/c.mrk.json"},
                      {"direction_ras", {0.0, -0.6, 0.8}},
                      {"depth_mm", 12.5},
                      {"lead_mm", 3.5},
                      {"straight", true}}};
  lower["movement"] = {
      {"hinge", {{"axis", {"Co_R", "Co_L"}}, {"bounds_deg", {-2.5, 7.5}}}},
      {"bite", {{"points", {{"from", "/a/f.mrk.json"}, {"to", "/a/t.mrk.json"}}}}}};
  return {upper, lower};
}

/// Every key of the schema but those of other kinds of target, none at its default.
json full_case()
{
  json document = smallest_case();
  document["name"] = "A";
  document["notes"] = "line 1\nline; 2 100 %";
  document["series"] = "3";
  document["grey_values"] = "cbct";
  document["thresholds"] = {{"skin_hu", -249.5}, {"bone_hu", 251.25}};
  document["region_ras"] = {{"min", {-76.1, -10, -134}}, {"max", {76, 115, 1.0 / 3}}};
  document["segmentation"] = {{"spacing_mm", 1.5},        {"head_closing_mm", 4.0},
                              {"bone_closing_mm", 7.0},   {"bone", "level-set"},
                              {"seeds", "/a/s.mrk.json"}, {"labels", "/a/l.seg.nrrd"},
                              {"surface_error_mm", 0.1}};
  document["skin_thickness_mm"] = 1.6;
  document["skin_thickness_by_region_mm"] = {{"nose", 2.5}, {"upper_lip", 1.0}};
  document["osteotomies"] = full_osteotomies();
  document["protected"] = {{{"name", "nerve"}, {"curve", "/a/n.mrk.json"}, {"margin_mm", 1.5}},
                           {{"name", "roots"}, {"mesh", "/a/r.stl"}}};
  document["target"] = {{"scan", {{"mesh", "/a/s.stl"}, {"reach_mm", 25.5}}},
                        {"registration_sd_mm", 0.4},
                        {"mask_mm", 1.5}};
  document["materials"] = "table1";
  document["mesh"] = {{"density", 0.15},
                      {"tetrahedra", 20000},
                      {"release_margin_mm", 4.5},
                      {"contact_tolerance_mm", 2.5}};
  document["solver"] = {{"threads", 1},
                        {"max_newton_iterations", 30},
                        {"step_tolerance_mm", 1.25e-7},
                        {"max_fit_iterations", 12},
                        {"predict_model", "lfem"},
                        {"virtual_force",
                         {{"stiffness_n_per_mm3", 0.03},
                          {"residual_mm", 0.25},
                          {"load", "dead"},
                          {"rest_length_mm", 0.125},
                          {"landmarks", {"A", "B", "C"}}}}};
  document["predict"] = {
      {"chin",
       {{"translation_mm", {{"right", 1.0}, {"anterior", 2.5}, {"superior", -3.0}}},
        {"rotation_deg", {{"pitch", 4.0}, {"roll", 0.1}, {"yaw", 6.0}}}}}};
  return document;
}

/// The targets that full_case has not.
std::vector<json> other_targets()
{
  const json still = {{"translation_mm", {{"right", 0.0}, {"anterior", 5.0}, {"superior", 0.0}}},
                      {"rotation_deg", {{"pitch", 0.0}, {"roll", 0.0}, {"yaw", 0.0}}}};
  return {json{{"mesh", "/a/skin.vtp"}}, json{{"scan", {{"mesh", "/a/s.ply"}}}},
          json{{"warp", {{"from", "/f"}, {"to", "/t"}, {"radius_mm", 80.0}}}},
          json{{"from_movement", {{"mid-face", still}}}}};
}

/// The settings that a rule of the schema knows, as paths; \p document only those that it has, if it
/// is not null. Members of any name and of arrays count as one.
void add_settings(const json& schema, const json& any_rule, const json* document,
                  const std::string& path, std::set<std::string>& settings)
{
  const json& rule =
      any_rule.contains("$ref")
          ? schema.at(json::json_pointer(any_rule["$ref"].get<std::string>().substr(1)))
          : any_rule;
  for (const char* members : {"items", "additionalProperties"})
    if (rule.contains(members) && rule[members].is_object())
    {
      if (!document)
        add_settings(schema, rule[members], nullptr, path + "/*", settings);
      else
        for (const json& member : *document)
          add_settings(schema, rule[members], &member, path + "/*", settings);
      return;
    }
  if (!rule.contains("properties"))
  {
    settings.insert(path);
    return;
  }
  for (const auto& [key, member] : rule["properties"].items())
    if (!document || document->contains(key))
      add_settings(schema, member, document ? &document->at(key) : nullptr, path + "/" + key,
                   settings);
}

/// Nodes of a scene of their own.
struct Nodes
{
  LogicScene world;
  CaseNodes nodes = CaseNodes::of(world.logic->AddPlan("plan"));

  json back(const json& document)
  {
    settings_to_nodes(document, nodes);
    return settings_from_nodes(nodes);
  }
};

TEST(SceneSettingsTest, EverySettingComesBack)
{
  Nodes n;
  EXPECT_EQ(n.back(full_case()), full_case());
}

TEST(SceneSettingsTest, EverySettingComesBackThroughASceneFile)
{
  Nodes n;
  settings_to_nodes(full_case(), n.nodes);
  n.world.scene->SetSaveToXMLString(1);
  ASSERT_EQ(n.world.scene->Commit(), 1);
  LogicScene again;
  again.scene->SetLoadFromXMLString(1);
  again.scene->SetSceneXMLString(n.world.scene->GetSceneXMLString());
  ASSERT_EQ(again.scene->Connect(), 1);
  auto* plan = vtkMRMLFaceToBonePlanNode::SafeDownCast(
      again.scene->GetFirstNodeByClass("vtkMRMLFaceToBonePlanNode"));
  EXPECT_EQ(settings_from_nodes(CaseNodes::of(plan)), full_case());
}

TEST(SceneSettingsTest, TheFullCaseHasEverySettingOfTheSchema)
{
  const json schema = json::parse(*carried_resource("Schema/case.schema.json"));
  std::set<std::string> all, seen;
  add_settings(schema, schema, nullptr, "", all);
  const json full = full_case();
  add_settings(schema, schema, &full, "", seen);
  for (const json& target : other_targets())
    add_settings(schema, schema["properties"]["target"], &target, "/target", seen);
  EXPECT_GT(all.size(), 60u);
  EXPECT_EQ(all, seen);
}

TEST(SceneSettingsTest, EachKindOfTargetComesBack)
{
  for (const json& target : other_targets())
  {
    Nodes n;
    json document = smallest_case();
    document["target"] = target;
    EXPECT_EQ(n.back(document), document);
  }
}

TEST(SceneSettingsTest, AutomaticStiffnessComesBack)
{
  Nodes n;
  json document = smallest_case();
  document["solver"]["virtual_force"]["stiffness_n_per_mm3"] = "auto";
  EXPECT_EQ(n.back(document), document);
}

TEST(SceneSettingsTest, LeavesNothingOfAnEarlierCase)
{
  Nodes n;
  settings_to_nodes(full_case(), n.nodes);
  EXPECT_EQ(n.back(smallest_case()), smallest_case());
}

TEST(SceneSettingsTest, DefaultsOfNodesAreThoseOfTheCaseFile)
{
  Nodes n;
  settings_to_nodes(smallest_case(), n.nodes);
  const CaseSettings s = parse_settings(smallest_case(), "case.json");
  auto* plan = n.nodes.plan;
  EXPECT_EQ(plan->GetSpacingMm(), s.spacing_mm);
  EXPECT_EQ(plan->GetHeadClosingMm(), s.head_closing_mm);
  EXPECT_EQ(plan->GetBoneClosingMm(), s.bone_closing_mm);
  EXPECT_EQ(plan->GetSkinThicknessMm(), s.skin_thickness_mm);
  EXPECT_EQ(plan->GetMaterials(), s.materials);
  EXPECT_EQ(plan->GetMeshDensity(), s.mesh_density);
  EXPECT_EQ(plan->GetReleaseMarginMm(), s.release_margin_mm);
  EXPECT_EQ(plan->GetContactToleranceMm(), s.contact_tolerance_mm);
  EXPECT_EQ(plan->GetThreads(), s.threads);
  EXPECT_EQ(plan->GetMaxNewtonIterations(), s.max_newton_iterations);
  EXPECT_EQ(plan->GetMaxFitIterations(), s.max_fit_iterations);
  EXPECT_EQ(plan->GetStepToleranceMm(), s.step_tolerance_mm);
  EXPECT_EQ(plan->GetPredictModel(), s.predict_model);
  EXPECT_EQ(plan->GetForceStiffness(), s.virtual_force.stiffness_n_per_mm3);
  EXPECT_EQ(plan->GetForceResidualMm(), s.virtual_force.residual_mm);
  EXPECT_EQ(plan->GetForceRestLengthMm(), s.virtual_force.rest_length_mm);
  EXPECT_EQ(plan->GetForceLoad(), s.virtual_force.load);
  EXPECT_EQ(n.nodes.target->GetScanReachMm(), s.target.scan_reach_mm);
  EXPECT_EQ(n.nodes.target->GetWarpRadiusMm(), s.target.warp_radius_mm);
  EXPECT_EQ(n.nodes.target->GetMaskMm(), s.target.mask_mm);
  EXPECT_EQ(n.nodes.osteotomy->GetNthFragmentKerfMm(0), s.osteotomies[0].kerf_mm);
}

TEST(SceneSettingsTest, StatedDefaultsAskForTheSame)
{
  json stated = smallest_case();
  stated["mesh"] = {{"density", 1}};
  stated["materials"] = "table1-stable";
  EXPECT_TRUE(same_settings(stated, smallest_case()));
  stated["mesh"]["density"] = 0.5;
  EXPECT_FALSE(same_settings(stated, smallest_case()));
}

} // namespace
} // namespace f2b::test
