// How long do saving and loading a big scene take, against writing and reading the same bytes plainly on
// the same disk? A CT of 512 x 512 x 300 voxels, five models of half a million triangles, and the
// module's nodes. Prints JSON.
#include "scene_test.hpp"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLScalarVolumeNode.h>

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <random>

namespace
{

using namespace f2b::test;

struct Bytes
{
  const char* start;
  std::size_t count;
};

template <class Work>
double seconds(const Work& work)
{
  sync(); // what others left to be written is not ours to wait for
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double middle(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Bytes bytes_of(vtkDataArray* array)
{
  return {static_cast<const char*>(array->GetVoidPointer(0)),
          static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize())};
}

/// The scene, and the bytes that its data are.
std::vector<Bytes> fill(vtkMRMLScene* scene)
{
  std::vector<Bytes> data;
  auto* ct = add_node<vtkMRMLScalarVolumeNode>(scene, "CT");
  vtkNew<vtkImageData> image;
  image->SetDimensions(512, 512, 300);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* voxels = static_cast<short*>(image->GetScalarPointer());
  const std::size_t count = std::size_t{512} * 512 * 300;
  std::mt19937 random(1);
  std::generate_n(voxels, count, [&random] { return static_cast<short>(random() & 0xfff); });
  ct->SetAndObserveImageData(image);
  data.push_back({reinterpret_cast<const char*>(voxels), count * sizeof(short)});
  for (int i = 0; i < 5; ++i)
  {
    auto* model = add_model(scene, "model " + std::to_string(i), sphere(502, 50.0 + i));
    vtkPolyData* surface = model->GetPolyData();
    data.push_back(bytes_of(surface->GetPoints()->GetData()));
    data.push_back(bytes_of(surface->GetPointData()->GetNormals()));
    data.push_back(bytes_of(surface->GetPolys()->GetConnectivityArray()));
    data.push_back(bytes_of(surface->GetPolys()->GetOffsetsArray()));
  }
  add_node<vtkMRMLFaceToBoneTargetNode>(scene, "target");
  add_node<vtkMRMLFaceToBoneOsteotomyNode>(scene, "osteotomy");
  add_node<vtkMRMLFaceToBonePlanNode>(scene, "plan");
  return data;
}

bool save(vtkMRMLScene* scene, const std::filesystem::path& folder)
{
  bool saved = true;
  scene->StartState(vtkMRMLScene::SaveState);
  std::vector<vtkMRMLNode*> nodes;
  scene->GetNodesByClass("vtkMRMLDisplayableNode", nodes);
  for (vtkMRMLNode* one : nodes)
  {
    auto* node = vtkMRMLStorableNode::SafeDownCast(one);
    node->AddDefaultStorageNode();
    node->GetStorageNode()->SetUseCompression(0);
    saved = saved && save_data(node, folder / (std::string(node->GetName()) +
                                               (node->IsA("vtkMRMLModelNode") ? ".vtp" : ".nrrd")));
  }
  saved = saved && save_scene(scene, folder / "case.mrml");
  scene->EndState(vtkMRMLScene::SaveState);
  return saved;
}

double copy_plainly(const std::vector<Bytes>& data, const std::filesystem::path& folder)
{
  return seconds(
      [&]
      {
        for (std::size_t i = 0; i < data.size(); ++i)
        {
          std::ofstream(folder / ("raw" + std::to_string(i)), std::ios::binary)
              .write(data[i].start, static_cast<std::streamsize>(data[i].count));
        }
        for (std::size_t i = 0; i < data.size(); ++i)
        {
          const std::unique_ptr<char[]> read(new char[data[i].count]);
          std::ifstream(folder / ("raw" + std::to_string(i)), std::ios::binary)
              .read(read.get(), static_cast<std::streamsize>(data[i].count));
        }
      });
}

} // namespace

int main(int, char** arguments)
{
  const std::filesystem::path folder = std::filesystem::path(arguments[1]) / "scene times ü";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  vtkNew<vtkMRMLScene> scene;
  scene->RegisterNodeClass(vtkNew<vtkMRMLFaceToBoneTargetNode>());
  scene->RegisterNodeClass(vtkNew<vtkMRMLFaceToBoneOsteotomyNode>());
  scene->RegisterNodeClass(vtkNew<vtkMRMLFaceToBonePlanNode>());
  const std::vector<Bytes> data = fill(scene);
  std::size_t total = 0;
  for (const Bytes& bytes : data)
  {
    total += bytes.count;
  }
  // One after the other, and the middle of nine: what else the machine does disturbs neighbours alike.
  std::vector<double> raw, saving, loading, ratio;
  bool whole = true;
  for (int i = 0; i < 9; ++i)
  {
    raw.push_back(copy_plainly(data, folder));
    saving.push_back(seconds([&] { whole = save(scene, folder) && whole; }));
    vtkNew<vtkMRMLScene> again;
    scene->CopyRegisteredNodesToScene(again);
    loading.push_back(
        seconds([&] { whole = load_scene(again, folder / "case.mrml").empty() && whole; }));
    ratio.push_back((saving.back() + loading.back()) / raw.back());
  }
  std::filesystem::remove_all(folder);
  std::printf("{\"megabytes\": %.0f, \"raw_s\": %.3f, \"save_s\": %.3f, \"load_s\": %.3f, "
              "\"ratio\": %.2f}\n",
              static_cast<double>(total) / 1e6, middle(raw), middle(saving), middle(loading),
              middle(ratio));
  return whole ? 0 : 1;
}
