#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "vtkFaceToBoneSculptWidget.h"
#include "vtkFaceToBoneSkinSculpting.h"

#include <Bridge/vtk_surface.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsFiducialNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLScene.h>

#include <vtkPointData.h>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;

/// All that a node's surface says, to the bit.
struct Face
{
  explicit Face(vtkMRMLModelNode* node)
  {
    vtkPolyData* surface = node->GetPolyData();
    vtkDataArray* arrays[] = {surface->GetPoints()->GetData(),
                              surface->GetPointData()->GetArray("displacement"),
                              surface->GetPointData()->GetArray("mask")};
    for (vtkDataArray* array : arrays)
      for (vtkIdType k = 0; array && k < array->GetNumberOfValues(); ++k)
        values.push_back(array->GetComponent(k / array->GetNumberOfComponents(),
                                             int(k % array->GetNumberOfComponents())));
  }
  bool operator==(const Face& other) const { return values == other.values; }

  std::vector<double> values;
};

/// A nose on a face of 80 x 80 mm in a scene, as skin and as target.
class SkinSculpting : public ::testing::Test
{
protected:
  SkinSculpting()
  {
    skin = add_model("Skin");
    target = add_model("Target face");
    stage = std::make_unique<ToolStage>(target->GetPolyData());
    sculpting->SetView(stage->interactor, stage->renderer);
    sculpting->SetNodes(skin, target);
    choose(BrushKind::Grab);
  }

  vtkMRMLModelNode* add_model(const char* name)
  {
    auto* model =
        vtkMRMLModelNode::SafeDownCast(scene->AddNewNodeByClass("vtkMRMLModelNode", name));
    model->SetAndObserveMesh(to_polydata(testing::make_sheet(
        80, 80, [](double r, double s) { return 15 * std::exp(-(r * r + s * s) / 150); })));
    model->CreateDefaultDisplayNodes();
    return model;
  }
  void choose(BrushKind kind, bool symmetric = false)
  {
    Brush brush;
    brush.kind = kind;
    brush.radius_mm = 12;
    sculpting->SetBrush(brush, symmetric);
  }
  std::array<int, 2> at(double r, double s) { return stage->pixel(r, 0, s); }
  static vtkIdType vertex(double r, double s)
  {
    return static_cast<vtkIdType>((40 + s) * 81 + 40 + r);
  }
  /// How far the target's point is from the skin's.
  double moved(double r, double s) const
  {
    Vec3 is, was;
    target->GetPolyData()->GetPoint(vertex(r, s), is.data());
    skin->GetPolyData()->GetPoint(vertex(r, s), was.data());
    return (is - was).norm();
  }
  vtkMRMLMarkupsFiducialNode* add_landmarks(double middle_r)
  {
    auto* node = vtkMRMLMarkupsFiducialNode::SafeDownCast(
        scene->AddNewNodeByClass("vtkMRMLMarkupsFiducialNode", "Landmarks"));
    node->AddControlPoint(vtkVector3d(middle_r, 0, 20), "N");
    for (const char* pair : {"Or", "Zy"})
      for (const double side : {1.0, -1.0})
        node->AddControlPoint(vtkVector3d(middle_r + side * 30, 0, 10),
                              std::string(pair) + (side > 0 ? "_R" : "_L"));
    return node;
  }

  vtkNew<vtkMRMLScene> scene;
  vtkMRMLModelNode *skin = nullptr, *target = nullptr;
  std::unique_ptr<ToolStage> stage;
  vtkNew<vtkFaceToBoneSkinSculpting> sculpting;
};

TEST_F(SkinSculpting, EveryMoveOfTheMouseIsInTheNode)
{
  ASSERT_TRUE(sculpting->Start()) << sculpting->GetObstacle();
  EventCounter changes(target, vtkMRMLModelNode::MeshModifiedEvent);
  EventCounter told(sculpting, vtkCommand::InteractionEvent);
  EventCounter ended(sculpting, vtkCommand::EndInteractionEvent);
  stage->press(at(0, 0));
  stage->move(at(3, 2));
  const double halfway = moved(0, 0);
  EXPECT_GT(halfway, 2);
  stage->move(at(6, 4));
  EXPECT_GT(moved(0, 0), halfway + 2);
  stage->release(at(6, 4));
  EXPECT_GE(changes.count, 2);
  EXPECT_EQ(told.count, 3);
  EXPECT_EQ(ended.count, 1);
  EXPECT_EQ(moved(-35, 30), 0);
  Vec3 d;
  target->GetPolyData()->GetPointData()->GetArray("displacement")->GetTuple(vertex(0, 0), d.data());
  EXPECT_NEAR(d.norm(), moved(0, 0), 1e-5);
  EXPECT_EQ(d, sculpting->GetSession()->skin().displacement()[std::size_t(vertex(0, 0))]);
}

