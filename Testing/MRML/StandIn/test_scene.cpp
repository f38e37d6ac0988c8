// What a scene promises about its nodes, their ids and references. Only Slicer's interface is used.
#include "scene_test.hpp"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsFiducialNode.h>
#include <vtkMRMLScalarVolumeNode.h>

#include <vtkCollection.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkWeakPointer.h>

using namespace f2b::test;

namespace
{

const char* const role = "moved";

} // namespace

TEST(SceneTest, NodesGetIdsAndNames)
{
  vtkNew<vtkMRMLScene> scene;
  auto* first = add_node<vtkMRMLModelNode>(scene);
  auto* second = add_node<vtkMRMLModelNode>(scene);
  EXPECT_STREQ("vtkMRMLModelNode1", first->GetID());
  EXPECT_STREQ("vtkMRMLModelNode2", second->GetID());
  EXPECT_STREQ("Model", first->GetName());
  EXPECT_STREQ("Model_1", second->GetName());
  EXPECT_EQ(first, scene->GetNodeByID("vtkMRMLModelNode1"));
  EXPECT_EQ(nullptr, scene->GetNodeByID("vtkMRMLModelNode3"));
}

TEST(SceneTest, NodesAreFoundByClassAndName)
{
  vtkNew<vtkMRMLScene> scene;
  auto* skin = add_model(scene, "skin");
  auto* bone = add_model(scene, "bone");
  EXPECT_EQ(2, scene->GetNumberOfNodesByClass("vtkMRMLModelNode"));
  EXPECT_EQ(2, scene->GetNumberOfNodesByClass("vtkMRMLDisplayableNode"));
  EXPECT_EQ(bone, scene->GetNthNodeByClass(1, "vtkMRMLModelNode"));
  EXPECT_EQ(nullptr, scene->GetNthNodeByClass(2, "vtkMRMLModelNode"));
  EXPECT_EQ(skin, scene->GetFirstNodeByClass("vtkMRMLModelNode"));
  EXPECT_EQ(bone, scene->GetFirstNodeByName("bone"));
  EXPECT_EQ(nullptr, scene->GetFirstNodeByName("fat"));
  const auto found = vtkSmartPointer<vtkCollection>::Take(scene->GetNodesByName("skin"));
  EXPECT_EQ(1, found->GetNumberOfItems());
}

TEST(SceneTest, NewNodesByClass)
{
  vtkNew<vtkMRMLScene> scene;
  vtkMRMLNode* node = scene->AddNewNodeByClass("vtkMRMLScalarVolumeNode", "CT");
  ASSERT_NE(nullptr, node);
  EXPECT_STREQ("CT", node->GetName());
  EXPECT_TRUE(node->IsA("vtkMRMLScalarVolumeNode"));
  const QuietVtk quiet;
  EXPECT_EQ(nullptr, scene->AddNewNodeByClass("vtkMRMLNoSuchNode"));
}

TEST(SceneTest, EventsOfAddingAndRemoving)
{
  vtkNew<vtkMRMLScene> scene;
  const EventCounter before(scene, vtkMRMLScene::NodeAboutToBeAddedEvent);
  const EventCounter added(scene, vtkMRMLScene::NodeAddedEvent);
  const EventCounter goes(scene, vtkMRMLScene::NodeAboutToBeRemovedEvent);
  const EventCounter gone(scene, vtkMRMLScene::NodeRemovedEvent);
  auto* node = add_node<vtkMRMLModelNode>(scene);
  EXPECT_EQ(1, before.count);
  EXPECT_EQ(1, added.count);
  scene->RemoveNode(node);
  EXPECT_EQ(1, goes.count);
  EXPECT_EQ(1, gone.count);
}

TEST(SceneTest, BatchesNestAndTellOnce)
{
  vtkNew<vtkMRMLScene> scene;
  const EventCounter start(scene, vtkMRMLScene::StartBatchProcessEvent);
  const EventCounter end(scene, vtkMRMLScene::EndBatchProcessEvent);
  scene->StartState(vtkMRMLScene::BatchProcessState);
  scene->StartState(vtkMRMLScene::ImportState);
  EXPECT_TRUE(scene->IsBatchProcessing());
  EXPECT_TRUE(scene->IsImporting());
  EXPECT_FALSE(scene->IsClosing());
  scene->EndState(vtkMRMLScene::ImportState);
  EXPECT_EQ(0, end.count);
  scene->EndState(vtkMRMLScene::BatchProcessState);
  EXPECT_EQ(1, start.count);
  EXPECT_EQ(1, end.count);
  EXPECT_FALSE(scene->IsBatchProcessing());
}

