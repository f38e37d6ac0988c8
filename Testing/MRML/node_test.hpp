#pragma once

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>

#include <vtkMRMLScene.h>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <sstream>

/// What do tests of nodes share? GoogleTest and MRML only: they also run on Slicer's own MRMLCore.
namespace f2b::test
{

/// A scene that knows our nodes, as the module's logic sees to.
inline vtkSmartPointer<vtkMRMLScene> scene_with_our_nodes()
{
  const auto scene = vtkSmartPointer<vtkMRMLScene>::New();
  scene->RegisterNodeClass(vtkNew<vtkMRMLFaceToBoneTargetNode>());
  scene->RegisterNodeClass(vtkNew<vtkMRMLFaceToBoneOsteotomyNode>());
  scene->RegisterNodeClass(vtkNew<vtkMRMLFaceToBonePlanNode>());
  return scene;
}

template <class Node>
Node* add_node(vtkMRMLScene* scene, const char* name)
{
  return Node::SafeDownCast(scene->AddNewNodeByClass(vtkNew<Node>()->GetClassName(), name));
}

/// The node of a class and name, which must be there once.
template <class Node>
Node* node_named(vtkMRMLScene* scene, const char* name)
{
  return Node::SafeDownCast(scene->GetFirstNode(name, vtkNew<Node>()->GetClassName()));
}

/// The scene as text, and a scene from text.
inline std::string saved(vtkMRMLScene* scene)
{
  scene->SetSaveToXMLString(1);
  EXPECT_EQ(scene->Commit(), 1);
  return scene->GetSceneXMLString();
}

inline void load(vtkMRMLScene* scene, const std::string& text)
{
  scene->SetLoadFromXMLString(1);
  scene->SetSceneXMLString(text);
  EXPECT_EQ(scene->Connect(), 1);
}

inline void import(vtkMRMLScene* scene, const std::string& text)
{
  scene->SetLoadFromXMLString(1);
  scene->SetSceneXMLString(text);
  EXPECT_EQ(scene->Import(), 1);
}

/// The attributes that a node writes.
inline std::string xml_of(vtkMRMLNode* node)
{
  std::ostringstream text;
  node->WriteXML(text, 0);
  return text.str();
}

/// Counts an object's events while it lives.
class EventCount
{
public:
  EventCount(vtkObject* object, unsigned long event) : m_object(object)
  {
    m_callback->SetClientData(&m_count);
    m_callback->SetCallback([](vtkObject*, unsigned long, void* count, void*)
                            { ++*static_cast<int*>(count); });
    m_tag = m_object->AddObserver(event, m_callback);
  }
  ~EventCount() { m_object->RemoveObserver(m_tag); }
  EventCount(const EventCount&) = delete;
  EventCount& operator=(const EventCount&) = delete;

  /// Since it was last asked.
  int taken()
  {
    const int count = m_count;
    m_count = 0;
    return count;
  }

private:
  vtkSmartPointer<vtkObject> m_object;
  vtkNew<vtkCallbackCommand> m_callback;
  unsigned long m_tag = 0;
  int m_count = 0;
};

} // namespace f2b::test