TEST_F(SkinSculpting, TargetIsShownInsteadOfTheSkinAndMayBeColoured)
{
  target->GetDisplayNode()->SetVisibility(0);
  ASSERT_TRUE(sculpting->Start());
  EXPECT_TRUE(target->GetDisplayNode()->GetVisibility());
  EXPECT_FALSE(skin->GetDisplayNode()->GetVisibility());
  sculpting->SetColoured(true);
  EXPECT_STREQ(target->GetDisplayNode()->GetActiveScalarName(), "displacement_mm");
  EXPECT_TRUE(target->GetDisplayNode()->GetScalarVisibility());
  EXPECT_TRUE(sculpting->IsColoured());
  sculpting->SetColoured(false);
  EXPECT_FALSE(target->GetDisplayNode()->GetScalarVisibility());
  EXPECT_FALSE(sculpting->IsColoured());
}

TEST_F(SkinSculpting, UndoAndRedoAreExactToTheBit)
{
  ASSERT_TRUE(sculpting->Start());
  std::mt19937 random(3);
  std::vector<Face> faces{Face(target)};
  for (int k = 0; k < 60; ++k)
  {
    choose(static_cast<BrushKind>(random() % 8), random() % 2);
    auto anywhere = [&] { return at(int(random() % 60) - 30.0, int(random() % 60) - 30.0); };
    stage->drag(anywhere(), anywhere());
    if (!(Face(target) == faces.back()))
      faces.emplace_back(target);
  }
  ASSERT_GT(faces.size(), 30U);
  const Face last(target);
  std::size_t undone = faces.size() - 1;
  while (sculpting->Undo())
  {
    if (Face(target) == faces[undone])
      continue; // a stroke that changed nothing
    ASSERT_GT(undone, 0U);
    ASSERT_TRUE(Face(target) == faces[--undone]) << undone;
  }
  EXPECT_EQ(undone, 0U);
  EXPECT_FALSE(sculpting->CanUndo());
  while (sculpting->Redo())
    ;
  EXPECT_TRUE(Face(target) == last);
}

TEST_F(SkinSculpting, SceneUndoIsLeftAlone)
{
  scene->SetUndoOn();
  scene->SaveStateForUndo();
  const int levels = scene->GetNumberOfUndoLevels();
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  ASSERT_TRUE(sculpting->Undo());
  EXPECT_EQ(scene->GetNumberOfUndoLevels(), levels);
  EXPECT_EQ(scene->GetNumberOfRedoLevels(), 0);
}

TEST_F(SkinSculpting, MaskedSkinMovesExactlyZero)
{
  ASSERT_TRUE(sculpting->Start());
  choose(BrushKind::Mask);
  for (int k = 0; k < 10; ++k)
    stage->drag(at(3, -3), at(3, 3));
  vtkDataArray* mask = target->GetPolyData()->GetPointData()->GetArray("mask");
  ASSERT_EQ(mask->GetTuple1(vertex(3, 0)), 1);
  choose(BrushKind::Grab);
  stage->drag(at(-14, 0), at(-14, 6));
  EXPECT_GT(moved(-14, 0), 3);
  for (int r = -40; r <= 40; ++r)
    for (int s = -40; s <= 40; ++s)
      if (mask->GetTuple1(vertex(r, s)) == 1)
      {
        ASSERT_EQ(moved(r, s), 0);
      }
  sculpting->ClearMask();
  EXPECT_EQ(mask->GetTuple1(vertex(3, 0)), 0);
  sculpting->InvertMask();
  EXPECT_EQ(mask->GetTuple1(vertex(3, 0)), 1);
  sculpting->Undo();
  sculpting->Undo();
  EXPECT_EQ(mask->GetTuple1(vertex(3, 0)), 1);
}