TEST(SceneTest, SingletonsAreOverwritten)
{
  vtkNew<vtkMRMLScene> scene;
  vtkNew<vtkMRMLModelNode> first;
  first->SetSingletonTag("skin");
  first->SetName("old");
  scene->AddNode(first);
  vtkNew<vtkMRMLModelNode> second;
  second->SetSingletonTag("skin");
  second->SetName("new");
  EXPECT_EQ(first.Get(), scene->AddNode(second));
  EXPECT_EQ(1, scene->GetNumberOfNodes());
  EXPECT_STREQ("new", first->GetName());
  EXPECT_STREQ("vtkMRMLModelNodeskin", first->GetID());
}

TEST(SceneTest, ReferencesFollowTheNode)
{
  vtkNew<vtkMRMLScene> scene;
  auto* a = add_node<vtkMRMLModelNode>(scene);
  auto* b = add_node<vtkMRMLModelNode>(scene);
  a->AddNodeReferenceID(role, b->GetID());
  a->AddNodeReferenceID(role, a->GetID());
  EXPECT_EQ(2, a->GetNumberOfNodeReferences(role));
  EXPECT_EQ(b, a->GetNthNodeReference(role, 0));
  EXPECT_EQ(a, a->GetNthNodeReference(role, 1));
  EXPECT_TRUE(a->HasNodeReferenceID(role, b->GetID()));
  EXPECT_FALSE(a->HasNodeReferenceID("other", b->GetID()));
  std::vector<vtkMRMLNode*> referencing;
  scene->GetReferencingNodes(b, referencing);
  ASSERT_EQ(1U, referencing.size());
  EXPECT_EQ(a, referencing[0]);
  a->SetNthNodeReferenceID(role, 0, nullptr);
  EXPECT_EQ(1, a->GetNumberOfNodeReferences(role));
  scene->GetReferencingNodes(b, referencing);
  EXPECT_TRUE(referencing.empty());
}

TEST(SceneTest, ReferencesGoWithTheNode)
{
  vtkNew<vtkMRMLScene> scene;
  auto* a = add_node<vtkMRMLModelNode>(scene);
  auto* b = add_node<vtkMRMLModelNode>(scene);
  a->SetNodeReferenceID(role, b->GetID());
  const EventCounter removed(a, vtkMRMLNode::ReferenceRemovedEvent);
  scene->RemoveNode(b);
  EXPECT_EQ(0, a->GetNumberOfNodeReferences(role));
  EXPECT_EQ(1, removed.count);
  // A new node that happens to get the id is not meant.
  vtkNew<vtkMRMLModelNode> other;
  scene->AddNode(other);
  EXPECT_EQ(nullptr, a->GetNodeReference(role));
}

TEST(SceneTest, EventsOfReferencedNodesArrive)
{
  vtkNew<vtkMRMLScene> scene;
  auto* model = add_model(scene, "skin");
  const EventCounter shown(model, vtkMRMLDisplayableNode::DisplayModifiedEvent);
  model->GetDisplayNode()->SetOpacity(0.5);
  EXPECT_EQ(1, shown.count);
  auto* transform = add_node<vtkMRMLLinearTransformNode>(scene);
  model->SetAndObserveTransformNodeID(transform->GetID());
  const EventCounter moved(model, vtkMRMLTransformableNode::TransformModifiedEvent);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 5.0);
  transform->SetMatrixTransformToParent(matrix);
  EXPECT_EQ(1, moved.count);
  model->SetAndObserveTransformNodeID(nullptr);
  EXPECT_EQ(2, moved.count);
  transform->SetMatrixTransformToParent(nullptr);
  EXPECT_EQ(2, moved.count);
}

TEST(SceneTest, EventsStopWhenTheReferenceGoes)
{
  vtkNew<vtkMRMLScene> scene;
  auto* a = add_node<vtkMRMLModelNode>(scene);
  auto* b = add_node<vtkMRMLModelNode>(scene);
  vtkNew<vtkIntArray> events;
  events->InsertNextValue(vtkCommand::ModifiedEvent);
  a->SetAndObserveNodeReferenceID(role, b->GetID(), events);
  const EventCounter heard(a, vtkMRMLNode::ReferencedNodeModifiedEvent);
  b->SetAttribute("x", "1");
  EXPECT_EQ(1, heard.count);
  a->SetNodeReferenceID(role, nullptr);
  b->SetAttribute("x", "2");
  EXPECT_EQ(1, heard.count);
}

