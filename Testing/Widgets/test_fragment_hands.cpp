#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "MRML/node_test.hpp"
#include "vtkFaceToBoneFragmentHands.h"
#include "vtkFaceToBoneFragmentRepresentation.h"
#include "vtkFaceToBoneFragmentWidget.h"

#include <Bridge/vtk_surface.hpp>
#include <Core/geometry/rigid_motion.hpp>

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>

#include <vtkMatrix4x4.h>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;
using Coordinates = std::array<double, 6>;
using Plan = vtkMRMLFaceToBonePlanNode;
using Osteotomy = vtkMRMLFaceToBoneOsteotomyNode;

/// A plan of two fragments, by both methods, before a view from the front and a little aside.
class FragmentHands : public ::testing::Test
{
protected:
  FragmentHands()
  {
    stage = std::make_unique<ToolStage>(to_polydata(testing::make_sheet(4, 80)));
    look_aside();
    plan = test::add_node<Plan>(scene, "Plan");
    osteotomy = test::add_node<Osteotomy>(scene, "Plan osteotomy");
    plan->SetOsteotomyNodeID(osteotomy->GetID());
    for (const char* name : {"maxilla", "chin"})
      osteotomy->AddFragment(name);
    for (int method = 0; method < Plan::Method_Last; ++method)
    {
      add_planned(method, "maxilla", maxilla, {5, 0, -3});
      add_planned(method, "chin", chin, {0, 0, -30});
    }
    hands->SetView(stage->interactor, stage->renderer);
    hands->SetPlan(plan);
  }

  void look_aside()
  {
    stage->renderer->GetActiveCamera()->SetPosition(200, 400, 150);
    stage->renderer->GetActiveCamera()->SetParallelScale(90);
  }
  void add_planned(int method, const char* fragment, const Coordinates& movement,
                   const std::array<double, 3>& reference)
  {
    auto* node = test::add_node<vtkMRMLLinearTransformNode>(scene, fragment);
    plan->SetNodeReferenceID(Plan::GetTransformRole(method, fragment).c_str(), node->GetID());
    plan->SetMovement(method, fragment, movement.data(), reference.data());
    show(node, movement, reference);
    auto* model = test::add_node<vtkMRMLModelNode>(scene, fragment);
    plan->SetNodeReferenceID(Plan::GetFragmentRole(method, fragment).c_str(), model->GetID());
    model->SetAndObserveTransformNodeID(node->GetID());
  }
  static void show(vtkMRMLLinearTransformNode* node, const Coordinates& m,
                   const std::array<double, 3>& reference)
  {
    const vtkNew<vtkMatrix4x4> matrix;
    const Mat4 expected = motion(m, reference).matrix();
    for (int k = 0; k < 16; ++k)
      matrix->SetElement(k / 4, k % 4, expected(k / 4, k % 4));
    node->SetMatrixTransformToParent(matrix);
  }
  static RigidMotion motion(const Coordinates& m, const std::array<double, 3>& reference)
  {
    const double degree = std::acos(-1.0) / 180;
    return {rotation_from({m[3] * degree, m[4] * degree, m[5] * degree}),
            {m[0], m[1], m[2]},
            {reference[0], reference[1], reference[2]}};
  }
  /// How far a fragment is from a movement, at points some centimetres away [mm].
  double difference(int method, const char* fragment, const Coordinates& m)
  {
    return difference(plan->GetFragmentNode(method, fragment)->GetParentTransformNode(), method,
                      fragment, m);
  }
  /// The same of the plan's result, which is not ours to move.
  double result_moved()
  {
    double worst = 0;
    for (int method = 0; method < Plan::Method_Last; ++method)
      for (const char* fragment : {"maxilla", "chin"})
      {
        Coordinates m{};
        plan->GetMovement(method, fragment, m.data());
        if (vtkMRMLTransformNode* node = plan->GetTransformNode(method, fragment))
          worst = std::max(worst, difference(node, method, fragment, m));
      }
    return worst;
  }
  double difference(vtkMRMLTransformNode* node, int method, const char* fragment,
                    const Coordinates& m)
  {
    std::array<double, 3> reference{};
    plan->GetReferencePoint(method, fragment, reference.data());
    const vtkNew<vtkMatrix4x4> matrix;
    if (node)
      node->GetMatrixTransformToParent(matrix);
    double worst = 0;
    for (const Vec3& p : {Vec3(40, 0, 0), Vec3(0, 50, -20), Vec3(-10, 10, 60)})
    {
      const double in[4] = {p.x(), p.y(), p.z(), 1};
      double out[4];
      matrix->MultiplyPoint(in, out);
      worst = std::max(worst, (Vec3(out) - motion(m, reference).apply(p)).norm());
    }
    return worst;
  }
  vtkFaceToBoneFragmentRepresentation* look(int n)
  {
    return hands->GetTool(n)->GetFragmentRepresentation();
  }
  std::array<int, 2> grip(int n, int coordinate)
  {
    const auto p = look(n)->GripPosition(coordinate);
    return stage->pixel(p[0], p[1], p[2]);
  }
  static std::array<int, 2> shifted(std::array<int, 2> p) { return {p[0] + 17, p[1] + 23}; }
  Coordinates stated(const char* fragment)
  {
    Coordinates m{};
    EXPECT_TRUE(plan->GetStatedMovement(fragment, m.data())) << fragment;
    return m;
  }

