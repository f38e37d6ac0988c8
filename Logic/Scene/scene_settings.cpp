#include "Scene/scene_settings.hpp"

#include "Core/error.hpp"
#include "Scene/movement_text.hpp"
#include "Scene/osteotomy_settings.hpp"
#include "Scene/plan_settings.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>

#include <vtkNew.h>

namespace f2b
{

using nlohmann::json;

CaseNodes CaseNodes::of(vtkMRMLFaceToBonePlanNode* plan)
{
  if (!plan)
    throw Error("FaceToBone", "there is no plan", "create or select one");
  const CaseNodes nodes = {plan, plan->GetOsteotomyNode(), plan->GetTargetNode()};
  if (!nodes.osteotomy || !nodes.target)
    throw Error(plan->GetName() ? plan->GetName() : "the plan",
                std::string("it names no ") + (nodes.target ? "osteotomy" : "target"),
                "create or select one");
  return nodes;
}

namespace
{

using Target = vtkMRMLFaceToBoneTargetNode;

void target_to_node(json target, Target* node)
{
  const vtkNew<Target> defaults;
  std::string mesh, scan, from, to;
  double reach = defaults->GetScanReachMm(), radius = defaults->GetWarpRadiusMm(),
         mask = defaults->GetMaskMm();
  json movements = json::object();
  take_out(target, "mesh", mesh);
  take_out(target, "mask_mm", mask);
  take_out(target, "from_movement", movements);
  if (target.contains("scan"))
  {
    take_out(target["scan"], "mesh", scan);
    take_out(target["scan"], "reach_mm", reach);
  }
  if (target.contains("warp"))
  {
    take_out(target["warp"], "from", from);
    take_out(target["warp"], "to", to);
    take_out(target["warp"], "radius_mm", radius);
  }
  MRMLNodeModifyBlocker blocker(node);
  node->SetKind(!mesh.empty()   ? Target::Mesh
                : !scan.empty() ? Target::Scan
                : !from.empty() ? Target::Warp
                                : Target::Movement);
  node->SetMeshFileName(mesh);
  node->SetScanFileName(scan);
  node->SetWarpFromFileName(from);
  node->SetWarpToFileName(to);
  node->SetScanReachMm(reach);
  node->SetWarpRadiusMm(radius);
  node->SetMaskMm(mask);
  node->RemoveMovements();
  for (const auto& [fragment, movement] : movements.items())
    node->SetMovement(fragment, coordinates_from(movement).data());
  node->SetOtherSettings(text_of_rest(target));
}

json target_from_node(Target* node)
{
  const vtkNew<Target> defaults;
  json target = rest_from_text(node->GetOtherSettings());
  switch (node->GetKind())
  {
  case Target::Mesh:
    target["mesh"] = node->GetMeshFileName();
    break;
  case Target::Scan:
    target["scan"]["mesh"] = node->GetScanFileName();
    put(target["scan"], "reach_mm", node->GetScanReachMm(), defaults->GetScanReachMm());
    break;
  case Target::Warp:
    target["warp"]["from"] = node->GetWarpFromFileName();
    target["warp"]["to"] = node->GetWarpToFileName();
    put(target["warp"], "radius_mm", node->GetWarpRadiusMm(), defaults->GetWarpRadiusMm());
    break;
  default:
    for (const std::string& fragment : node->GetMovementFragments())
    {
      SixCoordinates six{};
      node->GetMovement(fragment, six.data());
      target["from_movement"][fragment] = to_movement_json(six);
    }
  }
  put(target, "mask_mm", node->GetMaskMm(), defaults->GetMaskMm());
  return target;
}

} // namespace

void settings_to_nodes(json document, const CaseNodes& nodes)
{
  json osteotomies = json::array(), target = json::object();
  take_out(document, "osteotomies", osteotomies);
  take_out(document, "target", target);
  document.erase("schema");
  osteotomies_to_node(osteotomies, nodes.osteotomy);
  target_to_node(std::move(target), nodes.target);
  plan_to_node(std::move(document), nodes.plan);
}

json settings_from_nodes(const CaseNodes& nodes)
{
  json document = plan_from_node(nodes.plan);
  document["schema"] = "facetobone-case/1";
  document["osteotomies"] = osteotomies_from_node(nodes.osteotomy);
  if (json target = target_from_node(nodes.target); !target.empty())
    document["target"] = std::move(target);
  return document;
}

json canonical_settings(const json& document)
{
  const vtkNew<vtkMRMLFaceToBonePlanNode> plan;
  const vtkNew<vtkMRMLFaceToBoneOsteotomyNode> osteotomy;
  const vtkNew<Target> target;
  const CaseNodes nodes = {plan, osteotomy, target};
  settings_to_nodes(document, nodes);
  return settings_from_nodes(nodes);
}

bool same_settings(const json& a, const json& b)
{
  return canonical_settings(a) == canonical_settings(b);
}

} // namespace f2b