TEST_F(SkinSculpting, EraseBringsThePatientsFaceBack)
{
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  choose(BrushKind::Erase);
  for (int k = 0; k < 10; ++k)
    stage->drag(at(-1, 0), at(1, 0));
  EXPECT_EQ(moved(0, 0), 0);
}

TEST_F(SkinSculpting, SymmetryIsAboutThePlaneOfTheLandmarks)
{
  ASSERT_TRUE(sculpting->Start());
  vtkMRMLMarkupsFiducialNode* landmarks = add_landmarks(5);
  sculpting->SetLandmarks(landmarks);
  choose(BrushKind::Draw, true);
  stage->drag(at(25, 0), at(25, 2));
  EXPECT_GT(moved(25, 1), 1);
  EXPECT_NEAR(moved(-15, 1), moved(25, 1), 0.1); // the nose is nearer on that side
  ASSERT_TRUE(sculpting->Undo());
  for (int n = 0; n < landmarks->GetNumberOfControlPoints(); ++n) // dragged by the user
  {
    double p[3];
    landmarks->GetNthControlPointPosition(n, p);
    landmarks->SetNthControlPointPosition(n, p[0] - 5, p[1], p[2]);
  }
  stage->drag(at(25, 0), at(25, 2));
  EXPECT_NEAR(moved(-25, 1), moved(25, 1), 1e-4);
}

TEST_F(SkinSculpting, WithoutLandmarksTheFaceSaysItsMiddle)
{
  ASSERT_TRUE(sculpting->Start());
  choose(BrushKind::Draw, true);
  stage->drag(at(25, 0), at(25, 2));
  EXPECT_GT(moved(25, 1), 1);
  EXPECT_NEAR(moved(-25, 1), moved(25, 1), 0.2);
}

TEST_F(SkinSculpting, WhatIsInTheWayIsSaid)
{
  sculpting->SetNodes(nullptr, nullptr);
  EXPECT_FALSE(sculpting->Start());
  EXPECT_NE(sculpting->GetObstacle().find("no skin"), std::string::npos);
  sculpting->SetNodes(skin, nullptr);
  EXPECT_NE(sculpting->GetObstacle().find("no target"), std::string::npos);
  sculpting->SetNodes(skin, target);
  auto* transform = scene->AddNewNodeByClass("vtkMRMLLinearTransformNode", "Moved by somebody");
  ASSERT_TRUE(sculpting->Start());
  target->SetAndObserveTransformNodeID(transform->GetID());
  EXPECT_FALSE(sculpting->IsSculpting());
  EXPECT_NE(sculpting->GetObstacle().find("transform"), std::string::npos);
  target->SetAndObserveTransformNodeID(nullptr);
  target->SetAndObserveMesh(
      to_polydata(testing::make_sheet(20, 20, [](double, double) { return 0; })));
  EXPECT_FALSE(sculpting->Start());
  EXPECT_NE(sculpting->GetObstacle().find("other vertices"), std::string::npos);
  sculpting->SetNodes(skin, add_model("Another"));
  EXPECT_TRUE(sculpting->Start());
  sculpting->SetView(nullptr, nullptr);
  EXPECT_FALSE(sculpting->IsSculpting());
  EXPECT_NE(sculpting->GetObstacle().find("view"), std::string::npos);
}

/// What may be taken away in the middle of a stroke.
class TakenAway : public SkinSculpting
{
protected:
  void begin()
  {
    ASSERT_TRUE(sculpting->Start());
    stage->press(at(0, 0));
    stage->move(at(3, 2));
    ASSERT_GT(moved(0, 0), 2);
  }
  void go_on()
  {
    stage->move(at(6, 4));
    stage->release(at(6, 4));
    stage->drag(at(-5, 0), at(5, 5));
    EXPECT_FALSE(sculpting->IsSculpting());
    EXPECT_FALSE(sculpting->CanUndo());
    EXPECT_FALSE(sculpting->Undo());
  }
};

TEST_F(TakenAway, Target)
{
  begin();
  const vtkSmartPointer<vtkMRMLModelNode> kept = target;
  scene->RemoveNode(target);
  const Face left(kept);
  go_on();
  EXPECT_TRUE(Face(kept) == left);
  EXPECT_FALSE(sculpting->GetTargetNode());
}

