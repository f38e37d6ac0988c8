// Scenes to files and back. Only Slicer's interface is used.
#include "scene_test.hpp"
#include "slicer_scene.hpp"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsFiducialNode.h>
#include <vtkMRMLModelStorageNode.h>
#include <vtkMRMLScalarVolumeDisplayNode.h>
#include <vtkMRMLScalarVolumeNode.h>

#include <vtkMatrix4x4.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

using namespace f2b::test;

namespace
{

using Element = vtkSmartPointer<vtkXMLDataElement>;

Element parse(const std::string& xml)
{
  return Element::Take(vtkXMLUtilities::ReadElementFromString(xml.c_str()));
}

/// Elements by their id.
std::map<std::string, vtkXMLDataElement*> by_id(vtkXMLDataElement* root)
{
  std::map<std::string, vtkXMLDataElement*> all;
  for (int i = 0; i < root->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = root->GetNestedElement(i);
    all[element->GetAttribute("id")] = element;
  }
  return all;
}

/// Numbers compare as numbers, lists of references without their order, texts as they are.
std::multiset<std::string> words(const std::string& text)
{
  std::multiset<std::string> found;
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ';', ' ');
  std::istringstream stream(spaced);
  for (std::string word; stream >> word;)
  {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    found.insert(*end == '\0' ? std::to_string(number) : word);
  }
  return found;
}

/// What of the first is not in the second, as one text.
std::string lost(vtkXMLDataElement* before, vtkXMLDataElement* after)
{
  std::string missing;
  if (std::string(before->GetName()) != after->GetName())
  {
    missing += std::string("<") + before->GetName() + ">; ";
  }
  for (int i = 0; i < before->GetNumberOfAttributes(); ++i)
  {
    const char* name = before->GetAttributeName(i);
    const char* value = after->GetAttribute(name);
    if (!value || words(value) != words(before->GetAttributeValue(i)))
    {
      missing += std::string(name) + "=" + before->GetAttributeValue(i) + " became " +
                 (value ? value : "nothing") + "; ";
    }
  }
  if (before->GetNumberOfNestedElements() != after->GetNumberOfNestedElements())
  {
    return missing + "children; ";
  }
  for (int i = 0; i < before->GetNumberOfNestedElements(); ++i)
  {
    missing += lost(before->GetNestedElement(i), after->GetNestedElement(i));
  }
  return missing;
}

std::string lost(const std::string& before, const std::string& after)
{
  const Element first = parse(before);
  const Element second = parse(after);
  const auto kept = by_id(second);
  std::string missing;
  for (const auto& [id, element] : by_id(first))
  {
    const auto found = kept.find(id);
    missing += found == kept.end() ? id + " is gone; " : lost(element, found->second);
  }
  return missing;
}

} // namespace

// --- What Slicer writes ------------------------------------------------------------------------

class SlicerSceneTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    m_scene->SetReadDataOnLoad(0); // the files are not there
    m_file = m_folder.write("scene.mrml", slicer_scene);
    ASSERT_EQ("", load_scene(m_scene, m_file));
  }
  TemporaryFolder m_folder;
  std::filesystem::path m_file;
  vtkNew<vtkMRMLScene> m_scene;
};

TEST_F(SlicerSceneTest, IsUnderstood)
{
  EXPECT_STREQ("Slicer 5.2.2 31382", m_scene->GetLastLoadedVersion());
  auto* skin = vtkMRMLModelNode::SafeDownCast(m_scene->GetNodeByID("vtkMRMLModelNode4"));
  ASSERT_NE(nullptr, skin);
  EXPECT_STREQ("Skin \"soft\" & lips", skin->GetName());
  EXPECT_STREQ("50% of it; then more", skin->GetAttribute("Plan.Note"));
  ASSERT_NE(nullptr, skin->GetModelDisplayNode());
  EXPECT_EQ(0.85, skin->GetModelDisplayNode()->GetOpacity());
  EXPECT_STREQ("signed distance", skin->GetModelDisplayNode()->GetActiveScalarName());
  EXPECT_EQ(-5.0, skin->GetModelDisplayNode()->GetScalarRange()[0]);
  EXPECT_EQ(vtkMRMLDisplayNode::UseManualScalarRange,
            skin->GetModelDisplayNode()->GetScalarRangeFlag());
  ASSERT_NE(nullptr, skin->GetParentTransformNode());
  ASSERT_NE(nullptr, skin->GetStorageNode());
  EXPECT_EQ(m_folder / "Data/Skin 'soft'.vtk", skin->GetStorageNode()->GetFullNameFromFileName());
  vtkNew<vtkMatrix4x4> matrix;
  skin->GetParentTransformNode()->GetMatrixTransformToWorld(matrix);
  EXPECT_EQ(12.3457, matrix->GetElement(0, 3));

  auto* ct = vtkMRMLScalarVolumeNode::SafeDownCast(m_scene->GetFirstNodeByName("CT"));
  ASSERT_NE(nullptr, ct);
  ct->GetIJKToRASMatrix(matrix);
  EXPECT_EQ(-0.488281, matrix->GetElement(0, 0));
  EXPECT_EQ(1.25, matrix->GetElement(2, 2));
  EXPECT_EQ(-80.0, matrix->GetElement(2, 3));
  EXPECT_EQ(40.5, ct->GetScalarVolumeDisplayNode()->GetLevel());
}

