#include "Logic/Scene/logic_case.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/case_folder.hpp"
#include "Case/file_checksum.hpp"

#include <vtkMRMLDisplayNode.h>
#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsCurveNode.h>
#include <vtkMRMLMarkupsPlaneNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLStorageNode.h>

#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace f2b::test
{
namespace
{

using nlohmann::json;
using Plan = vtkMRMLFaceToBonePlanNode;
using Target = vtkMRMLFaceToBoneTargetNode;

/// Calls the logic as a host's event loop does, until the step has ended.
void wait_for_end(vtkSlicerFaceToBoneLogic* logic)
{
  while (logic->ProcessEvents())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

/// Whether every file that case.mrml names is there, and every step's result has its node.
void expect_scene_and_folder_agree(const std::filesystem::path& folder)
{
  LogicScene world;
  Plan* plan = world.logic->OpenCase(folder.string());
  ASSERT_NE(plan, nullptr) << world.logic->GetErrorText();
  if (std::filesystem::exists(folder / "case.mrml"))
  {
    LogicScene scene_alone;
    scene_alone.scene->SetURL((folder / "case.mrml").c_str());
    EXPECT_EQ(scene_alone.scene->Connect(), 1);
    EXPECT_EQ(scene_alone.scene->GetNumberOfNodes(), world.scene->GetNumberOfNodes());
  }
  EXPECT_EQ(plan->GetSkinNode() != nullptr, std::filesystem::exists(folder / "skin.vtp"));
  EXPECT_EQ(plan->GetOsteotomyNode()->GetUncutBoneNode() != nullptr,
            std::filesystem::exists(folder / "cut.json"));
  EXPECT_EQ(plan->GetMeshNode() != nullptr, std::filesystem::exists(folder / "mesh.vtu"));
}

TEST(LogicTest, AllStepsThroughNodes)
{
  const TemporaryFolder folder;
  LogicScene world;
  Plan* plan = world.logic->AddPlanFromFile(write_coarse_case(folder.path()).string());
  ASSERT_NE(plan, nullptr) << world.logic->GetErrorText();
  plan->SetCaseFolder((folder / "case").string());
  ASSERT_TRUE(world.logic->Segment(plan)) << plan->GetStatusText();
  ASSERT_NE(plan->GetSkinNode(), nullptr);
  EXPECT_GT(plan->GetSkinNode()->GetPolyData()->GetNumberOfPoints(), 1000);
  EXPECT_EQ(plan->GetStepStatus(Plan::Segment), Plan::Current);
  EXPECT_EQ(plan->GetStepStatus(Plan::Cut), Plan::NotDone);

  ASSERT_TRUE(world.logic->Cut(plan)) << plan->GetStatusText();
  auto* osteotomy = plan->GetOsteotomyNode();
  ASSERT_GE(osteotomy->GetNthFragmentNumberOfPlanes(0), 1);
  ASSERT_NE(osteotomy->GetNthFragmentRestNode(0), nullptr);
  EXPECT_EQ(osteotomy->GetNthFragmentRestNode(0)->GetParentTransformNode(), nullptr);

  ASSERT_TRUE(world.logic->Mesh(plan)) << plan->GetStatusText();
  ASSERT_TRUE(world.logic->Target(plan)) << plan->GetStatusText();
  ASSERT_TRUE(world.logic->Plan(plan)) << plan->GetStatusText();
  const json told = read_json(folder / "case/plan.json");
  for (int method = 0; method < Plan::Method_Last; ++method)
  {
    const char* name = Plan::GetSelectedMethodAsString(method);
    const json& fragment = told.at("methods").at(name).at("fragments").at(0);
    auto* transform = plan->GetTransformNode(method, "mid-face");
    ASSERT_NE(transform, nullptr);
    const vtkNew<vtkMatrix4x4> matrix;
    transform->GetMatrixTransformToParent(matrix);
    for (int i = 0; i < 16; ++i)
      EXPECT_NEAR(matrix->GetElement(i / 4, i % 4), fragment["matrix_ras"].at(i).get<double>(),
                  1e-12);
    EXPECT_EQ(plan->GetFragmentNode(method, "mid-face")->GetParentTransformNode(), transform);
    double movement[6];
    ASSERT_TRUE(plan->GetMovement(method, "mid-face", movement));
    EXPECT_EQ(movement[1], fragment["translation_mm"]["anterior"].get<double>());
    auto* display = plan->GetPredictionNode(method)->GetDisplayNode();
    EXPECT_STREQ(display->GetActiveScalarName(), Plan::DistanceArrayName);
    EXPECT_EQ(display->GetScalarRange()[0], -display->GetScalarRange()[1]);
  }
  EXPECT_EQ(plan->GetFigure("rigid-fit/skin_error_mm/mean"),
            told["methods"]["rigid-fit"]["skin_error_mm"]["mean"].get<double>());
  const json provenance = json::parse(plan->GetProvenance());
  EXPECT_EQ(provenance["ct_nrrd_sha256"], sha256_of(folder / "case/ct.nrrd"));
  EXPECT_EQ(provenance["methods"], (json{"rigid-fit", "virtual-force"}));
  EXPECT_EQ(provenance["date"].get<std::string>().size(),
            std::string("2026-11-28T13:00:00Z").size());
  EXPECT_TRUE(provenance["versions"].contains("FaceToBone"));
  expect_scene_and_folder_agree(folder / "case");

  // a target sculpted on the node goes into the case before the plan
  auto* skin = plan->GetTargetNode()->GetTargetSkinNode();
  auto* displacement = skin->GetPolyData()->GetPointData()->GetArray(Target::DisplacementArrayName);
  ASSERT_NE(displacement, nullptr);
  const double sculpted[3] = {0.5, 3.25, -1.5};
  displacement->SetTuple(7, sculpted);
  ASSERT_TRUE(world.logic->Target(plan)) << plan->GetStatusText();
  const auto written = read_surface(folder / "case/target.vtp");
  const std::vector<Vec3> array = point_vectors(written, Target::DisplacementArrayName);
  EXPECT_NEAR((array[7] - Vec3(0.5, 3.25, -1.5)).norm(), 0, 1e-5);
  EXPECT_EQ(plan->GetTargetNode()->GetKind(), Target::Mesh);
  EXPECT_EQ(plan->GetTransformNode(Plan::RigidFit, "mid-face"), nullptr); // stale: gone
  EXPECT_EQ(plan->GetStepStatus(Plan::Plan), Plan::NotDone);
  EXPECT_TRUE(plan->GetMovementFragments(Plan::RigidFit).empty());

  // and so does a plane that was dragged
  auto* plane = vtkMRMLMarkupsPlaneNode::SafeDownCast(osteotomy->GetNthFragmentPlaneNode(0, 0));
  ASSERT_NE(plane, nullptr);
  double origin[3];
  plane->GetOrigin(origin);
  origin[2] -= 2;
  plane->SetOrigin(origin);
  EXPECT_FALSE(world.logic->Mesh(plan));
  EXPECT_NE(plan->GetStatusText().find("cut"), std::string::npos);
  ASSERT_TRUE(world.logic->Cut(plan)) << plan->GetStatusText();
  const json settings = read_json(folder / "case/case.json");
  EXPECT_FALSE(settings["osteotomies"][0].contains("template"));
  EXPECT_EQ(settings["osteotomies"][0]["planes"].size(),
            static_cast<std::size_t>(osteotomy->GetNthFragmentNumberOfPlanes(0)));
  EXPECT_EQ(plan->GetMeshNode(), nullptr);
  expect_scene_and_folder_agree(folder / "case");
}

/// A case as far as `segment`, made once for all tests.
class SegmentedOnce
{
public:
  SegmentedOnce()
  {
    std::filesystem::create_directories(m_folder);
    LogicScene world;
    Plan* plan = world.logic->AddPlanFromFile(write_coarse_case(m_folder).string());
    plan->SetCaseFolder(case_folder().string());
    EXPECT_TRUE(world.logic->Segment(plan)) << plan->GetStatusText();
  }
  ~SegmentedOnce() { std::filesystem::remove_all(m_folder); }
  SegmentedOnce(const SegmentedOnce&) = delete;
  SegmentedOnce& operator=(const SegmentedOnce&) = delete;

  std::filesystem::path case_folder() const { return m_folder / "case"; }

private:
  std::filesystem::path m_folder =
      std::filesystem::temp_directory_path() / ("f2b logic " + std::to_string(::getpid()));
};

/// Its copy, open in a scene.
struct SegmentedCase
{
  SegmentedCase()
  {
    static const SegmentedOnce made;
    std::filesystem::copy(made.case_folder(), folder / "case",
                          std::filesystem::copy_options::recursive);
    plan = world.logic->OpenCase((folder / "case").string());
    EXPECT_NE(plan, nullptr) << world.logic->GetErrorText();
  }

  TemporaryFolder folder;
  LogicScene world;
  Plan* plan = nullptr;
};

TEST(LogicTest, CurvesAreMarkupsThatCanBeDragged)
{
  SegmentedCase c;
  auto* osteotomy = c.plan->GetOsteotomyNode();
  osteotomy->SetNthFragmentTemplate(0, "zygoma-left");
  ASSERT_TRUE(c.world.logic->Cut(c.plan)) << c.plan->GetStatusText();
  ASSERT_EQ(osteotomy->GetNthFragmentNumberOfCurves(0), 1);
  auto* curve = vtkMRMLMarkupsCurveNode::SafeDownCast(osteotomy->GetNthFragmentCurveNode(0, 0));
  ASSERT_NE(curve, nullptr);
  const int count = curve->GetNumberOfControlPoints();
  ASSERT_GT(count, 2);
  ASSERT_TRUE(c.world.logic->Cut(c.plan)) << c.plan->GetStatusText();
  const auto entry = [&c] { return read_json(c.folder / "case/case.json")["osteotomies"][0]; };
  EXPECT_EQ(entry().value("template", ""), "zygoma-left"); // nothing was dragged

  double place[3];
  curve->GetNthControlPointPosition(count - 1, place);
  place[2] -= 0.5;
  curve->SetNthControlPointPosition(count - 1, place);
  ASSERT_TRUE(c.world.logic->Cut(c.plan)) << c.plan->GetStatusText();
  const json edited = entry();
  EXPECT_FALSE(edited.contains("template"));
  ASSERT_EQ(edited["curves"].size(), 1u);
  EXPECT_TRUE(edited["curves"][0].contains("depth_mm")); // the template's
  EXPECT_EQ(edited["planes"].size(), 1u);
  const auto file = edited["curves"][0]["markup"].get<std::string>();
  EXPECT_EQ(file.find('/'), std::string::npos);
  const PointMarkup drawn = read_points(c.folder / "case" / file);
  EXPECT_NEAR((drawn.points.back().position - Vec3(place[0], place[1], place[2])).norm(), 0, 1e-4);

  // the folder holds all of it
  std::filesystem::rename(c.folder / "case", c.folder / "elsewhere");
  LogicScene again;
  Plan* plan = again.logic->OpenCase((c.folder / "elsewhere").string());
  ASSERT_NE(plan, nullptr) << again.logic->GetErrorText();
  ASSERT_TRUE(again.logic->Cut(plan)) << plan->GetStatusText();
  for (const char* name : {"case.json", "case.mrml"})
    EXPECT_EQ(read_text(c.folder / "elsewhere" / name).find(c.folder.path().string()),
              std::string::npos)
        << name;
  EXPECT_EQ(read_json(c.folder / "elsewhere/case.json")["osteotomies"][0], edited);
  expect_scene_and_folder_agree(c.folder / "elsewhere");
}

TEST(LogicTest, TwoCasesInOneSceneDoNotDisturbEachOther)
{
  SegmentedCase c;
  std::filesystem::copy(c.folder / "case", c.folder / "other",
                        std::filesystem::copy_options::recursive);
  vtkSlicerFaceToBoneLogic* logic = c.world.logic;
  Plan* other = logic->OpenCase((c.folder / "other").string());
  ASSERT_NE(other, nullptr) << logic->GetErrorText();
  ASSERT_NE(other, c.plan);
  EXPECT_NE(other->GetSkinNode(), c.plan->GetSkinNode());
  EXPECT_NE(other->GetOsteotomyNode(), c.plan->GetOsteotomyNode());
  EXPECT_EQ(other->GetTargetNode()->GetReferenceSkinNode(), other->GetSkinNode());
  ASSERT_TRUE(logic->Cut(other)) << other->GetStatusText();
  EXPECT_EQ(other->GetStepStatus(Plan::Cut), Plan::Current);
  EXPECT_EQ(c.plan->GetStepStatus(Plan::Cut), Plan::NotDone);
  EXPECT_EQ(c.plan->GetOsteotomyNode()->GetUncutBoneNode(), nullptr);
  expect_scene_and_folder_agree(c.folder / "case");
  expect_scene_and_folder_agree(c.folder / "other");
}

TEST(LogicTest, ADamagedSceneFileIsMadeAnew)
{
  SegmentedCase c;
  const std::string whole = read_text(c.folder / "case/case.mrml");
  for (const std::string& damaged :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("\0\xff scene", 8),
        std::string("<MRML version=\"Slicer4.4.0\"></MRML>")})
  {
    c.folder.write("case/case.mrml", damaged);
    LogicScene again;
    Plan* plan = again.logic->OpenCase((c.folder / "case").string());
    ASSERT_NE(plan, nullptr) << again.logic->GetErrorText();
    EXPECT_NE(plan->GetSkinNode(), nullptr);
    EXPECT_EQ(again.scene->GetNumberOfNodesByClass("vtkMRMLFaceToBonePlanNode"), 1);
    ASSERT_TRUE(again.logic->Cut(plan)) << plan->GetStatusText();
    expect_scene_and_folder_agree(c.folder / "case");
  }
}

TEST(LogicTest, ASceneThatIsOpenedAsAFileDoesItsSteps)
{
  SegmentedCase c;
  LogicScene other;
  other.scene->SetURL((c.folder / "case/case.mrml").c_str());
  ASSERT_EQ(other.scene->Connect(), 1);
  auto* plan = Plan::SafeDownCast(other.scene->GetFirstNodeByClass("vtkMRMLFaceToBonePlanNode"));
  ASSERT_NE(plan, nullptr);
  EXPECT_TRUE(std::filesystem::equivalent(plan->GetCaseFolder(), c.folder / "case"));
  const int before = other.scene->GetNumberOfNodesByClass("vtkMRMLModelNode");
  ASSERT_TRUE(other.logic->Cut(plan)) << plan->GetStatusText();
  EXPECT_EQ(plan->GetStepStatus(Plan::Cut), Plan::Current);
  EXPECT_EQ(other.scene->GetNumberOfNodesByClass("vtkMRMLModelNode"), before + 2);
  expect_scene_and_folder_agree(c.folder / "case");
}

TEST(LogicTest, AClosedSceneEndsItsStep)
{
  SegmentedCase c;
  const std::string before = read_text(c.folder / "case/case.mrml");
  const vtkSmartPointer<Plan> kept = c.plan; // as an undo stack may
  ASSERT_TRUE(c.world.logic->Start(c.plan, Plan::Cut));
  c.world.scene->Clear(0);
  wait_for_end(c.world.logic);
  EXPECT_EQ(c.world.scene->GetNumberOfNodesByClass("vtkMRMLModelNode"), 0);
  EXPECT_EQ(read_text(c.folder / "case/case.mrml"), before);
  EXPECT_FALSE(std::filesystem::exists(c.folder / "case/cut.json"));
}

TEST(LogicTest, NodesThatAreDeletedDuringAStepComeBack)
{
  SegmentedCase c;
  ASSERT_TRUE(c.world.logic->Start(c.plan, Plan::Cut));
  c.world.scene->RemoveNode(c.plan->GetOsteotomyNode());
  c.world.scene->RemoveNode(c.plan->GetSkinNode());
  wait_for_end(c.world.logic);
  EXPECT_EQ(c.plan->GetStatusCode(), 0) << c.plan->GetStatusText();
  ASSERT_NE(c.plan->GetOsteotomyNode(), nullptr);
  EXPECT_EQ(c.plan->GetOsteotomyNode()->GetNthFragmentName(0), "mid-face");
  EXPECT_NE(c.plan->GetOsteotomyNode()->GetUncutBoneNode(), nullptr);
  EXPECT_NE(c.plan->GetSkinNode(), nullptr);
  expect_scene_and_folder_agree(c.folder / "case");
}

TEST(LogicTest, StepsInAThreadEndLikeOthers)
{
  SegmentedCase c;
  ASSERT_TRUE(c.world.logic->Start(c.plan, Plan::Cut));
  EXPECT_TRUE(c.world.logic->IsRunning());
  EXPECT_FALSE(c.world.logic->Start(c.plan, Plan::Mesh)); // one at a time
  wait_for_end(c.world.logic);
  EXPECT_EQ(c.plan->GetStatusCode(), 0) << c.plan->GetStatusText();
  EXPECT_EQ(c.plan->GetStepStatus(Plan::Cut), Plan::Current);
  EXPECT_TRUE(std::filesystem::exists(c.folder / "case/case.mrml"));
  expect_scene_and_folder_agree(c.folder / "case");
}

TEST(LogicTest, CancelledStepsLeaveTheCaseAsItWas)
{
  SegmentedCase c;
  const std::string before = read_text(c.folder / "case/case.mrml");
  ASSERT_TRUE(c.world.logic->Start(c.plan, Plan::Cut));
  c.world.logic->Cancel();
  wait_for_end(c.world.logic);
  EXPECT_EQ(c.plan->GetStatusCode(), 4);
  EXPECT_EQ(c.plan->GetStepStatus(Plan::Cut), Plan::NotDone);
  EXPECT_FALSE(std::filesystem::exists(c.folder / "case/cut.json"));
  EXPECT_EQ(read_text(c.folder / "case/case.mrml"), before);
}

TEST(LogicTest, FailuresAreASentenceOnTheNode)
{
  SegmentedCase c;
  c.plan->SetMeshDensity(21);
  EXPECT_FALSE(c.world.logic->Cut(c.plan));
  EXPECT_EQ(c.plan->GetStatusCode(), 2);
  EXPECT_NE(c.plan->GetStatusText().find("density"), std::string::npos);
  EXPECT_NE(c.plan->GetStatusText().find("20"), std::string::npos);
  c.plan->SetMeshDensity(0.05);
  EXPECT_TRUE(c.world.logic->Cut(c.plan)) << c.plan->GetStatusText();
  EXPECT_EQ(c.plan->GetStatusCode(), 0);
  EXPECT_EQ(c.plan->GetStatusText(), "");
}

TEST(LogicTest, APlanWithoutItsFolderSaysSo)
{
  SegmentedCase c; // as a bundle that was opened elsewhere
  c.plan->SetCaseFolder((c.folder / "nowhere").string());
  EXPECT_FALSE(c.world.logic->Cut(c.plan));
  EXPECT_EQ(c.plan->GetStatusCode(), 2);
  EXPECT_NE(c.plan->GetStatusText().find("nowhere"), std::string::npos);
  EXPECT_NE(c.plan->GetStatusText().find("no such case folder"), std::string::npos);
}

TEST(LogicTest, ChangedSettingsMakeResultsStale)
{
  SegmentedCase c;
  ASSERT_TRUE(c.world.logic->Cut(c.plan));
  c.plan->GetOsteotomyNode()->SetNthFragmentKerfMm(0, 2);
  c.world.logic->UpdateStepStatuses(c.plan);
  EXPECT_EQ(c.plan->GetStepStatus(Plan::Segment), Plan::Current);
  EXPECT_EQ(c.plan->GetStepStatus(Plan::Cut), Plan::Stale);
  c.plan->GetOsteotomyNode()->SetNthFragmentKerfMm(0, 1);
  c.world.logic->UpdateStepStatuses(c.plan);
  EXPECT_EQ(c.plan->GetStepStatus(Plan::Cut), Plan::Current);
}

TEST(LogicTest, OldFoldersWithoutASceneOpen)
{
  SegmentedCase c;
  std::filesystem::remove(c.folder / "case/case.mrml");
  expect_scene_and_folder_agree(c.folder / "case");
}

TEST(LogicTest, ACaseFileEditedByHandWins)
{
  SegmentedCase c;
  json settings = read_json(c.folder / "case/case.json");
  settings["mesh"]["density"] = 0.07;
  write_json(c.folder / "case/case.json", settings);
  LogicScene again;
  Plan* plan = again.logic->OpenCase((c.folder / "case").string());
  ASSERT_NE(plan, nullptr);
  EXPECT_EQ(plan->GetMeshDensity(), 0.07);
}

TEST(LogicTest, AnotherTemplateInTheCaseFileDoesNotKeepTheOldOnesName)
{
  SegmentedCase c;
  const std::filesystem::path folder = c.folder / "case";
  const auto choose = [&](const char* template_name)
  {
    json settings = read_json(folder / "case.json");
    settings["osteotomies"] = {{{"template", template_name}}};
    settings["target"].erase("from_movement");
    write_json(folder / "case.json", settings);
  };
  choose("le-fort-3");
  for (const char* name : {"mid-face", "maxilla"})
  {
    LogicScene world;
    Plan* plan = world.logic->OpenCase(folder.string());
    ASSERT_NE(plan, nullptr) << world.logic->GetErrorText();
    ASSERT_TRUE(world.logic->Cut(plan)) << plan->GetStatusText();
    EXPECT_EQ(plan->GetOsteotomyNode()->GetNthFragmentName(0), name);
    choose("le-fort-1");
  }
}

TEST(LogicTest, AMovedCaseFolderOpens)
{
  SegmentedCase c;
  std::filesystem::rename(c.folder / "case", c.folder / "elsewhere");
  LogicScene again;
  Plan* plan = again.logic->OpenCase((c.folder / "elsewhere").string());
  ASSERT_NE(plan, nullptr) << again.logic->GetErrorText();
  EXPECT_EQ(again.scene->GetNumberOfNodesByClass("vtkMRMLFaceToBonePlanNode"), 1);
  EXPECT_EQ(plan->GetCaseFolder(), std::filesystem::canonical(c.folder / "elsewhere").string());
  EXPECT_EQ(std::filesystem::path(plan->GetSkinNode()->GetStorageNode()->GetFileName())
                .lexically_normal(),
            std::filesystem::canonical(c.folder / "elsewhere") / "skin.vtp");
}

TEST(LogicTest, SceneAndFolderAgreeAfterEachKill)
{
  SegmentedCase c;
  const std::string folder = (c.folder / "case").string();
  for (int kill_ms = 0; kill_ms < 2000; kill_ms += 200)
  {
    const pid_t child = ::fork();
    if (child == 0)
    {
      LogicScene world;
      Plan* plan = world.logic->OpenCase(folder);
      for (int i = 0; plan && i < 100; ++i)
        world.logic->Cut(plan);
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(kill_ms));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    expect_scene_and_folder_agree(folder);
  }
}

} // namespace
} // namespace f2b::test