TEST(SceneTest, ManyChangesInABlockAreOneEvent)
{
  vtkNew<vtkMRMLScene> scene;
  auto* node = add_model(scene, "skin");
  const EventCounter modified(node, vtkCommand::ModifiedEvent);
  {
    const MRMLNodeModifyBlocker outer(node);
    node->SetAttribute("a", "1");
    const MRMLNodeModifyBlocker inner(node);
    node->SetAttribute("b", "2");
    node->SetName("other");
  }
  EXPECT_EQ(1, modified.count);
  node->SetAttribute("a", "1");
  EXPECT_EQ(1, modified.count) << "nothing changed";
}

TEST(SceneTest, CopiesAreDeep)
{
  vtkNew<vtkMRMLScene> scene;
  auto* model = add_model(scene, "skin");
  model->SetAttribute("a", "1");
  auto* copy = vtkMRMLModelNode::SafeDownCast(scene->CopyNode(model));
  ASSERT_NE(nullptr, copy);
  EXPECT_STRNE(model->GetID(), copy->GetID());
  EXPECT_STREQ("1", copy->GetAttribute("a"));
  EXPECT_EQ(model->GetDisplayNode(), copy->GetDisplayNode());
  ASSERT_NE(nullptr, copy->GetPolyData());
  EXPECT_NE(model->GetPolyData(), copy->GetPolyData());
  EXPECT_EQ(model->GetPolyData()->GetNumberOfPoints(), copy->GetPolyData()->GetNumberOfPoints());
}

TEST(SceneTest, ScenesGoWithTheirNodes)
{
  vtkWeakPointer<vtkMRMLNode> model;
  {
    vtkNew<vtkMRMLScene> scene;
    auto* a = add_model(scene, "a");
    auto* b = add_model(scene, "b");
    a->SetNodeReferenceID(role, b->GetID());
    b->SetNodeReferenceID(role, a->GetID());
    model = a;
  }
  EXPECT_EQ(nullptr, model.Get());
}

// --- Import ------------------------------------------------------------------------------------

TEST(ImportTest, ClashingIdsAreChangedEverywhere)
{
  vtkNew<vtkMRMLScene> source;
  auto* model = add_model(source, "skin");
  auto* other = add_model(source, "bone");
  model->AddNodeReferenceID(role, other->GetID());
  model->GetDisplayNode()->SetAndObserveColorNodeID(other->GetID());
  const std::string xml = scene_text(source);

  vtkNew<vtkMRMLScene> scene;
  auto* mine = add_model(scene, "mine");
  const int before = scene->GetNumberOfNodes();
  ASSERT_EQ(1, import_text(scene, xml));
  EXPECT_EQ(before + source->GetNumberOfNodes(), scene->GetNumberOfNodes());
  auto* skin = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName("skin"));
  auto* bone = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName("bone"));
  ASSERT_NE(nullptr, skin);
  ASSERT_NE(nullptr, bone);
  EXPECT_STREQ("vtkMRMLModelNode1", mine->GetID());
  EXPECT_STRNE("vtkMRMLModelNode1", skin->GetID());
  EXPECT_EQ(bone, skin->GetNodeReference(role));
  ASSERT_NE(nullptr, skin->GetDisplayNode());
  EXPECT_NE(mine->GetDisplayNode(), skin->GetDisplayNode());
  EXPECT_STREQ(bone->GetID(), skin->GetDisplayNode()->GetColorNodeID());
}

TEST(ImportTest, TheSameFileTwiceIsTwoOfEach)
{
  vtkNew<vtkMRMLScene> source;
  auto* model = add_model(source, "skin");
  model->SetNodeReferenceID(role, add_model(source, "bone")->GetID());
  const std::string xml = scene_text(source);
  vtkNew<vtkMRMLScene> scene;
  ASSERT_EQ(1, import_text(scene, xml));
  ASSERT_EQ(1, import_text(scene, xml));
  std::vector<vtkMRMLNode*> models;
  ASSERT_EQ(4, scene->GetNodesByClass("vtkMRMLModelNode", models));
  EXPECT_EQ(models[1], models[0]->GetNodeReference(role));
  EXPECT_EQ(models[3], models[2]->GetNodeReference(role));
}

TEST(ImportTest, ReferencesOutOfTheFileHitNobody)
{
  vtkNew<vtkMRMLScene> scene;
  add_model(scene, "mine");
  ASSERT_EQ(1, import_text(scene, "<MRML><Model id=\"vtkMRMLModelNode7\" name=\"skin\""
                                  " references=\"moved:vtkMRMLModelNode1;\"></Model></MRML>"));
  EXPECT_EQ(0, scene->GetFirstNodeByName("skin")->GetNumberOfNodeReferences(role));
}