TEST_F(TakenAway, TargetThatNobodyKeeps)
{
  begin();
  scene->RemoveNode(target);
  go_on();
}

TEST_F(TakenAway, Skin)
{
  begin();
  scene->RemoveNode(skin);
  go_on();
}

TEST_F(TakenAway, AllNodesWhenTheSceneCloses)
{
  begin();
  scene->Clear(0);
  go_on();
}

TEST_F(TakenAway, Scene)
{
  auto another = vtkSmartPointer<vtkMRMLScene>::New();
  std::swap(skin, target);
  auto* lost_skin =
      vtkMRMLModelNode::SafeDownCast(another->AddNewNodeByClass("vtkMRMLModelNode", "Skin"));
  auto* lost =
      vtkMRMLModelNode::SafeDownCast(another->AddNewNodeByClass("vtkMRMLModelNode", "Target face"));
  lost_skin->SetAndObserveMesh(to_polydata(to_triangle_mesh(skin->GetPolyData())));
  lost->SetAndObserveMesh(to_polydata(to_triangle_mesh(skin->GetPolyData())));
  sculpting->SetNodes(lost_skin, lost);
  ASSERT_TRUE(sculpting->Start());
  stage->press(at(0, 0));
  stage->move(at(3, 2));
  another = nullptr;
  go_on();
}

TEST_F(TakenAway, View)
{
  begin();
  stage.reset();
  EXPECT_FALSE(sculpting->IsSculpting());
  EXPECT_EQ(moved(0, 0), 0); // the stroke was taken back
  EXPECT_FALSE(sculpting->Start());
  stage = std::make_unique<ToolStage>(target->GetPolyData()); // another layout
  sculpting->SetView(stage->interactor, stage->renderer);
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  EXPECT_GT(moved(0, 0), 4);
}

TEST_F(TakenAway, PlanForAnother)
{
  begin();
  vtkMRMLModelNode* other = add_model("Target of another plan");
  sculpting->SetNodes(skin, other);
  EXPECT_FALSE(sculpting->IsSculpting());
  EXPECT_EQ(moved(0, 0), 0); // the stroke was taken back
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  EXPECT_EQ(moved(0, 0), 0);
  target = other;
  EXPECT_GT(moved(0, 0), 4);
}

TEST_F(TakenAway, ToolItself)
{
  auto mine = vtkSmartPointer<vtkFaceToBoneSkinSculpting>::New();
  vtkMRMLModelNode* other = add_model("Target of its own");
  mine->SetView(stage->interactor, stage->renderer);
  mine->SetNodes(skin, other);
  mine->SetBrush(sculpting->GetBrush(), false);
  ASSERT_TRUE(mine->Start());
  stage->press(at(0, 0));
  stage->move(at(3, 2));
  mine = nullptr;
  stage->move(at(6, 4));
  stage->release(at(6, 4));
  other->GetPolyData()->Modified();
  scene->RemoveNode(other);
}

TEST_F(SkinSculpting, AFacePublishedAnewKeepsItsStrokes)
{
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  const double before = moved(0, 0);
  vtkNew<vtkPolyData> written; // and read again, as a step does
  written->DeepCopy(target->GetPolyData());
  target->SetAndObserveMesh(written);
  EXPECT_TRUE(sculpting->IsSculpting());
  EXPECT_TRUE(sculpting->CanUndo());
  stage->drag(at(20, 20), at(24, 20));
  EXPECT_GT(moved(20, 20), 2);
  ASSERT_TRUE(sculpting->Undo());
  EXPECT_NEAR(moved(0, 0), before, 1e-5);
  ASSERT_TRUE(sculpting->Undo());
  EXPECT_EQ(moved(0, 0), 0);
}

TEST_F(SkinSculpting, AnotherFaceInTheNodeIsSculptedOn)
{
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  vtkNew<vtkPolyData> other;
  other->DeepCopy(skin->GetPolyData());
  for (vtkIdType v = 0; v < other->GetNumberOfPoints(); ++v)
  {
    const double* p = other->GetPoint(v);
    other->GetPoints()->SetPoint(v, p[0], p[1] + 2, p[2]);
  }
  target->SetAndObserveMesh(other);
  EXPECT_TRUE(sculpting->IsSculpting());
  EXPECT_FALSE(sculpting->CanUndo());
  EXPECT_NEAR(moved(-35, 30), 2, 1e-5);
  stage->drag(at(0, 0), at(0, 6));
  EXPECT_NEAR(moved(0, 0), std::hypot(2, 6), 0.5);
}