  const Coordinates maxilla{2, 5, -1, 3, 1, -2}, chin{0, 4, 0, 0, 0, 0};
  vtkSmartPointer<vtkMRMLScene> scene = test::scene_with_our_nodes();
  Plan* plan = nullptr;
  Osteotomy* osteotomy = nullptr;
  std::unique_ptr<ToolStage> stage;
  vtkNew<vtkFaceToBoneFragmentHands> hands;
};

TEST_F(FragmentHands, ADragMovesTheTransformAndStatesWhatIsSeen)
{
  ASSERT_TRUE(hands->Start()) << hands->GetObstacle();
  ASSERT_EQ(hands->GetNumberOfFragments(), 2);
  EventCounter moved(hands, vtkCommand::InteractionEvent);
  const auto from = grip(0, Osteotomy::Superior);
  stage->press(from);
  stage->move(shifted(from));
  const Coordinates now = look(0)->GetMovement();
  EXPECT_GT(std::abs(now[2] - maxilla[2]), 1);
  EXPECT_EQ(now[3], maxilla[3]);
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", now), 1e-9); // while it is held
  EXPECT_TRUE(plan->GetStatedMovementFragments().empty());
  stage->release(shifted(from));
  EXPECT_EQ(moved.count, 1);
  EXPECT_EQ(stated("maxilla"), now);
  EXPECT_EQ(stated("chin"), chin); // what is seen is what is asked for
  EXPECT_LT(difference(Plan::RigidFit, "chin", chin), 1e-9);
  EXPECT_LT(difference(Plan::VirtualForce, "maxilla", maxilla), 1e-9);
  Coordinates planned{};
  plan->GetMovement(Plan::RigidFit, "maxilla", planned.data());
  EXPECT_EQ(planned, maxilla); // the plan itself stays
  EXPECT_LT(result_moved(), 1e-9);
}

TEST_F(FragmentHands, StoppingShowsThePlanAgainAndStartingWhatWasStated)
{
  const int nodes = scene->GetNumberOfNodes();
  ASSERT_TRUE(hands->Start());
  stage->drag(grip(0, Osteotomy::Pitch), shifted(grip(0, Osteotomy::Pitch)));
  const Coordinates by_hand = stated("maxilla");
  EXPECT_NE(by_hand[3], maxilla[3]);
  hands->Stop();
  EXPECT_EQ(hands->GetNumberOfFragments(), 0);
  EXPECT_EQ(scene->GetNumberOfNodes(), nodes);
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", maxilla), 1e-9);
  ASSERT_TRUE(hands->Start());
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", by_hand), 1e-9);
  hands->Reset();
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", maxilla), 1e-9);
  EXPECT_TRUE(plan->GetStatedMovementFragments().empty());
}