TEST(ImportTest, AttributesOfSlicer4AreReferences)
{
  vtkNew<vtkMRMLScene> scene;
  ASSERT_EQ(1,
            import_text(scene, "<MRML><ModelDisplay id=\"vtkMRMLModelDisplayNode1\"></ModelDisplay>"
                               "<Model id=\"vtkMRMLModelNode1\" name=\"skin\""
                               " displayNodeRef=\"vtkMRMLModelDisplayNode1\"></Model></MRML>"));
  auto* skin = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName("skin"));
  ASSERT_NE(nullptr, skin->GetDisplayNode());
  EXPECT_STREQ("vtkMRMLModelDisplayNode1", skin->GetDisplayNode()->GetID());
}

// --- Undo --------------------------------------------------------------------------------------

class UndoTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    m_scene->SetUndoOn();
    m_points = add_node<vtkMRMLMarkupsFiducialNode>(m_scene, "points");
    m_points->SetUndoEnabled(true);
  }
  vtkNew<vtkMRMLScene> m_scene;
  vtkMRMLMarkupsFiducialNode* m_points = nullptr;
};

TEST_F(UndoTest, ChangesComeBackAndGo)
{
  m_points->AddControlPoint(1.0, 2.0, 3.0, "a");
  m_scene->SaveStateForUndo(m_points);
  m_points->SetNthControlPointPosition(0, 4.0, 5.0, 6.0);
  ASSERT_EQ(1, m_scene->GetNumberOfUndoLevels());
  m_scene->Undo();
  EXPECT_EQ(1.0, m_points->GetNthControlPointPosition(0)[0]);
  EXPECT_EQ(1, m_scene->GetNumberOfRedoLevels());
  m_scene->Redo();
  EXPECT_EQ(4.0, m_points->GetNthControlPointPosition(0)[0]);
  m_scene->Undo();
  EXPECT_EQ(1.0, m_points->GetNthControlPointPosition(0)[0]);
}

TEST_F(UndoTest, DeletedNodesComeBackWithTheirReferences)
{
  auto* second = add_node<vtkMRMLMarkupsFiducialNode>(m_scene, "second");
  second->SetUndoEnabled(true);
  m_points->SetNodeReferenceID(role, second->GetID());
  m_scene->SaveStateForUndo();
  m_scene->RemoveNode(second);
  ASSERT_EQ(0, m_points->GetNumberOfNodeReferences(role));
  m_scene->Undo();
  vtkMRMLNode* back = m_scene->GetFirstNodeByName("second");
  ASSERT_NE(nullptr, back);
  EXPECT_EQ(back, m_points->GetNodeReference(role));
  m_scene->Redo();
  EXPECT_EQ(nullptr, m_scene->GetFirstNodeByName("second"));
  EXPECT_EQ(0, m_points->GetNumberOfNodeReferences(role));
}

TEST_F(UndoTest, NewNodesGoAndComeBack)
{
  m_scene->SaveStateForUndo();
  auto* second = add_node<vtkMRMLMarkupsFiducialNode>(m_scene, "second");
  second->SetUndoEnabled(true);
  second->AddControlPoint(1.0, 2.0, 3.0);
  m_scene->Undo();
  EXPECT_EQ(nullptr, m_scene->GetFirstNodeByName("second"));
  m_scene->Redo();
  auto* back = vtkMRMLMarkupsFiducialNode::SafeDownCast(m_scene->GetFirstNodeByName("second"));
  ASSERT_NE(nullptr, back);
  EXPECT_EQ(1, back->GetNumberOfControlPoints());
}

TEST_F(UndoTest, NodesWithoutUndoStay)
{
  auto* model = add_model(m_scene, "skin");
  m_scene->SaveStateForUndo();
  model->SetAttribute("a", "1");
  m_scene->Undo();
  EXPECT_STREQ("1", model->GetAttribute("a"));
}

TEST_F(UndoTest, ANewChangeEndsTheRedo)
{
  m_scene->SaveStateForUndo(m_points);
  m_points->AddControlPoint(1.0, 2.0, 3.0);
  m_scene->Undo();
  ASSERT_EQ(1, m_scene->GetNumberOfRedoLevels());
  m_scene->SaveStateForUndo(m_points);
  EXPECT_EQ(0, m_scene->GetNumberOfRedoLevels());
}

TEST_F(UndoTest, LevelsAreLimited)
{
  m_scene->SetMaximumNumberOfSavedUndoStates(3);
  for (int i = 0; i < 10; ++i)
  {
    m_scene->SaveStateForUndo(m_points);
    m_points->AddControlPoint(i, 0.0, 0.0);
  }
  EXPECT_EQ(3, m_scene->GetNumberOfUndoLevels());
  for (int i = 0; i < 5; ++i)
  {
    m_scene->Undo();
  }
  EXPECT_EQ(7, m_points->GetNumberOfControlPoints());
}
