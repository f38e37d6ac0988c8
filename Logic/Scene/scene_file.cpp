#include "Scene/scene_file.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/vtk_messages.hpp"
#include "Core/error.hpp"
#include "Scene/case_publisher.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLScene.h>

#include <nlohmann/json.hpp>

#include <vtkCollection.h>

#include <cstdint>
#include <fstream>

namespace f2b
{
namespace
{

using Plan = vtkMRMLFaceToBonePlanNode;

/// What case.json was when the scene was written.
constexpr const char* digest_attribute = "FaceToBone.SettingsDigest";

/// FNV-1a of a file's bytes: tells an edited file from an untouched one, wherever it is copied.
std::string digest_of(const Path& file)
{
  std::ifstream bytes(file, std::ios::binary);
  std::uint64_t digest = 14695981039346656037u;
  for (std::istreambuf_iterator<char> byte(bytes), end; byte != end; ++byte)
    digest = (digest ^ static_cast<unsigned char>(*byte)) * 1099511628211u;
  return std::to_string(digest);
}

Path absolute_folder(const Plan* plan, const Path& root)
{
  const std::string stated = const_cast<Plan*>(plan)->GetCaseFolder();
  return stated.empty() ? Path() : std::filesystem::weakly_canonical(root / stated);
}

/// The plan of a folder among nodes that were just added; its osteotomy and target may be missing.
Plan* plan_of_folder(vtkMRMLScene* scene, const std::vector<vtkMRMLNode*>& known,
                     const Path& folder)
{
  std::vector<vtkMRMLNode*> plans;
  scene->GetNodesByClass("vtkMRMLFaceToBonePlanNode", plans);
  for (vtkMRMLNode* node : plans)
    if (std::find(known.begin(), known.end(), node) == known.end())
      if (auto* plan = Plan::SafeDownCast(node); absolute_folder(plan, folder) == folder)
        return plan;
  return nullptr;
}

/// Reads case.mrml without the files that it names; whether it could be parsed shows in the nodes.
void import_nodes(vtkMRMLScene* scene, const Path& file)
{
  const std::string root = scene->GetRootDirectory() ? scene->GetRootDirectory() : "";
  const std::string url = scene->GetURL() ? scene->GetURL() : "";
  const int read_data = scene->GetReadDataOnLoad();
  {
    // Slicer calls data that it was told not to read an error
    const VtkMessages quiet;
    scene->SetReadDataOnLoad(0);
    scene->SetURL(file.c_str());
    scene->Import();
  }
  scene->SetReadDataOnLoad(read_data);
  scene->SetURL(url.c_str());
  scene->SetRootDirectory(root.c_str());
}

/// The plan of case.mrml with what it needs, or new nodes.
CaseNodes imported(const CaseOutlook& files, vtkMRMLScene* scene)
{
  const Path file = files.folder / case_scene_name;
  std::vector<vtkMRMLNode*> known;
  scene->GetNodesByClass("vtkMRMLFaceToBonePlanNode", known);
  if (std::filesystem::exists(file))
    import_nodes(scene, file);
  Plan* plan = plan_of_folder(scene, known, files.folder);
  if (plan && plan->GetOsteotomyNode() && plan->GetTargetNode())
    return CaseNodes::of(plan);
  return add_case_nodes(scene, "Plan");
}

} // namespace

CaseNodes add_case_nodes(vtkMRMLScene* scene, const std::string& name)
{
  CaseNodes nodes;
  nodes.plan = Plan::SafeDownCast(scene->AddNewNodeByClass("vtkMRMLFaceToBonePlanNode", name));
  nodes.osteotomy = vtkMRMLFaceToBoneOsteotomyNode::SafeDownCast(
      scene->AddNewNodeByClass("vtkMRMLFaceToBoneOsteotomyNode", name + " osteotomy"));
  nodes.target = vtkMRMLFaceToBoneTargetNode::SafeDownCast(
      scene->AddNewNodeByClass("vtkMRMLFaceToBoneTargetNode", name + " target"));
  if (!nodes.plan || !nodes.osteotomy || !nodes.target)
    throw std::runtime_error("the scene does not know FaceToBone's nodes");
  nodes.plan->SetOsteotomyNodeID(nodes.osteotomy->GetID());
  nodes.plan->SetTargetNodeID(nodes.target->GetID());
  return nodes;
}

CaseNodes open_case_scene(const CaseOutlook& files, vtkMRMLScene* scene, bool read_data)
{
  const CaseNodes nodes = imported(files, scene);
  const Path settings = files.file(case_settings_name);
  const char* digest = nodes.plan->GetAttribute(digest_attribute);
  if (!digest || digest_of(settings) != digest)
    settings_to_nodes(read_json(settings), nodes);
  publish_case(files, scene, nodes, read_data);
  return nodes;
}

std::string case_scene_text(const CaseOutlook& files, vtkMRMLScene* classes)
{
  const auto scene = vtkSmartPointer<vtkMRMLScene>::New();
  for (int i = 0; i < classes->GetNumberOfRegisteredNodeClasses(); ++i)
    if (vtkMRMLNode* node = classes->GetNthRegisteredNodeClass(i);
        node && !scene->IsNodeClassRegistered(node->GetClassName()))
      scene->RegisterNodeClass(node);
  scene->SetRootDirectory(files.folder.c_str());
  const CaseNodes nodes = imported(files, scene);
  const Path settings = files.file(case_settings_name);
  settings_to_nodes(read_json(settings), nodes);
  publish_case(files, scene, nodes, false);
  nodes.plan->SetAttribute(digest_attribute, digest_of(settings).c_str());
  nodes.plan->SetStatusCode(0);
  nodes.plan->SetStatusText("");
  scene->SetRootDirectory(files.folder.c_str());
  scene->SetSaveToXMLString(1);
  if (!scene->Commit())
    throw Error((files.folder / case_scene_name).string(), "the scene cannot be written",
                "remove the file: it is made anew");
  return scene->GetSceneXMLString();
}

} // namespace f2b