TEST_F(FragmentHands, RulesOfTheOsteotomyHold)
{
  osteotomy->SetNthFragmentLocked(0, Osteotomy::Superior, true);
  const double bounds[2] = {4, 6};
  osteotomy->SetNthFragmentBounds(0, Osteotomy::Anterior, bounds);
  ASSERT_TRUE(hands->Start());
  EXPECT_TRUE(look(0)->IsLocked(Osteotomy::Superior));
  stage->drag(grip(0, Osteotomy::Superior), shifted(grip(0, Osteotomy::Superior)));
  EXPECT_TRUE(plan->GetStatedMovementFragments().empty());
  const auto from = grip(0, Osteotomy::Anterior);
  for (const int sign : {1, -1})
  {
    stage->drag(from, {from[0] - 60 * sign, from[1] - 60 * sign});
    const double anterior = look(0)->GetMovement()[1];
    EXPECT_GE(anterior, 4);
    EXPECT_LE(anterior, 6);
  }
}

TEST_F(FragmentHands, PublishedResultsDoNotMoveWhatIsInHand)
{
  ASSERT_TRUE(hands->Start());
  stage->drag(grip(0, Osteotomy::Superior), shifted(grip(0, Osteotomy::Superior)));
  const Coordinates by_hand = stated("maxilla");
  {
    const MRMLNodeModifyBlocker blocker(plan); // as a step's end does
    plan->GetFragmentNode(Plan::RigidFit, "maxilla")
        ->SetAndObserveTransformNodeID(plan->GetTransformNode(Plan::RigidFit, "maxilla")->GetID());
    plan->SetStatusText("done");
  }
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", by_hand), 1e-9);
}

TEST_F(FragmentHands, OnlyTheFaceOfTheseFragmentsIsShown)
{
  auto add_face = [&](const std::string& role)
  {
    auto* face = test::add_node<vtkMRMLModelNode>(scene, role.c_str());
    face->CreateDefaultDisplayNodes();
    plan->SetNodeReferenceID(role.c_str(), face->GetID());
    return face->GetDisplayNode();
  };
  vtkMRMLDisplayNode* planned = add_face(Plan::GetPredictionRole(Plan::RigidFit));
  vtkMRMLDisplayNode* by_hand = add_face(Plan::StatedPredictionRole);
  by_hand->SetVisibility(0);
  ASSERT_TRUE(hands->Start());
  EXPECT_FALSE(planned->GetVisibility());
  EXPECT_FALSE(by_hand->GetVisibility());
  plan->SetStepStatus(Plan::Predict, Plan::Current); // as Predict's end does
  EXPECT_TRUE(by_hand->GetVisibility());
  plan->SetStepStatus(Plan::Predict, Plan::Stale);
  EXPECT_FALSE(by_hand->GetVisibility());
  hands->Stop();
  EXPECT_TRUE(planned->GetVisibility());
  EXPECT_FALSE(by_hand->GetVisibility());
}

TEST_F(FragmentHands, AnotherMethodIsTakenInHand)
{
  ASSERT_TRUE(hands->Start());
  stage->drag(grip(0, Osteotomy::Superior), shifted(grip(0, Osteotomy::Superior)));
  const Coordinates by_hand = stated("maxilla");
  plan->SetSelectedMethod(Plan::VirtualForce);
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", maxilla), 1e-9);
  EXPECT_LT(difference(Plan::VirtualForce, "maxilla", by_hand), 1e-9);
}

/// As a brush does that lies under the arrows.
TEST_F(FragmentHands, ArrowsAreTakenBeforeAToolBehindThem)
{
  vtkNew<vtkFaceToBoneFragmentWidget> other; // at the usual priority, and there first
  other->GetFragmentRepresentation()->SetReferencePoint({5, 0, -3});
  other->GetFragmentRepresentation()->SetMovement(maxilla);
  stage->use(other);
  ASSERT_TRUE(hands->Start());
  stage->drag(grip(0, Osteotomy::Superior), shifted(grip(0, Osteotomy::Superior)));
  EXPECT_NE(stated("maxilla"), maxilla);
  EXPECT_EQ(other->GetFragmentRepresentation()->GetMovement(), maxilla);
}

