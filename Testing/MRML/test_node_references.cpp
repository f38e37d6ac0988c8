#include "full_nodes.hpp"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>

#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace f2b::test
{
namespace
{

using Target = vtkMRMLFaceToBoneTargetNode;
using Osteotomy = vtkMRMLFaceToBoneOsteotomyNode;
using Plan = vtkMRMLFaceToBonePlanNode;
using Model = vtkMRMLModelNode;
using Transform = vtkMRMLLinearTransformNode;

/// A small case: two fragments of which one is planned by both methods.
struct SmallCase
{
  explicit SmallCase(vtkMRMLScene* scene, const std::string& prefix = "")
  {
    auto named = [&](const char* name) { return prefix + name; };
    plan = add_node<Plan>(scene, named("plan").c_str());
    target = add_node<Target>(scene, named("target").c_str());
    osteotomy = add_node<Osteotomy>(scene, named("osteotomy").c_str());
    skin = add_node<Model>(scene, named("skin").c_str());
    rest = add_node<Model>(scene, named("mid-face").c_str());
    plan->SetTargetNodeID(target->GetID());
    plan->SetOsteotomyNodeID(osteotomy->GetID());
    plan->SetSkinNodeID(skin->GetID());
    target->SetReferenceSkinNodeID(skin->GetID());
    target->SetTargetSkinNodeID(add_node<Model>(scene, named("target skin").c_str())->GetID());
    osteotomy->AddFragment("mid-face");
    osteotomy->AddFragment("chin");
    osteotomy->SetNthFragmentRestNodeID(0, rest->GetID());
    for (const char* plane : {"plane 1", "plane 2"})
      osteotomy->AddNthFragmentPlaneNodeID(0,
                                           add_node<Model>(scene, named(plane).c_str())->GetID());
    for (int method = 0; method < Plan::Method_Last; ++method)
    {
      const std::string way = named(Plan::GetSelectedMethodAsString(method));
      auto* transform = add_node<Transform>(scene, (way + " transform").c_str());
      auto* copy = add_node<Model>(scene, (way + " fragment").c_str());
      copy->SetAndObserveTransformNodeID(transform->GetID());
      plan->SetNodeReferenceID(Plan::GetTransformRole(method, "mid-face").c_str(),
                               transform->GetID());
      plan->SetNodeReferenceID(Plan::GetFragmentRole(method, "mid-face").c_str(), copy->GetID());
    }
  }

  Plan* plan;
  Target* target;
  Osteotomy* osteotomy;
  Model *skin, *rest;
};

std::string name_of(vtkMRMLNode* node)
{
  return node && node->GetName() ? node->GetName() : "none";
}

void expect_whole(vtkMRMLScene* scene, const std::string& prefix)
{
  auto* plan = node_named<Plan>(scene, (prefix + "plan").c_str());
  ASSERT_NE(plan, nullptr);
  ASSERT_EQ(name_of(plan->GetTargetNode()), prefix + "target");
  ASSERT_EQ(name_of(plan->GetOsteotomyNode()), prefix + "osteotomy");
  EXPECT_EQ(name_of(plan->GetSkinNode()), prefix + "skin");
  EXPECT_EQ(plan->GetTargetNode()->GetReferenceSkinNode(), plan->GetSkinNode());
  EXPECT_EQ(name_of(plan->GetTargetNode()->GetTargetSkinNode()), prefix + "target skin");
  Osteotomy* osteotomy = plan->GetOsteotomyNode();
  EXPECT_EQ(name_of(osteotomy->GetNthFragmentRestNode(0)), prefix + "mid-face");
  ASSERT_EQ(osteotomy->GetNthFragmentNumberOfPlanes(0), 2);
  EXPECT_EQ(name_of(osteotomy->GetNthFragmentPlaneNode(0, 1)), prefix + "plane 2");
  for (int method = 0; method < Plan::Method_Last; ++method)
  {
    auto* transform = plan->GetTransformNode(method, "mid-face");
    EXPECT_EQ(name_of(transform), prefix + Plan::GetSelectedMethodAsString(method) + " transform");
    ASSERT_NE(plan->GetFragmentNode(method, "mid-face"), nullptr);
    EXPECT_EQ(plan->GetFragmentNode(method, "mid-face")->GetParentTransformNode(), transform);
  }
}

TEST(NodeReferenceTest, SurviveTheFile)
{
  const auto scene = scene_with_our_nodes(), again = scene_with_our_nodes();
  const SmallCase small(scene);
  load(again, saved(scene));
  expect_whole(again, "");
}

TEST(NodeReferenceTest, FollowIdsThatClashOnImport)
{
  const auto scene = scene_with_our_nodes(), other = scene_with_our_nodes();
  const SmallCase mine(scene, "my "), theirs(other, "their ");
  import(scene, saved(other));
  expect_whole(scene, "my ");
  expect_whole(scene, "their ");
  EXPECT_STRNE(mine.plan->GetID(), node_named<Plan>(scene, "their plan")->GetID());
}

TEST(NodeReferenceTest, CasesInOneSceneDoNotDisturbEachOther)
{
  const auto scene = scene_with_our_nodes();
  const SmallCase first(scene, "first "), second(scene, "second ");
  const std::string before = xml_of(first.plan) + xml_of(first.osteotomy) + xml_of(first.target);
  EventCount modified(first.plan, vtkCommand::ModifiedEvent);
  fill(second.plan);
  fill(second.target);
  second.osteotomy->RemoveAllFragments();
  scene->RemoveNode(second.skin);
  scene->RemoveNode(second.osteotomy);
  EXPECT_EQ(modified.taken(), 0);
  EXPECT_EQ(xml_of(first.plan) + xml_of(first.osteotomy) + xml_of(first.target), before);
  expect_whole(scene, "first ");
}

TEST(NodeReferenceTest, TwoPlansMayShareTargetAndOsteotomy)
{
  const auto scene = scene_with_our_nodes(), again = scene_with_our_nodes();
  const SmallCase small(scene);
  auto* other = add_node<Plan>(scene, "other plan");
  other->SetTargetNodeID(small.target->GetID());
  other->SetOsteotomyNodeID(small.osteotomy->GetID());
  load(again, saved(scene));
  EXPECT_EQ(node_named<Plan>(again, "other plan")->GetTargetNode(),
            node_named<Plan>(again, "plan")->GetTargetNode());
}

TEST(NodeReferenceTest, OthersSurviveTheDeletionOfANode)
{
  const auto scene = scene_with_our_nodes(), again = scene_with_our_nodes();
  const SmallCase small(scene);
  scene->RemoveNode(small.skin);
  scene->RemoveNode(small.plan->GetTransformNode(Plan::RigidFit, "mid-face"));
  EXPECT_EQ(small.plan->GetSkinNode(), nullptr);
  EXPECT_EQ(small.target->GetReferenceSkinNode(), nullptr);
  EXPECT_EQ(small.plan->GetTransformNode(Plan::RigidFit, "mid-face"), nullptr);
  EXPECT_NE(small.plan->GetTransformNode(Plan::VirtualForce, "mid-face"), nullptr);
  EXPECT_EQ(small.plan->GetTargetNode(), small.target);
  load(again, saved(scene));
  EXPECT_EQ(node_named<Plan>(again, "plan")->GetSkinNode(), nullptr);
  EXPECT_NE(node_named<Plan>(again, "plan")->GetOsteotomyNode(), nullptr);
}

TEST(NodeReferenceTest, DeletingAPlanLeavesWhatItNamed)
{
  const auto scene = scene_with_our_nodes();
  const SmallCase small(scene);
  const int before = scene->GetNumberOfNodes();
  scene->RemoveNode(small.plan);
  EXPECT_EQ(scene->GetNumberOfNodes(), before - 1);
  EXPECT_EQ(small.osteotomy->GetNthFragmentRestNode(0), small.rest);
}

TEST(NodeReferenceTest, FragmentsTakeTheirReferencesAlong)
{
  const auto scene = scene_with_our_nodes();
  const SmallCase small(scene);
  ASSERT_TRUE(small.osteotomy->SetNthFragmentName(0, "maxilla"));
  EXPECT_EQ(small.osteotomy->GetNthFragmentRestNode(0), small.rest);
  EXPECT_EQ(small.osteotomy->GetNthFragmentNumberOfPlanes(0), 2);
  small.osteotomy->RemoveNthFragment(0);
  ASSERT_EQ(small.osteotomy->GetNthFragmentName(0), "chin");
  EXPECT_EQ(small.osteotomy->GetNthFragmentNumberOfPlanes(0), 0);
  EXPECT_EQ(small.osteotomy->AddFragment("maxilla"), 1);
  EXPECT_EQ(small.osteotomy->GetNthFragmentRestNode(1), nullptr);
}

TEST(NodeReferenceTest, CopyKeepsThem)
{
  const auto scene = scene_with_our_nodes();
  const SmallCase small(scene);
  auto* copy = add_node<Plan>(scene, "copy");
  copy->Copy(small.plan);
  EXPECT_EQ(copy->GetOsteotomyNode(), small.osteotomy);
  EXPECT_EQ(copy->GetTransformNode(Plan::VirtualForce, "mid-face"),
            small.plan->GetTransformNode(Plan::VirtualForce, "mid-face"));
}

TEST(NodeReferenceTest, RestFragmentsHaveNoTransform)
{
  const auto scene = scene_with_our_nodes(), again = scene_with_our_nodes();
  const SmallCase small(scene);
  load(again, saved(scene));
  EXPECT_EQ(node_named<Model>(again, "mid-face")->GetParentTransformNode(), nullptr);
}

TEST(DistanceMapTest, DisplaySettingsComeBack)
{
  const auto scene = scene_with_our_nodes(), again = scene_with_our_nodes();
  auto* model = add_node<Model>(scene, "predicted");
  auto* display = add_node<vtkMRMLModelDisplayNode>(scene, "predicted display");
  model->SetAndObserveDisplayNodeID(display->GetID());
  display->SetActiveScalarName(Plan::DistanceArrayName);
  display->SetScalarVisibility(1);
  display->SetScalarRangeFlag(vtkMRMLDisplayNode::UseManualScalarRange);
  display->SetScalarRange(-2.5, 2.5);
  load(again, saved(scene));
  auto* read = node_named<Model>(again, "predicted")->GetDisplayNode();
  ASSERT_NE(read, nullptr);
  EXPECT_STREQ(read->GetActiveScalarName(), Plan::DistanceArrayName);
  EXPECT_EQ(read->GetScalarVisibility(), 1);
  EXPECT_EQ(read->GetScalarRangeFlag(), vtkMRMLDisplayNode::UseManualScalarRange);
  EXPECT_DOUBLE_EQ(read->GetScalarRange()[0], -2.5);
  EXPECT_DOUBLE_EQ(read->GetScalarRange()[1], 2.5);
}

} // namespace
} // namespace f2b::test
