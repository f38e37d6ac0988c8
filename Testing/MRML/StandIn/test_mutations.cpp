// Damaged files: an error or a load, never a crash, and nothing outside of the scene's folder touched.
// 100 seeds; F2B_MUTATIONS names another number (the full tier takes 1000), F2B_MUTATION_SEED the first.
// Damaged models are not among them: VTK's readers allocate what a damaged size asks for.
#include "child_process.hpp"
#include "scene_test.hpp"
#include "slicer_scene.hpp"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsCurveNode.h>
#include <vtkMRMLMarkupsPlaneNode.h>
#include <vtkMRMLScalarVolumeNode.h>

#include <vtkImageData.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <random>

using namespace f2b::test;

namespace
{

/// A scene with all kinds of data beside it, and the same as a bundle.
void write_good_case(const std::filesystem::path& folder)
{
  vtkNew<vtkMRMLScene> scene;
  auto* skin = add_model(scene, "skin");
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene, "move");
  move->SetMatrixTransformToParent(nullptr);
  skin->SetAndObserveTransformNodeID(move->GetID());
  auto* plane = add_node<vtkMRMLMarkupsPlaneNode>(scene, "plane");
  plane->SetOrigin(1.0, 2.0, 3.0);
  auto* curve = add_node<vtkMRMLMarkupsCurveNode>(scene, "curve");
  for (int i = 0; i < 5; ++i)
  {
    curve->AddControlPoint(i, 0.5 * i * i, -i, "p");
  }
  curve->CreateDefaultDisplayNodes();
  auto* ct = add_node<vtkMRMLScalarVolumeNode>(scene, "CT");
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), 64, static_cast<short>(7));
  ct->SetAndObserveImageData(image);
  ASSERT_TRUE(scene->WriteToMRB((folder / "case.mrb").c_str()));
  ASSERT_TRUE(save_data(skin, folder / "skin.vtp"));
  ASSERT_TRUE(save_data(move, folder / "move.tfm"));
  ASSERT_TRUE(save_data(plane, folder / "plane.mrk.json"));
  ASSERT_TRUE(save_data(curve, folder / "curve.mrk.json"));
  ASSERT_TRUE(save_data(ct, folder / "ct.nrrd"));
  ASSERT_TRUE(save_scene(scene, folder / "case.mrml"));
  std::ofstream(folder / "slicer.mrml") << slicer_scene;
}

std::string mutated(std::string bytes, std::mt19937& random)
{
  static const char* const pieces[] = {"../",
                                       "/",
                                       "\"",
                                       "<",
                                       ">",
                                       "</",
                                       "&#0;",
                                       "&amp;",
                                       "]]>",
                                       "<!--",
                                       "%25",
                                       "%00",
                                       ";",
                                       ":",
                                       "-1",
                                       "1e999",
                                       "nan",
                                       "0",
                                       "[",
                                       "{",
                                       "null",
                                       "\\u0000",
                                       "9999999999999",
                                       "\xff\xfe",
                                       "PK\x03\x04",
                                       "../../../../tmp/f2b_evil",
                                       "vtkMRMLModelNode1",
                                       "%s%n",
                                       "fileName=\"../evil.vtp\"",
                                       "singletonTag=\"1\"",
                                       "id=\"\"",
                                       "<Model></Model>"};
  const auto pick = [&random](std::size_t n)
  { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t changes = 1 + pick(6);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i)
  {
    const std::size_t at = pick(bytes.size());
    const std::size_t length = std::min(bytes.size() - at, 1 + pick(40));
    switch (pick(6))
    {
    case 0:
      bytes[at] = static_cast<char>(pick(256));
      break;
    case 1:
      bytes.erase(at, length);
      break;
    case 2:
      bytes.insert(at, pieces[pick(std::size(pieces))]);
      break;
    case 3:
      bytes.insert(at, bytes.substr(pick(bytes.size()), length));
      break;
    case 4:
      bytes.replace(at, length, pieces[pick(std::size(pieces))]);
      break;
    default:
      bytes.resize(pick(20) == 0 ? at : bytes.size());
    }
  }
  return bytes;
}

/// All files below a folder but one of its folders, with their contents.
std::map<std::string, std::string> files_but(const std::filesystem::path& folder,
                                             const std::filesystem::path& but)
{
  std::map<std::string, std::string> files;
  for (auto entry = std::filesystem::recursive_directory_iterator(folder);
       entry != std::filesystem::recursive_directory_iterator(); ++entry)
  {
    if (entry->path() == but)
    {
      entry.disable_recursion_pending();
    }
    else if (entry->is_regular_file())
    {
      files[entry->path()] = read_text(entry->path());
    }
  }
  return files;
}

/// Loads a file in whatever way it can be, saves the scene and loads it again.
void use(const std::filesystem::path& file)
{
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkMRMLScene> scene;
  if (file.extension() == ".mrb")
  {
    scene->ReadFromMRB(file.c_str(), true);
    scene->WriteToMRB((file.parent_path() / "again.mrb").c_str());
  }
  else
  {
    load_scene(scene, file);
  }
  save_scene(scene, file.parent_path() / "again.mrml");
  vtkNew<vtkMRMLScene> again;
  again->SetURL((file.parent_path() / "again.mrml").c_str());
  again->Import();
  again->Import();
  scene->Clear(1);
}

} // namespace

TEST(MutationTest, IsAnErrorOrALoadButNeverACrash)
{
  const TemporaryFolder folder;
  const auto good = folder / "good";
  std::filesystem::create_directories(good);
  write_good_case(good);
  const auto outside = folder / "outside";
  folder.write("outside/neighbour.vtp", "not to be touched");
  const auto scene_folder = outside / "scene";
  const auto untouched = files_but(outside, scene_folder);

  const char* const wanted = std::getenv("F2B_MUTATIONS");
  const int count = wanted ? std::atoi(wanted) : 100;
  const char* const damaged[] = {"case.mrml",      "slicer.mrml", "plane.mrk.json",
                                 "curve.mrk.json", "case.mrb",    "move.tfm"};
  const char* const first = std::getenv("F2B_MUTATION_SEED");
  for (int seed = first ? std::atoi(first) : 0; seed < count; ++seed)
  {
    std::mt19937 random(static_cast<unsigned int>(seed));
    const std::string name = damaged[static_cast<std::size_t>(seed) % std::size(damaged)];
    std::filesystem::remove_all(scene_folder);
    std::filesystem::copy(good, scene_folder);
    std::ofstream(scene_folder / name, std::ios::binary) << mutated(read_text(good / name), random);
    const bool scene_itself = name.find(".mrml") != std::string::npos || name == "case.mrb";
    const auto file = scene_folder / (scene_itself ? name : "case.mrml");
    ASSERT_EQ(0, end_of(start_child([&file] { use(file); }))) << "seed " << seed << ", " << name;
    ASSERT_EQ(untouched, files_but(outside, scene_folder)) << "seed " << seed << ", " << name;
    ASSERT_FALSE(std::filesystem::exists("/tmp/f2b_evil")) << "seed " << seed << ", " << name;
  }
  std::printf("%d damaged files\n", count);
}
