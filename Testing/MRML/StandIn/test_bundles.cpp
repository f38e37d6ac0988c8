// Scenes with all of their data in one file (.mrb). Only Slicer's interface is used.
#include "scene_test.hpp"
#include "slicer_scene.hpp"
#include "zip_writer.hpp"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsPlaneNode.h>
#include <vtkMRMLScalarVolumeNode.h>

#include <vtkImageData.h>
#include <vtkTransform.h>

using namespace f2b::test;

namespace
{

/// A scene with one of each kind of data.
void fill(vtkMRMLScene* scene)
{
  auto* skin = add_model(scene, "Haut ü: 1/2");
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene, "move");
  vtkNew<vtkTransform> shift;
  shift->Translate(1.0, 2.0, 3.0);
  move->SetMatrixTransformToParent(shift->GetMatrix());
  skin->SetAndObserveTransformNodeID(move->GetID());
  auto* ct = add_node<vtkMRMLScalarVolumeNode>(scene, "CT");
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), 27, static_cast<short>(42));
  ct->SetAndObserveImageData(image);
  auto* plane = add_node<vtkMRMLMarkupsPlaneNode>(scene, "cut");
  plane->SetOrigin(4.0, 5.0, 6.0);
}

void expect_filled(vtkMRMLScene* scene)
{
  auto* skin = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName("Haut ü: 1/2"));
  ASSERT_NE(nullptr, skin);
  ASSERT_NE(nullptr, skin->GetPolyData());
  EXPECT_EQ(sphere()->GetNumberOfCells(), skin->GetPolyData()->GetNumberOfCells());
  ASSERT_NE(nullptr, skin->GetParentTransformNode());
  vtkNew<vtkMatrix4x4> matrix;
  skin->GetParentTransformNode()->GetMatrixTransformToParent(matrix);
  EXPECT_EQ(3.0, matrix->GetElement(2, 3));
  auto* ct = vtkMRMLScalarVolumeNode::SafeDownCast(scene->GetFirstNodeByName("CT"));
  ASSERT_NE(nullptr, ct);
  ASSERT_NE(nullptr, ct->GetImageData());
  EXPECT_EQ(42, *static_cast<short*>(ct->GetImageData()->GetScalarPointer(1, 1, 1)));
  auto* plane = vtkMRMLMarkupsPlaneNode::SafeDownCast(scene->GetFirstNodeByName("cut"));
  ASSERT_NE(nullptr, plane);
  double origin[3];
  plane->GetOrigin(origin);
  EXPECT_EQ(5.0, origin[1]);
}

std::string read_bundle(vtkMRMLScene* scene, const std::filesystem::path& file)
{
  vtkNew<vtkMRMLMessageCollection> messages;
  const bool read = scene->ReadFromMRB(file.c_str(), true, messages);
  return read ? "" : "failed: " + messages->GetAllMessagesAsString();
}

} // namespace

TEST(BundleTest, AllDataComeBack)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  fill(scene);
  ASSERT_TRUE(scene->WriteToMRB((folder / "fall ü.mrb").c_str()));
  EXPECT_EQ(1U, folder.file_count()) << "nothing else is left in the folder";
  vtkNew<vtkMRMLScene> again;
  ASSERT_EQ("", read_bundle(again, folder / "fall ü.mrb"));
  expect_filled(again);
  EXPECT_TRUE(again->GetStorableNodesModifiedSinceRead()) << "no files lie beside the scene";
  ASSERT_TRUE(again->WriteToMRB((folder / "again.mrb").c_str()));
  vtkNew<vtkMRMLScene> third;
  ASSERT_EQ("", read_bundle(third, folder / "again.mrb"));
  expect_filled(third);
}

TEST(BundleTest, WritingLeavesTheSceneAsItWas)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  fill(scene);
  auto* skin = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByClass("vtkMRMLModelNode"));
  ASSERT_TRUE(save_data(skin, folder / "skin.vtp"));
  ASSERT_TRUE(save_scene(scene, folder / "case.mrml"));
  ASSERT_TRUE(scene->WriteToMRB((folder / "case.mrb").c_str()));
  EXPECT_EQ((folder / "case.mrml").string(), scene->GetURL());
  EXPECT_EQ((folder / "skin.vtp").string(), skin->GetStorageNode()->GetFullNameFromFileName());
}

TEST(BundleTest, ABundleCanBeAddedToAScene)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> source;
  fill(source);
  ASSERT_TRUE(source->WriteToMRB((folder / "a.mrb").c_str()));
  vtkNew<vtkMRMLScene> scene;
  fill(scene);
  ASSERT_TRUE(scene->ReadFromMRB((folder / "a.mrb").c_str()));
  EXPECT_EQ(2, scene->GetNumberOfNodesByClass("vtkMRMLModelNode"));
}

