#pragma once

#include "temporary_folder.hpp"

#include <vtkMRMLMessageCollection.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLScene.h>
#include <vtkMRMLStorageNode.h>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <string>

namespace f2b::test
{

/// No VTK warnings on the screen while it lives: tests that expect errors make many.
class QuietVtk
{
public:
  QuietVtk() : m_before(vtkObject::GetGlobalWarningDisplay())
  {
    vtkObject::GlobalWarningDisplayOff();
  }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(m_before); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

private:
  int m_before;
};

/// Counts an event of an object.
class EventCounter
{
public:
  EventCounter(vtkObject* object, unsigned long event)
  {
    m_command->SetClientData(this);
    m_command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
                           { ++static_cast<EventCounter*>(self)->count; });
    object->AddObserver(event, m_command);
  }
  ~EventCounter() { m_command->SetClientData(nullptr), m_command->SetCallback(nullptr); }
  EventCounter(const EventCounter&) = delete;
  EventCounter& operator=(const EventCounter&) = delete;

  int count = 0;

private:
  vtkNew<vtkCallbackCommand> m_command;
};

template <class Node>
Node* add_node(vtkMRMLScene* scene, const std::string& name = "")
{
  vtkNew<Node> node;
  if (!name.empty())
  {
    node->SetName(name.c_str());
  }
  return Node::SafeDownCast(scene->AddNode(node));
}

inline vtkSmartPointer<vtkPolyData> sphere(int resolution = 12, double radius = 40.0)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetCenter(10.0, -20.0, 30.0);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return source->GetOutput();
}

/// A model with a display node.
inline vtkMRMLModelNode* add_model(vtkMRMLScene* scene, const std::string& name,
                                   vtkPolyData* surface = nullptr)
{
  auto* model = add_node<vtkMRMLModelNode>(scene, name);
  model->SetAndObservePolyData(surface ? surface : sphere().Get());
  model->CreateDefaultDisplayNodes();
  return model;
}

/// Writes the node's data to a file of the folder.
inline bool save_data(vtkMRMLStorableNode* node, const std::filesystem::path& file)
{
  node->AddDefaultStorageNode();
  node->GetStorageNode()->SetFileName(file.string().c_str());
  return node->GetStorageNode()->WriteData(node) != 0;
}

inline bool save_scene(vtkMRMLScene* scene, const std::filesystem::path& file)
{
  scene->SetURL(file.string().c_str());
  return scene->Commit() != 0;
}

/// \return the messages; empty where it was read whole
inline std::string load_scene(vtkMRMLScene* scene, const std::filesystem::path& file)
{
  vtkNew<vtkMRMLMessageCollection> messages;
  scene->SetURL(file.string().c_str());
  const int read = scene->Connect(messages);
  const std::string text = messages->GetAllMessagesAsString();
  return read ? "" : text.empty() ? "not read" : text;
}

/// The scene as XML, without a file.
inline std::string scene_text(vtkMRMLScene* scene)
{
  scene->SetSaveToXMLString(1);
  scene->Commit();
  scene->SetSaveToXMLString(0);
  return scene->GetSceneXMLString();
}

inline int import_text(vtkMRMLScene* scene, const std::string& xml)
{
  scene->SetLoadFromXMLString(1);
  scene->SetSceneXMLString(xml);
  const int read = scene->Import();
  scene->SetLoadFromXMLString(0);
  return read;
}

} // namespace f2b::test
