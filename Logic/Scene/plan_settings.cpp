#include "Scene/plan_settings.hpp"

#include "Core/error.hpp"
#include "Scene/movement_text.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>

#include <vtkNew.h>

namespace f2b
{
namespace
{

using nlohmann::json;
using Plan = vtkMRMLFaceToBonePlanNode;

/// Visits every option that is one value: visit(group, key, read, write), group "" at the top.
template <class Visit>
void visit_values(Visit&& visit)
{
#define F2B_VALUE(group, key, Name)                                                                \
  visit(                                                                                           \
      group, key, [](Plan* p) { return p->Get##Name(); },                                          \
      [](Plan* p, const auto& value) { p->Set##Name(value); })
  F2B_VALUE("", "name", CaseName);
  F2B_VALUE("", "ct", VolumeFileName);
  F2B_VALUE("", "landmarks", LandmarksFileName);
  F2B_VALUE("", "skin_thickness_mm", SkinThicknessMm);
  F2B_VALUE("", "materials", Materials);
  F2B_VALUE("segmentation", "spacing_mm", SpacingMm);
  F2B_VALUE("segmentation", "head_closing_mm", HeadClosingMm);
  F2B_VALUE("segmentation", "bone_closing_mm", BoneClosingMm);
  F2B_VALUE("mesh", "density", MeshDensity);
  F2B_VALUE("mesh", "release_margin_mm", ReleaseMarginMm);
  F2B_VALUE("mesh", "contact_tolerance_mm", ContactToleranceMm);
  F2B_VALUE("solver", "threads", Threads);
  F2B_VALUE("solver", "max_newton_iterations", MaxNewtonIterations);
  F2B_VALUE("solver", "step_tolerance_mm", StepToleranceMm);
  F2B_VALUE("solver", "max_fit_iterations", MaxFitIterations);
  F2B_VALUE("solver", "predict_model", PredictModel);
#undef F2B_VALUE
}

/// The object that a group's keys are in.
json& group_of(json& document, const std::string& group)
{
  return group.empty() ? document : document[group];
}

void thresholds_to_node(json& document, Plan* node)
{
  node->RemoveSkinThresholdHU();
  node->RemoveBoneThresholdHU();
  if (!document.contains("thresholds"))
    return;
  json& thresholds = document["thresholds"];
  json skin, bone;
  take_out(thresholds, "skin_hu", skin);
  take_out(thresholds, "bone_hu", bone);
  if (skin.is_number())
    node->SetSkinThresholdHU(skin.get<double>());
  if (bone.is_number())
    node->SetBoneThresholdHU(bone.get<double>());
}

void thresholds_from_node(Plan* node, json& document)
{
  double hu[1];
  if (node->GetSkinThresholdHU(hu))
    document["thresholds"]["skin_hu"] = hu[0];
  if (node->GetBoneThresholdHU(hu))
    document["thresholds"]["bone_hu"] = hu[0];
}

void region_to_node(json& document, Plan* node)
{
  json region;
  take_out(document, "region_ras", region);
  if (region.is_null())
    return node->RemoveRegion();
  double box[6];
  for (std::size_t a = 0; a < 3; ++a)
  {
    box[a] = region.at("min").at(a).get<double>();
    box[3 + a] = region.at("max").at(a).get<double>();
  }
  node->SetRegion(box);
}

void region_from_node(Plan* node, json& document)
{
  double box[6];
  if (node->GetRegion(box))
    document["region_ras"] = {{"min", {box[0], box[1], box[2]}}, {"max", {box[3], box[4], box[5]}}};
}

constexpr const char* stiffness_key = "stiffness_n_per_mm3";

void force_to_node(json& document, Plan* node)
{
  const vtkNew<Plan> defaults;
  json none = json::object();
  const bool has = document.contains("solver") && document["solver"].contains("virtual_force");
  json& force = has ? document["solver"]["virtual_force"] : none;
  json stiffness = defaults->GetForceStiffness();
  double residual = defaults->GetForceResidualMm(), rest_length = defaults->GetForceRestLengthMm();
  std::string load = defaults->GetForceLoad();
  std::vector<std::string> landmarks;
  take_out(force, stiffness_key, stiffness);
  take_out(force, "residual_mm", residual);
  take_out(force, "rest_length_mm", rest_length);
  take_out(force, "load", load);
  take_out(force, "landmarks", landmarks);
  node->SetForceStiffnessAutomatic(stiffness.is_string());
  node->SetForceStiffness(stiffness.is_number() ? stiffness.get<double>()
                                                : defaults->GetForceStiffness());
  node->SetForceResidualMm(residual);
  node->SetForceRestLengthMm(rest_length);
  node->SetForceLoad(load);
  node->SetForceLandmarks(landmarks);
}

void force_from_node(Plan* node, json& document)
{
  const vtkNew<Plan> defaults;
  json force = json::object();
  if (node->GetForceStiffnessAutomatic())
    force[stiffness_key] = "auto";
  else
    put(force, stiffness_key, node->GetForceStiffness(), defaults->GetForceStiffness());
  put(force, "residual_mm", node->GetForceResidualMm(), defaults->GetForceResidualMm());
  put(force, "rest_length_mm", node->GetForceRestLengthMm(), defaults->GetForceRestLengthMm());
  put(force, "load", node->GetForceLoad(), defaults->GetForceLoad());
  put(force, "landmarks", node->GetForceLandmarks(), defaults->GetForceLandmarks());
  if (!force.empty())
    document["solver"]["virtual_force"].update(force);
}

/// Groups of which everything was taken out.
void drop_empty(json& object)
{
  for (auto member = object.begin(); member != object.end();)
  {
    if (member->is_object())
      drop_empty(*member);
    member = member->is_object() && member->empty() ? object.erase(member) : std::next(member);
  }
}

} // namespace

std::string text_of_rest(json object)
{
  drop_empty(object);
  return object.empty() ? std::string() : object.dump();
}

json rest_from_text(const std::string& text)
{
  if (text.empty())
    return json::object();
  json object = json::parse(text, nullptr, false);
  if (!object.is_object())
    throw Error("OtherSettings", "'" + text + "' is no JSON object",
                "write it in the form of the case file, or empty it");
  return object;
}

void plan_to_node(json document, Plan* node)
{
  MRMLNodeModifyBlocker blocker(node);
  const vtkNew<Plan> defaults;
  visit_values(
      [&](const char* group, const char* key, const auto& read, const auto& write)
      {
        auto value = read(defaults.Get());
        if (*group == '\0' || document.contains(group))
          take_out(group_of(document, group), key, value);
        write(node, value);
      });
  thresholds_to_node(document, node);
  region_to_node(document, node);
  force_to_node(document, node);
  json movements = json::object();
  take_out(document, "predict", movements);
  node->RemoveStatedMovements();
  for (const auto& [fragment, movement] : movements.items())
    node->SetStatedMovement(fragment, coordinates_from(movement).data());
  node->SetOtherSettings(text_of_rest(document));
}

json plan_from_node(Plan* node)
{
  const vtkNew<Plan> defaults;
  json document = rest_from_text(node->GetOtherSettings());
  visit_values(
      [&](const char* group, const char* key, const auto& read, const auto&)
      {
        if (read(node) != read(defaults.Get()))
          group_of(document, group)[key] = read(node);
      });
  thresholds_from_node(node, document);
  region_from_node(node, document);
  force_from_node(node, document);
  for (const std::string& fragment : node->GetStatedMovementFragments())
  {
    SixCoordinates six{};
    node->GetStatedMovement(fragment, six.data());
    document["predict"][fragment] = to_movement_json(six);
  }
  return document;
}

} // namespace f2b