TEST_F(FragmentHands, WhatIsInTheWayIsSaid)
{
  vtkNew<vtkFaceToBoneFragmentHands> other;
  EXPECT_FALSE(other->Start());
  EXPECT_NE(other->GetObstacle().find("no plan"), std::string::npos);
  auto* empty = test::add_node<Plan>(scene, "Not planned yet");
  other->SetPlan(empty);
  EXPECT_NE(other->GetObstacle().find("compute the movement"), std::string::npos);
  other->SetPlan(plan);
  EXPECT_NE(other->GetObstacle().find("view"), std::string::npos);
  hands->SetPlan(empty);
  EXPECT_FALSE(hands->Start());
}

/// What may be taken away while a fragment is held.
class FragmentHeld : public FragmentHands
{
protected:
  void begin()
  {
    ASSERT_TRUE(hands->Start());
    from = grip(0, Osteotomy::Superior);
    stage->press(from);
    stage->move(shifted(from));
  }
  void go_on()
  {
    stage->move({from[0] + 30, from[1] + 30});
    stage->release({from[0] + 30, from[1] + 30});
    stage->drag(from, shifted(from));
    EXPECT_FALSE(hands->IsMoving());
  }
  std::array<int, 2> from{};
};

TEST_F(FragmentHeld, PlanIsDeleted)
{
  begin();
  scene->RemoveNode(plan);
  go_on();
}

TEST_F(FragmentHeld, TransformIsDeleted)
{
  begin();
  scene->RemoveNode(plan->GetTransformNode(Plan::RigidFit, "maxilla"));
  go_on();
  EXPECT_LT(difference(Plan::RigidFit, "chin", chin), 1e-9);
}

TEST_F(FragmentHeld, FragmentIsDeleted)
{
  begin();
  scene->RemoveNode(plan->GetFragmentNode(Plan::RigidFit, "maxilla"));
  go_on();
  EXPECT_LT(difference(Plan::RigidFit, "chin", chin), 1e-9);
}

TEST_F(FragmentHeld, OurTransformIsDeleted)
{
  begin();
  scene->RemoveNode(plan->GetFragmentNode(Plan::RigidFit, "maxilla")->GetParentTransformNode());
  go_on();
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", maxilla), 1e-9);
}

TEST_F(FragmentHeld, OsteotomyIsDeleted)
{
  begin();
  scene->RemoveNode(osteotomy);
  go_on();
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", maxilla), 1e-9);
}

TEST_F(FragmentHeld, SceneCloses)
{
  begin();
  scene->Clear(0);
  go_on();
}

TEST_F(FragmentHeld, SceneGoes)
{
  begin();
  scene = nullptr;
  go_on();
}

TEST_F(FragmentHeld, ViewGoes)
{
  begin();
  stage.reset();
  hands->SetView(nullptr, nullptr);
  EXPECT_FALSE(hands->IsMoving());
  EXPECT_LT(difference(Plan::RigidFit, "maxilla", maxilla), 1e-9);
  stage = std::make_unique<ToolStage>(to_polydata(testing::make_sheet(4, 80)));
  look_aside();
  hands->SetView(stage->interactor, stage->renderer);
  ASSERT_TRUE(hands->Start());
  stage->drag(grip(1, Osteotomy::Right), shifted(grip(1, Osteotomy::Right)));
  EXPECT_NE(stated("chin"), chin);
}

TEST_F(FragmentHands, RandomEventsFindNothing)
{
  std::mt19937 random(23);
  const int nodes = scene->GetNumberOfNodes();
  hands->Start();
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    std::vector<std::array<int, 2>> handles;
    for (int n = 0; n < hands->GetNumberOfFragments(); ++n)
      for (int c = 0; c < 6; ++c)
        handles.push_back(grip(n, c));
    stage->random_event(random, handles);
    switch (random() % 200)
    {
    case 0:
      hands->Stop();
      break;
    case 1:
      hands->Reset();
      break;
    case 2:
      plan->SetSelectedMethod(int(random() % 2));
      break;
    case 3:
      osteotomy->SetNthFragmentLocked(0, int(random() % 6), random() % 2);
      break;
    default:
      hands->Start();
    }
  }
  hands->Stop();
  for (int method = 0; method < Plan::Method_Last; ++method)
    EXPECT_LT(difference(method, "maxilla", maxilla), 1e-9);
  EXPECT_LT(result_moved(), 1e-9);
  EXPECT_EQ(scene->GetNumberOfNodes(), nodes);
}

} // namespace
} // namespace f2b
