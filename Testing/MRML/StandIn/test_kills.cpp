// Programs that are killed while they save: 100 SIGKILLs, after each of which the scene opens, old or
// new, with data that belong to it.
#include "child_process.hpp"
#include "scene_test.hpp"

#include <vtkMath.h>

#include <chrono>
#include <random>
#include <thread>

using namespace f2b::test;

namespace
{

const int kills = 50; // of each kind of file

/// The n-th state of the scene: its number is in the scene file, and in the data by their size.
void set_state(vtkMRMLScene* scene, int n)
{
  for (const char* name : {"skin", "bone"})
  {
    auto* model = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName(name));
    model = model ? model : add_model(scene, name);
    model->SetAttribute("Test.State", std::to_string(n).c_str());
    model->SetAndObservePolyData(sphere(24, 10.0 + n));
  }
}

/// The scene's state, which all of its parts must agree on; -1 where they do not.
int state_of(vtkMRMLScene* scene)
{
  int state = -1;
  for (const char* name : {"skin", "bone"})
  {
    auto* model = vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName(name));
    if (!model || !model->GetPolyData())
    {
      return -1;
    }
    double bounds[6];
    model->GetRASBounds(bounds);
    const int of_data = vtkMath::Round(0.5 * (bounds[5] - bounds[4]) - 10.0);
    const int of_scene = std::stoi(model->GetAttribute("Test.State"));
    if (of_data != of_scene || (state >= 0 && state != of_scene))
    {
      return -1;
    }
    state = of_scene;
  }
  return state;
}

bool save(vtkMRMLScene* scene, const std::filesystem::path& folder)
{
  scene->StartState(vtkMRMLScene::SaveState);
  bool saved = true;
  for (const char* name : {"skin", "bone"})
  {
    saved = saved && save_data(vtkMRMLModelNode::SafeDownCast(scene->GetFirstNodeByName(name)),
                               folder / (std::string(name) + ".vtp"));
  }
  saved = saved && save_scene(scene, folder / "case.mrml");
  scene->EndState(vtkMRMLScene::SaveState);
  return saved;
}

/// Kills a child that saves over and over, again and again; after each kill `load` tells the state.
template <class Save, class Load>
void kill_while_saving(const Save& save_state, const Load& load)
{
  save_state(0);
  int last = 0;
  std::mt19937 random(20);
  std::uniform_int_distribution<int> microseconds(500, 40000);
  for (int i = 0; i < kills; ++i)
  {
    const pid_t child = start_child(
        [&]
        {
          for (int n = last + 1; n < last + 100000; ++n)
          {
            save_state(n % 30);
          }
        });
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    kill(child, SIGKILL);
    ASSERT_EQ(-SIGKILL, end_of(child)) << "the child saves until it is killed";
    const int state = load();
    ASSERT_GE(state, 0) << "after kill " << i;
    last = state;
  }
}

} // namespace

TEST(KillTest, SceneAndDataAreOldOrNew)
{
  const TemporaryFolder folder;
  kill_while_saving(
      [&folder](int n)
      {
        vtkNew<vtkMRMLScene> scene;
        set_state(scene, n);
        if (!save(scene, folder.path()))
        {
          _exit(4);
        }
      },
      [&folder]
      {
        vtkNew<vtkMRMLScene> scene;
        const std::string message = load_scene(scene, folder / "case.mrml");
        EXPECT_EQ("", message);
        return state_of(scene);
      });
}

TEST(KillTest, BundleIsOldOrNew)
{
  const TemporaryFolder folder;
  kill_while_saving(
      [&folder](int n)
      {
        vtkNew<vtkMRMLScene> scene;
        set_state(scene, n);
        if (!scene->WriteToMRB((folder / "case.mrb").c_str()))
        {
          _exit(4);
        }
      },
      [&folder]
      {
        vtkNew<vtkMRMLScene> scene;
        EXPECT_TRUE(scene->ReadFromMRB((folder / "case.mrb").c_str(), true));
        return state_of(scene);
      });
  EXPECT_LE(folder.file_count(), 3U) << "what kills leave does not pile up";
}
