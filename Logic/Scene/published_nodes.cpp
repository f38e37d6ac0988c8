#include "Scene/published_nodes.hpp"

#include "Core/error.hpp"
#include "Scene/case_publisher.hpp"

#include <vtkMRMLDisplayNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLScene.h>
#include <vtkMRMLStorageNode.h>

#include <algorithm>

namespace f2b
{
namespace
{

/// Slicer's own table; a scene names it without holding it.
constexpr const char* diverging_colors_id = "vtkMRMLColorTableNodeFileDivergingBlueRed.txt";

std::string stamp_of(const Path& file)
{
  std::error_code none;
  const auto time = std::filesystem::last_write_time(file, none);
  return none ? std::string() : std::to_string(time.time_since_epoch().count());
}

void set_look(vtkMRMLDisplayNode* display, const ModelLook& look)
{
  display->SetColor(look.red, look.green, look.blue);
  display->SetOpacity(look.opacity);
  display->SetVisibility(look.visible);
}

/// Removes a node with the nodes that serve it alone.
void remove_with_servants(vtkMRMLScene* scene, vtkMRMLStorableNode* node)
{
  std::vector<vtkSmartPointer<vtkMRMLNode>> servants;
  if (node->GetStorageNode())
    servants.emplace_back(node->GetStorageNode());
  if (auto* displayable = vtkMRMLDisplayableNode::SafeDownCast(node))
    for (int i = 0; i < displayable->GetNumberOfDisplayNodes(); ++i)
      if (displayable->GetNthDisplayNode(i))
        servants.emplace_back(displayable->GetNthDisplayNode(i));
  scene->RemoveNode(node);
  for (const auto& servant : servants)
    if (scene->IsNodePresent(servant))
      scene->RemoveNode(servant);
}

} // namespace

vtkMRMLStorableNode* PublishedNodes::make(const char* class_name, const std::string& name)
{
  auto* node = vtkMRMLStorableNode::SafeDownCast(m_scene->AddNewNodeByClass(class_name, name));
  if (!node)
    throw std::runtime_error(std::string("the scene knows no ") + class_name);
  if (auto* displayable = vtkMRMLDisplayableNode::SafeDownCast(node))
    displayable->CreateDefaultDisplayNodes();
  return node;
}

void PublishedNodes::point_to_file(vtkMRMLStorableNode* node, const std::string& file)
{
  node->SetAttribute(published_file_attribute, file.c_str());
  if (!node->GetStorageNode())
    node->AddDefaultStorageNode();
  vtkMRMLStorageNode* storage = node->GetStorageNode();
  if (!storage)
    throw std::runtime_error("the scene cannot store " + file);
  storage->SetFileName((m_files.folder / file).c_str());
  if (!m_read_data)
    return;
  const std::string stamp = stamp_of(m_files.folder / file);
  const char* known = node->GetAttribute(published_time_attribute);
  if (known && stamp == known)
    return;
  if (!storage->ReadData(node))
    throw Error((m_files.folder / file).string(), "it cannot be read into the scene",
                "do the step that made it anew");
  node->SetAttribute(published_time_attribute, stamp.c_str());
}

vtkMRMLStorableNode* PublishedNodes::show(vtkMRMLNode* owner, const std::string& role,
                                          const std::string& file, const char* class_name,
                                          const std::string& name, int index)
{
  m_made_new = false;
  if (!m_files.has(file))
  {
    hide(owner, role, index);
    return nullptr;
  }
  auto* node = vtkMRMLStorableNode::SafeDownCast(owner->GetNthNodeReference(role.c_str(), index));
  if (node && !node->GetAttribute(published_file_attribute))
    return node; // the user's own, which the step has read
  if (node && node->GetClassName() != std::string(class_name)) // an open curve that was closed
  {
    hide(owner, role, index);
    node = nullptr;
  }
  if (!node)
  {
    node = make(class_name, name);
    m_made_new = true;
    owner->SetNthNodeReferenceID(role.c_str(), index, node->GetID());
  }
  point_to_file(node, file);
  return node;
}

vtkMRMLModelNode* PublishedNodes::show_model(vtkMRMLNode* owner, const std::string& role,
                                             const std::string& file, const std::string& name,
                                             const ModelLook& look)
{
  auto* model = vtkMRMLModelNode::SafeDownCast(show(owner, role, file, "vtkMRMLModelNode", name));
  if (model && m_made_new && model->GetDisplayNode())
    set_look(model->GetDisplayNode(), look);
  return model;
}

void PublishedNodes::hide(vtkMRMLNode* owner, const std::string& role, int first)
{
  for (int i = owner->GetNumberOfNodeReferences(role.c_str()) - 1; i >= first; --i)
  {
    auto* node = vtkMRMLStorableNode::SafeDownCast(owner->GetNthNodeReference(role.c_str(), i));
    if (node && !node->GetAttribute(published_file_attribute))
      continue; // the user's own
    owner->RemoveNthNodeReferenceID(role.c_str(), i);
    if (node)
      remove_with_servants(m_scene, node);
  }
}

void PublishedNodes::hide_others(vtkMRMLNode* owner, const std::string& beginning,
                                 const std::vector<std::string>& names)
{
  std::vector<std::string> roles;
  owner->GetNodeReferenceRoles(roles);
  for (const std::string& role : roles)
    if (role.compare(0, beginning.size(), beginning) == 0 &&
        std::find(names.begin(), names.end(), role.substr(beginning.size())) == names.end())
      hide(owner, role);
}

void show_signed_distances(vtkMRMLModelNode* model, const char* array, double range_mm)
{
  vtkMRMLDisplayNode* display = model->GetDisplayNode();
  if (!display)
    return;
  MRMLNodeModifyBlocker blocker(display);
  display->SetAndObserveColorNodeID(diverging_colors_id);
  display->SetActiveScalarName(array);
  display->SetScalarRangeFlag(vtkMRMLDisplayNode::UseManualScalarRange);
  display->SetScalarRange(-range_mm, range_mm);
  display->SetScalarVisibility(1);
}

} // namespace f2b