TEST_F(SlicerSceneTest, LosesNothingWhenSaved)
{
  ASSERT_TRUE(save_scene(m_scene, m_file));
  EXPECT_EQ("", lost(slicer_scene, read_text(m_file)));
}

TEST_F(SlicerSceneTest, LosesNothingInAnotherFolder)
{
  std::filesystem::create_directories(m_folder / "other");
  ASSERT_TRUE(save_scene(m_scene, m_folder / "other/moved.mrml"));
  std::string moved = read_text(m_folder / "other/moved.mrml");
  EXPECT_NE(std::string::npos, moved.find("\"../Data/CT.nrrd\"")) << "where the files still are";
  for (auto at = moved.find("\"../Data/"); at != std::string::npos; at = moved.find("\"../Data/"))
  {
    moved.replace(at, 9, "\"Data/");
  }
  EXPECT_EQ("", lost(slicer_scene, moved));
}

TEST_F(SlicerSceneTest, ClashingIdsChangeInUnknownElementsToo)
{
  vtkNew<vtkMRMLScene> scene;
  scene->SetReadDataOnLoad(0);
  auto* mine = add_node<vtkMRMLScalarVolumeNode>(scene, "mine");
  ASSERT_STREQ("vtkMRMLScalarVolumeNode1", mine->GetID());
  scene->SetURL(m_file.c_str());
  ASSERT_EQ(1, scene->Import());
  const std::string ct = scene->GetFirstNodeByName("CT")->GetID();
  ASSERT_NE("vtkMRMLScalarVolumeNode1", ct);
  const std::string xml = scene_text(scene);
  EXPECT_NE(std::string::npos, xml.find("referenceImageGeometryRef:" + ct + ";"));
  EXPECT_NE(std::string::npos, xml.find("ActiveVolume:" + ct + ";"));
  EXPECT_NE(std::string::npos, xml.find("dataNode=\"" + ct + "\""));
}

// --- What we write -----------------------------------------------------------------------------

TEST(SceneFileTest, SceneAndDataComeBack)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* skin = add_model(scene, "Haut & Knochen <1>");
  skin->SetDescription("line 1\nline 2\ttab");
  skin->SetAttribute("Plan.Note", "x");
  skin->GetDisplayNode()->SetColor(0.1, 0.2, 0.3);
  ASSERT_TRUE(save_data(skin, folder / "haut ü & 50%.vtp"));
  ASSERT_TRUE(save_scene(scene, folder / "szene ä.mrml"));

  vtkNew<vtkMRMLScene> again;
  ASSERT_EQ("", load_scene(again, folder / "szene ä.mrml"));
  auto* back = vtkMRMLModelNode::SafeDownCast(again->GetNodeByID(skin->GetID()));
  ASSERT_NE(nullptr, back);
  EXPECT_STREQ(skin->GetName(), back->GetName());
  EXPECT_STREQ(skin->GetDescription(), back->GetDescription());
  EXPECT_EQ(0.1, back->GetDisplayNode()->GetColor()[0]);
  ASSERT_NE(nullptr, back->GetPolyData());
  EXPECT_EQ(skin->GetPolyData()->GetNumberOfCells(), back->GetPolyData()->GetNumberOfCells());
  EXPECT_FALSE(back->GetModifiedSinceRead());
}

TEST(SceneFileTest, AttributeValuesComeBack)
{
  vtkNew<vtkMRMLScene> scene;
  auto* node = add_node<vtkMRMLModelNode>(scene, "n");
  const std::string value = "50%; 100%25 \"quoted\" <x> & 'y' %3B";
  node->SetAttribute("Plan.Note", value.c_str());
  vtkNew<vtkMRMLScene> again;
  ASSERT_EQ(1, import_text(again, scene_text(scene)));
  EXPECT_STREQ(value.c_str(), again->GetFirstNodeByName("n")->GetAttribute("Plan.Note"));
}