TEST_F(SkinSculpting, StoppingKeepsTheStrokesForLater)
{
  ASSERT_TRUE(sculpting->Start());
  stage->drag(at(0, 0), at(6, 4));
  sculpting->Stop();
  stage->drag(at(0, 0), at(6, 4));
  EXPECT_TRUE(sculpting->Undo());
  EXPECT_EQ(moved(0, 0), 0);
  ASSERT_TRUE(sculpting->Start());
  EXPECT_TRUE(sculpting->CanRedo());
}

/// A host's own style observes the interactor too, at a lower priority.
TEST_F(SkinSculpting, TheHostsStyleSeesWhatIsNotTheBrushs)
{
  ASSERT_TRUE(sculpting->Start());
  EventCounter presses(stage->interactor, vtkCommand::LeftButtonPressEvent);
  EventCounter doubles(stage->interactor, vtkCommand::LeftButtonDoubleClickEvent);
  EventCounter releases(stage->interactor, vtkCommand::LeftButtonReleaseEvent);
  EventCounter rights(stage->interactor, vtkCommand::RightButtonReleaseEvent);
  EventCounter moves(stage->interactor, vtkCommand::MouseMoveEvent);
  stage->move(at(0, 0)); // nothing is held: markups may light up
  EXPECT_EQ(moves.count, 1);
  stage->press(at(0, 0));
  stage->send(vtkCommand::LeftButtonDoubleClickEvent, at(0, 0));
  stage->move(at(3, 0));
  stage->send(vtkCommand::RightButtonPressEvent, at(3, 0)); // takes the stroke back
  stage->send(vtkCommand::RightButtonReleaseEvent, at(3, 0));
  stage->release(at(3, 0));
  EXPECT_EQ(moves.count, 1);
  EXPECT_EQ(presses.count, 0);
  EXPECT_EQ(doubles.count, 0);
  EXPECT_EQ(releases.count, 0);
  EXPECT_EQ(rights.count, 0);
  stage->send(vtkCommand::RightButtonPressEvent, at(3, 0)); // now it is the camera's
  stage->send(vtkCommand::RightButtonReleaseEvent, at(3, 0));
  EXPECT_EQ(rights.count, 1);
  stage->drag(at(47, 0), at(48, 0)); // beside the face
  EXPECT_EQ(presses.count, 1);
  EXPECT_EQ(releases.count, 1);
  stage->send(vtkCommand::LeftButtonDoubleClickEvent, at(47, 0));
  EXPECT_EQ(doubles.count, 1);
  stage->interactor->SetKeyCode('i'); // VTK's own switch of widgets
  stage->interactor->InvokeEvent(vtkCommand::CharEvent);
  EXPECT_TRUE(sculpting->IsSculpting());
}

TEST_F(SkinSculpting, RandomEventsAndNodesFindNothing)
{
  std::mt19937 random(17);
  sculpting->SetLandmarks(add_landmarks(0));
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    stage->random_event(random);
    switch (random() % 400)
    {
    case 0:
      sculpting->Start();
      break;
    case 1:
      choose(static_cast<BrushKind>(random() % 8), random() % 2);
      break;
    case 2:
      sculpting->Undo();
      break;
    case 3:
      sculpting->Redo();
      break;
    case 4:
      sculpting->Stop();
      break;
    case 5:
      scene->RemoveNode(target);
      target = add_model("Target face");
      sculpting->SetNodes(skin, target);
      break;
    case 6:
      sculpting->SetView(stage->interactor, random() % 4 ? stage->renderer.Get() : nullptr);
      break;
    case 7:
      sculpting->InvertMask();
      break;
    default:
      sculpting->Start();
    }
  }
  sculpting->Stop();
  while (sculpting->Undo())
    ;
  for (int r = -40; r <= 40; ++r)
    ASSERT_EQ(moved(r, r), 0);
}

} // namespace
} // namespace f2b
