// vtkMRMLScene's node classes: registered ones, defaults, and the way from a tag to a node.
#include "vtkMRMLNode.h"
#include "vtkMRMLScene.h"

#include "vtkMRMLColorTableNode.h"
#include "vtkMRMLColorTableStorageNode.h"
#include "vtkMRMLLabelMapVolumeDisplayNode.h"
#include "vtkMRMLLabelMapVolumeNode.h"
#include "vtkMRMLLinearTransformNode.h"
#include "vtkMRMLMarkupsClosedCurveNode.h"
#include "vtkMRMLMarkupsCurveNode.h"
#include "vtkMRMLMarkupsDisplayNode.h"
#include "vtkMRMLMarkupsFiducialDisplayNode.h"
#include "vtkMRMLMarkupsFiducialNode.h"
#include "vtkMRMLMarkupsJsonStorageNode.h"
#include "vtkMRMLMarkupsPlaneDisplayNode.h"
#include "vtkMRMLMarkupsPlaneJsonStorageNode.h"
#include "vtkMRMLMarkupsPlaneNode.h"
#include "vtkMRMLModelDisplayNode.h"
#include "vtkMRMLModelNode.h"
#include "vtkMRMLModelStorageNode.h"
#include "vtkMRMLScalarVolumeDisplayNode.h"
#include "vtkMRMLScalarVolumeNode.h"
#include "vtkMRMLTransformDisplayNode.h"
#include "vtkMRMLTransformNode.h"
#include "vtkMRMLTransformStorageNode.h"
#include "vtkMRMLVolumeArchetypeStorageNode.h"

#include <vtkCollection.h>

#include <algorithm>

void vtkMRMLScene::RegisterOwnNodeClasses()
{
  const auto add = [this](vtkSmartPointer<vtkMRMLNode> node) { this->RegisterNodeClass(node); };
  add(vtkSmartPointer<vtkMRMLColorTableNode>::New());
  add(vtkSmartPointer<vtkMRMLColorTableStorageNode>::New());
  add(vtkSmartPointer<vtkMRMLLabelMapVolumeDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLLabelMapVolumeNode>::New());
  add(vtkSmartPointer<vtkMRMLLinearTransformNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsClosedCurveNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsCurveNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsFiducialDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsFiducialNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsJsonStorageNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsPlaneDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsPlaneJsonStorageNode>::New());
  add(vtkSmartPointer<vtkMRMLMarkupsPlaneNode>::New());
  add(vtkSmartPointer<vtkMRMLModelDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLModelNode>::New());
  add(vtkSmartPointer<vtkMRMLModelStorageNode>::New());
  add(vtkSmartPointer<vtkMRMLScalarVolumeDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLScalarVolumeNode>::New());
  add(vtkSmartPointer<vtkMRMLTransformDisplayNode>::New());
  add(vtkSmartPointer<vtkMRMLTransformNode>::New());
  add(vtkSmartPointer<vtkMRMLTransformStorageNode>::New());
  add(vtkSmartPointer<vtkMRMLVolumeArchetypeStorageNode>::New());
  this->RegisterAbstractNodeClass("vtkMRMLVolumeNode", "Volume");
  this->RegisterAbstractNodeClass("vtkMRMLMarkupsNode", "Markup");
}

void vtkMRMLScene::RegisterNodeClass(vtkMRMLNode* node)
{
  this->RegisterNodeClass(node, nullptr);
}

void vtkMRMLScene::RegisterNodeClass(vtkMRMLNode* node, const char* tagName)
{
  if (!node)
  {
    return;
  }
  const std::string tag = tagName ? tagName : node->GetNodeTagName();
  auto& classes = this->RegisteredClasses;
  classes.erase(std::remove_if(classes.begin(), classes.end(),
                               [&tag](const RegisteredClass& one) { return one.Tag == tag; }),
                classes.end());
  classes.push_back({tag, node});
  this->InvokeEvent(NodeClassRegisteredEvent);
}

void vtkMRMLScene::RegisterAbstractNodeClass(std::string className, std::string typeDisplayName)
{
  this->AbstractClasses[className] = typeDisplayName;
  this->InvokeEvent(NodeClassRegisteredEvent);
}

bool vtkMRMLScene::IsNodeClassRegistered(const std::string& className)
{
  return std::any_of(this->RegisteredClasses.begin(), this->RegisteredClasses.end(),
                     [&className](const RegisteredClass& one)
                     { return className == one.Node->GetClassName(); });
}

void vtkMRMLScene::CopyRegisteredNodesToScene(vtkMRMLScene* scene)
{
  for (const RegisteredClass& one : this->RegisteredClasses)
  {
    if (scene && !scene->GetClassNameByTag(one.Tag.c_str()))
    {
      scene->RegisterNodeClass(vtkSmartPointer<vtkMRMLNode>::Take(one.Node->CreateNodeInstance()),
                               one.Tag.c_str());
    }
  }
}

int vtkMRMLScene::GetNumberOfRegisteredNodeClasses()
{
  return static_cast<int>(this->RegisteredClasses.size());
}

vtkMRMLNode* vtkMRMLScene::GetNthRegisteredNodeClass(int n)
{
  return n < 0 || n >= this->GetNumberOfRegisteredNodeClasses()
             ? nullptr
             : this->RegisteredClasses[n].Node.Get();
}

const char* vtkMRMLScene::GetClassNameByTag(const char* tagName)
{
  for (const RegisteredClass& one : this->RegisteredClasses)
  {
    if (tagName && one.Tag == tagName)
    {
      return one.Node->GetClassName();
    }
  }
  return nullptr;
}

const char* vtkMRMLScene::GetTagByClassName(const char* className)
{
  for (const RegisteredClass& one : this->RegisteredClasses)
  {
    if (className && std::string(className) == one.Node->GetClassName())
    {
      return one.Node->GetNodeTagName();
    }
  }
  return nullptr;
}

std::string vtkMRMLScene::GetTypeDisplayNameByClassName(std::string className)
{
  for (const RegisteredClass& one : this->RegisteredClasses)
  {
    if (className == one.Node->GetClassName())
    {
      return one.Node->GetTypeDisplayName();
    }
  }
  const auto found = this->AbstractClasses.find(className);
  return found == this->AbstractClasses.end() ? "" : found->second;
}

vtkMRMLNode* vtkMRMLScene::CreateNodeByClass(const char* className)
{
  for (const RegisteredClass& one : this->RegisteredClasses)
  {
    if (className && std::string(className) == one.Node->GetClassName())
    {
      vtkMRMLNode* node = one.Node->CreateNodeInstance();
      if (vtkMRMLNode* defaults = this->GetDefaultNodeByClass(className))
      {
        node->CopyWithScene(defaults);
      }
      return node;
    }
  }
  return nullptr;
}

void vtkMRMLScene::AddDefaultNode(vtkMRMLNode* node)
{
  if (node)
  {
    this->DefaultNodes[node->GetClassName()] = node;
  }
}

vtkMRMLNode* vtkMRMLScene::GetDefaultNodeByClass(const char* className)
{
  const auto found = this->DefaultNodes.find(className ? className : "");
  return found == this->DefaultNodes.end() ? nullptr : found->second.Get();
}

void vtkMRMLScene::RemoveAllDefaultNodes()
{
  this->DefaultNodes.clear();
}