TEST(SceneFileTest, FoldersCanBeMoved)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "here/data");
  {
    vtkNew<vtkMRMLScene> scene;
    auto* skin = add_model(scene, "skin");
    ASSERT_TRUE(save_data(skin, folder / "here/data/skin.vtp"));
    ASSERT_TRUE(save_scene(scene, folder / "here/case.mrml"));
  }
  EXPECT_NE(std::string::npos,
            read_text(folder / "here/case.mrml").find("fileName=\"data/skin.vtp\""));
  std::filesystem::rename(folder / "here", folder / "there");
  vtkNew<vtkMRMLScene> scene;
  ASSERT_EQ("", load_scene(scene, folder / "there/case.mrml"));
  EXPECT_NE(nullptr,
            vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName("skin"))->GetPolyData());
}

TEST(SceneFileTest, NumbersKeepTheirDigits)
{
  const double value = 123.456789012345678;
  vtkNew<vtkMRMLScene> scene;
  auto* model = add_model(scene, "skin");
  model->GetDisplayNode()->SetScalarRange(-value, 1.0 / 3.0);
  auto* transform = add_node<vtkMRMLLinearTransformNode>(scene, "move");
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, value);
  matrix->SetElement(1, 2, 1e-17);
  transform->SetMatrixTransformToParent(matrix);
  vtkNew<vtkMRMLScene> again;
  ASSERT_EQ(1, import_text(again, scene_text(scene)));
  auto* back = vtkMRMLModelNode::SafeDownCast(again->GetFirstNodeByName("skin"));
  EXPECT_EQ(-value, back->GetDisplayNode()->GetScalarRange()[0]);
  EXPECT_EQ(1.0 / 3.0, back->GetDisplayNode()->GetScalarRange()[1]);
  vtkNew<vtkMatrix4x4> moved;
  vtkMRMLTransformNode::SafeDownCast(again->GetFirstNodeByName("move"))
      ->GetMatrixTransformToParent(moved);
  EXPECT_EQ(value, moved->GetElement(0, 3));
  EXPECT_EQ(1e-17, moved->GetElement(1, 2));
}

TEST(SceneFileTest, NodesThatAreNotSavedStayOut)
{
  vtkNew<vtkMRMLScene> scene;
  add_node<vtkMRMLModelNode>(scene, "kept");
  add_node<vtkMRMLModelNode>(scene, "transient")->SetSaveWithScene(0);
  const std::string xml = scene_text(scene);
  EXPECT_NE(std::string::npos, xml.find("kept"));
  EXPECT_EQ(std::string::npos, xml.find("transient"));
}

TEST(SceneFileTest, KnowsWhatIsNotSaved)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  EXPECT_FALSE(scene->GetModifiedSinceRead());
  auto* skin = add_model(scene, "skin");
  EXPECT_TRUE(scene->GetModifiedSinceRead());
  EXPECT_TRUE(scene->GetStorableNodesModifiedSinceRead());
  ASSERT_TRUE(save_data(skin, folder / "skin.vtp"));
  ASSERT_TRUE(save_scene(scene, folder / "case.mrml"));
  EXPECT_FALSE(scene->GetModifiedSinceRead());
  EXPECT_FALSE(scene->GetStorableNodesModifiedSinceRead());
  skin->GetPolyData()->Modified();
  EXPECT_TRUE(scene->GetStorableNodesModifiedSinceRead());
}

// --- Files that are wrong ----------------------------------------------------------------------

class BadSceneTest : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BadSceneTest, IsAnErrorAndNoNodeIsAdded)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  const std::string message = load_scene(scene, folder.write("bad.mrml", GetParam()));
  EXPECT_NE("", message);
  EXPECT_EQ(0, scene->GetNumberOfNodes());
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadSceneTest,
    ::testing::Values("", "no XML", "<MRML", "<MRML><Model id=\"a\"></MRML>",
                      "<MRML><Model id=\"a\" id=\"b\"></Model></MRML>",
                      "<MRML><Model name=\"&nothing;\"></Model></MRML>",
                      "<!DOCTYPE l [<!ENTITY a \"aaaaaaaaaaaaaaaaaaaa\"><!ENTITY b "
                      "\"&a;&a;&a;&a;&a;&a;&a;&a;\"> ]><MRML><Model name=\"&b;\"></MRML>"));

TEST(SceneFileTest, NoFileIsAnError)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  EXPECT_NE("", load_scene(scene, folder / "nothing.mrml"));
  EXPECT_FALSE(save_scene(scene, folder / "no such folder/case.mrml"));
}

TEST(SceneFileTest, MissingDataIsAnErrorThatNamesTheFile)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  const std::string message = load_scene(scene, folder.write("scene.mrml", slicer_scene));
  EXPECT_NE(std::string::npos, message.find("CT.nrrd")) << message;
  EXPECT_NE(nullptr, scene->GetFirstNodeByName("CT")) << "the rest is there";
}
