#include "Scene/input_files.hpp"

#include "Case/case_folder.hpp"
#include "Scene/case_publisher.hpp"
#include "Scene/movement_text.hpp"
#include "Scene/shown_cuts.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLStorageNode.h>
#include <vtkMRMLVolumeNode.h>

#include <nlohmann/json.hpp>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;
using nlohmann::json;

/// The file that holds what the node does.
std::string file_of(vtkMRMLStorableNode* node, const Path& folder, const char* name)
{
  vtkMRMLStorageNode* storage = node->GetStorageNode();
  if (storage && storage->GetFileName() && !node->GetModifiedSinceRead())
  {
    const fs::path file = storage->GetFullNameFromFileName();
    if (fs::exists(file))
      return file.string();
  }
  const fs::path inputs = folder.string() + "-input";
  fs::create_directories(inputs);
  write_node(node, inputs / name);
  return (inputs / name).string();
}

/// A node that the user chose, not one that a step made.
vtkMRMLStorableNode* chosen(vtkMRMLNode* node)
{
  return node && !node->GetAttribute(published_file_attribute)
             ? vtkMRMLStorableNode::SafeDownCast(node)
             : nullptr;
}

} // namespace

void write_input_nodes(const CaseNodes& nodes, const fs::path& folder)
{
  if (auto* volume = chosen(nodes.plan->GetInputVolumeNode()))
    nodes.plan->SetVolumeFileName(file_of(volume, folder, "ct.nrrd"));
  if (auto* landmarks = chosen(nodes.plan->GetLandmarksNode()))
    nodes.plan->SetLandmarksFileName(file_of(landmarks, folder, "landmarks.mrk.json"));
  write_warp_nodes(nodes, folder);
}

void write_warp_nodes(const CaseNodes& nodes, const fs::path& folder)
{
  vtkMRMLFaceToBoneTargetNode* target = nodes.target;
  if (auto* from = chosen(target->GetNodeReference(vtkMRMLFaceToBoneTargetNode::WarpFromRole)))
    target->SetWarpFromFileName(file_of(from, folder, "warp_from.mrk.json"));
  if (auto* to = chosen(target->GetNodeReference(vtkMRMLFaceToBoneTargetNode::WarpToRole)))
    target->SetWarpToFileName(file_of(to, folder, "warp_to.mrk.json"));
}

void drop_empty_target(json& document)
{
  if (!document.contains("target"))
    return;
  json& target = document["target"];
  for (const auto& [key, file_key] : {std::pair("mesh", ""), {"scan", "mesh"}, {"warp", "from"}})
    if (target.contains(key))
    {
      const json& file = *file_key ? target[key][file_key] : target[key];
      if (!file.is_string() || file.get<std::string>().empty())
        target.erase(key);
    }
  if (!target.contains("mesh") && !target.contains("scan") && !target.contains("warp") &&
      !target.contains("from_movement"))
    document.erase("target");
}

} // namespace f2b
