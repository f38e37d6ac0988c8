#include "full_nodes.hpp"

#include <cmath>

namespace f2b::test
{
namespace
{

using Target = vtkMRMLFaceToBoneTargetNode;
using Osteotomy = vtkMRMLFaceToBoneOsteotomyNode;
using Plan = vtkMRMLFaceToBonePlanNode;

template <class Node>
class OurNodes : public ::testing::Test
{
};
using AllNodes = ::testing::Types<Target, Osteotomy, Plan>;
TYPED_TEST_SUITE(OurNodes, AllNodes);

TYPED_TEST(OurNodes, ComeBackFromXmlWithEveryDigit)
{
  const auto scene = scene_with_our_nodes();
  auto* node = add_node<TypeParam>(scene, "first");
  fill(node);
  const std::string written = xml_of(node);
  const auto again = scene_with_our_nodes();
  load(again, saved(scene));
  auto* read = node_named<TypeParam>(again, "first");
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(xml_of(read), written);
}

TYPED_TEST(OurNodes, AreRegisteredByTheirTag)
{
  const auto scene = scene_with_our_nodes();
  const vtkNew<TypeParam> node;
  EXPECT_STREQ(scene->GetClassNameByTag(node->GetNodeTagName()), node->GetClassName());
}

TYPED_TEST(OurNodes, CopyTakesEverything)
{
  const vtkNew<TypeParam> full, copy, content;
  fill(full.Get());
  copy->Copy(full);
  EXPECT_EQ(xml_of(copy), xml_of(full));
  ASSERT_TRUE(content->HasCopyContent());
  content->CopyContent(full);
  EXPECT_EQ(xml_of(content), xml_of(full));
}

TYPED_TEST(OurNodes, CopyInvokesOneEventAndNoneWhereNothingChanges)
{
  const vtkNew<TypeParam> full, copy;
  fill(full.Get());
  EventCount modified(copy, vtkCommand::ModifiedEvent);
  copy->CopyContent(full);
  EXPECT_EQ(modified.taken(), 1);
  copy->CopyContent(full);
  EXPECT_EQ(modified.taken(), 0);
}

TYPED_TEST(OurNodes, SettingTheSameAgainIsNoChange)
{
  const vtkNew<TypeParam> node;
  EventCount modified(node, vtkCommand::ModifiedEvent);
  fill(node.Get());
  EXPECT_GT(modified.taken(), 5);
  fill(node.Get());
  EXPECT_EQ(modified.taken(), 0);
}

TYPED_TEST(OurNodes, ManyChangesInABlockAreOneEvent)
{
  const vtkNew<TypeParam> node;
  EventCount modified(node, vtkCommand::ModifiedEvent);
  {
    MRMLNodeModifyBlocker blocker(node);
    fill(node.Get());
    EXPECT_EQ(modified.taken(), 0);
  }
  EXPECT_EQ(modified.taken(), 1);
}

TYPED_TEST(OurNodes, ResetBringsTheDefaultsBack)
{
  const vtkNew<TypeParam> node, fresh;
  fill(node.Get());
  node->Reset(nullptr);
  EXPECT_EQ(xml_of(node), xml_of(fresh));
}

TYPED_TEST(OurNodes, PrintThemselves)
{
  const vtkNew<TypeParam> node;
  fill(node.Get());
  std::ostringstream text;
  node->Print(text);
  EXPECT_GT(text.str().size(), 100u);
}

TEST(FaceToBoneOsteotomyNodeTest, NamesOfFragmentsAreValidAndDistinct)
{
  const vtkNew<Osteotomy> node;
  EXPECT_EQ(node->AddFragment("mid-face"), 0);
  for (const char* bad : {"", "mid-face", "-x", "a/b", "a:b", "a;b", "ü"})
    EXPECT_EQ(node->AddFragment(bad), -1) << bad;
  EXPECT_EQ(node->AddFragment(std::string(41, 'a')), -1);
  EXPECT_EQ(node->AddFragment(std::string(40, 'a')), 1);
  EXPECT_FALSE(node->SetNthFragmentName(1, "mid-face"));
  EXPECT_TRUE(node->SetNthFragmentName(1, "chin"));
  EXPECT_EQ(node->GetFragmentIndex("chin"), 1);
}

TEST(FaceToBoneOsteotomyNodeTest, EachRuleIsKeptByItself)
{
  const vtkNew<Osteotomy> node;
  fill(node.Get());
  double numbers[2] = {};
  EXPECT_TRUE(node->GetNthFragmentLocked(0, Osteotomy::Roll));
  EXPECT_FALSE(node->GetNthFragmentLocked(0, Osteotomy::Yaw));
  EXPECT_FALSE(node->GetNthFragmentLocked(1, Osteotomy::Roll));
  EXPECT_TRUE(node->GetNthFragmentBounds(0, Osteotomy::Anterior, numbers));
  EXPECT_EQ(numbers[1], 8.1);
  EXPECT_FALSE(node->GetNthFragmentBounds(0, Osteotomy::Superior, numbers));
  EXPECT_TRUE(node->GetNthFragmentPrior(1, Osteotomy::Superior, numbers));
  EXPECT_EQ(numbers[1], 1.0 / 7);
  node->RemoveNthFragmentPrior(1, Osteotomy::Superior);
  EXPECT_FALSE(node->GetNthFragmentPrior(1, Osteotomy::Superior, numbers));
}

TEST(FaceToBonePlanNodeTest, CaseFolderIsRelativeWhereTheSceneLiesAboveIt)
{
  const auto scene = scene_with_our_nodes();
  scene->SetRootDirectory("/data/patient");
  auto* plan = add_node<Plan>(scene, "plan");
  auto folder_of = [](vtkMRMLNode* node)
  {
    const std::string text = xml_of(node);
    const std::size_t begin = text.find("caseFolder=\"") + 12;
    return text.substr(begin, text.find('"', begin) - begin);
  };
  plan->SetCaseFolder("/data/patient");
  EXPECT_EQ(folder_of(plan), ".");
  plan->SetCaseFolder("/data/patient/plan 2");
  EXPECT_EQ(folder_of(plan), "plan 2");
  plan->SetCaseFolder("/data/patient2");
  EXPECT_EQ(folder_of(plan), "/data/patient2");
}

TEST(FaceToBonePlanNodeTest, FiguresThatCannotBeSavedAreRefused)
{
  const vtkNew<Plan> plan;
  plan->GlobalWarningDisplayOff();
  plan->SetFigure("x", std::nan(""));
  plan->SetFigure("a=b", 1);
  plan->GlobalWarningDisplayOn();
  EXPECT_TRUE(plan->GetFigureNames().empty());
  plan->SetFigure("a/x", 1);
  plan->SetFigure("b/x", 2);
  plan->RemoveFigures("a/");
  EXPECT_TRUE(std::isnan(plan->GetFigure("a/x")));
  EXPECT_EQ(plan->GetFigure("b/x"), 2);
}

TEST(FaceToBonePlanNodeTest, ProgressIsAnEventButNoChange)
{
  const vtkNew<Plan> plan;
  EventCount modified(plan, vtkCommand::ModifiedEvent), progress(plan, Plan::ProgressEvent);
  plan->SetProgress(0.5, "meshing");
  plan->SetProgress(0.5, "meshing");
  EXPECT_EQ(progress.taken(), 1);
  EXPECT_EQ(modified.taken(), 0);
}

} // namespace
} // namespace f2b::test