TEST(BundleTest, FilesOfUnknownNodesGoAlong)
{
  const TemporaryFolder folder;
  const std::string segmentation = "NRRD0004 something that nothing here reads";
  folder.write("in/Data/Segmentation.seg.nrrd", segmentation);
  folder.write("in/scene.mrml",
               "<MRML><Segmentation id=\"vtkMRMLSegmentationNode1\""
               " references=\"storage:vtkMRMLSegmentationStorageNode1;\"></Segmentation>"
               "<SegmentationStorage id=\"vtkMRMLSegmentationStorageNode1\""
               " fileName=\"Data/Segmentation.seg.nrrd\"></SegmentationStorage></MRML>");
  vtkNew<vtkMRMLScene> scene;
  ASSERT_EQ("", load_scene(scene, folder / "in/scene.mrml"));
  ASSERT_TRUE(scene->WriteToMRB((folder / "a.mrb").c_str()));
  vtkNew<vtkMRMLScene> bundled;
  ASSERT_EQ("", read_bundle(bundled, folder / "a.mrb"));
  std::filesystem::remove_all(folder / "in");
  // Into the next bundle, and out of it beside a scene.
  ASSERT_TRUE(bundled->WriteToMRB((folder / "b.mrb").c_str()));
  vtkNew<vtkMRMLScene> again;
  ASSERT_EQ("", read_bundle(again, folder / "b.mrb"));
  ASSERT_TRUE(save_scene(again, folder / "scene.mrml"));
  EXPECT_EQ(segmentation, read_text(folder / "Data/Segmentation.seg.nrrd"));
  EXPECT_NE(std::string::npos,
            read_text(folder / "scene.mrml").find("fileName=\"Data/Segmentation.seg.nrrd\""));
}

TEST(BundleTest, FilesThatCannotBeReadGoAlong)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  const std::string other =
      "#Insight Transform File V1.0\n#Transform 0\nTransform: Unheard_double_3_3\n";
  folder.write("scene.mrml",
               "<MRML><LinearTransform id=\"vtkMRMLLinearTransformNode1\" name=\"t\""
               " references=\"storage:vtkMRMLTransformStorageNode1;\"></LinearTransform>"
               "<TransformStorage id=\"vtkMRMLTransformStorageNode1\""
               " fileName=\"other.tfm\"></TransformStorage></MRML>");
  folder.write("other.tfm", other);
  vtkNew<vtkMRMLScene> scene;
  EXPECT_NE("", load_scene(scene, folder / "scene.mrml"));
  ASSERT_TRUE(scene->WriteToMRB((folder / "a.mrb").c_str()));
  vtkNew<vtkMRMLScene> unpacked;
  const std::string mrml =
      vtkMRMLScene::UnpackSlicerDataBundle((folder / "a.mrb").c_str(), (folder / "out").c_str());
  ASSERT_NE("", mrml);
  EXPECT_EQ(other, read_text(std::filesystem::path(mrml).parent_path() / "Data/other.tfm"));
}

// --- Bundles that are wrong --------------------------------------------------------------------

class BadBundleTest : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BadBundleTest, NamesOutsideOfItAreRefused)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out");
  const std::string good = "<MRML></MRML>";
  folder.write("bad.mrb", zip({{"a/a.mrml", good}, {GetParam(), "evil"}}));
  EXPECT_EQ("", vtkMRMLScene::UnpackSlicerDataBundle((folder / "bad.mrb").c_str(),
                                                     (folder / "out/here").c_str()));
  EXPECT_FALSE(std::filesystem::exists(folder / "evil"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/evil"));
  EXPECT_FALSE(std::filesystem::exists("/tmp/evil"));
  vtkNew<vtkMRMLScene> scene;
  EXPECT_NE("", read_bundle(scene, folder / "bad.mrb"));
}

INSTANTIATE_TEST_SUITE_P(Names, BadBundleTest,
                         ::testing::Values("../evil", "a/../../evil", "/tmp/evil",
                                           "a/../../../evil", "..\\evil", "a/.."));

TEST(BundleTest, SceneInABundleCannotReadOutside)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> source;
  auto* skin = add_model(source, "skin");
  ASSERT_TRUE(save_data(skin, folder / "secret.vtp"));
  const std::string scene_file =
      "<MRML><Model id=\"vtkMRMLModelNode1\" name=\"skin\" "
      "references=\"storage:vtkMRMLModelStorageNode1;\">"
      "</Model><ModelStorage id=\"vtkMRMLModelStorageNode1\" fileName=\"" +
      (folder / "secret.vtp").string() + "\"></ModelStorage></MRML>";
  folder.write("bad.mrb", zip({{"a/a.mrml", scene_file}}));
  vtkNew<vtkMRMLScene> scene;
  const std::string message = read_bundle(scene, folder / "bad.mrb");
  EXPECT_NE(std::string::npos, message.find("outside")) << message;
}

TEST(BundleTest, WrongFilesAreErrors)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* mine = add_model(scene, "mine");
  EXPECT_NE("", read_bundle(scene, folder / "nothing.mrb"));
  EXPECT_NE("", read_bundle(scene, folder.write("text.mrb", "no zip")));
  EXPECT_NE("", read_bundle(scene, folder.write("empty.mrb", "")));
  EXPECT_NE("", read_bundle(scene, folder.write("other.mrb", zip({{"a/a.txt", "no scene"}}))));
  EXPECT_NE("", read_bundle(scene, folder.write("bad.mrb", zip({{"a/a.mrml", "<MRML>"}}))));
  EXPECT_EQ(mine, scene->GetFirstNodeByName("mine")) << "the scene is as it was";
  EXPECT_FALSE(scene->WriteToMRB((folder / "no such folder/a.mrb").c_str()));
}
