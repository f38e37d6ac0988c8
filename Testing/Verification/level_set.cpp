#include "Core/error.hpp"
#include "Imaging/geodesic_contour.hpp"
#include "Imaging/read_ct.hpp"
#include "Imaging/segment_head.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <random>

/// Does the level set find more of the bone of a degraded CT than the threshold does?
///
/// `level_set CT BLUR_MM NOISE_HU` prints JSON: Dice of bone against the threshold's bone of the CT as
/// it is, for the degraded CT by the threshold and by the level set.

namespace
{

using namespace f2b;
using nlohmann::json;

/// Blurred along all axes, then white noise on every voxel.
CtImage::Pointer degraded(const CtImage& ct, double blur_mm, double noise_hu)
{
  const auto size = ct.GetBufferedRegion().GetSize();
  const std::size_t count = ct.GetBufferedRegion().GetNumberOfPixels();
  std::vector<float> values(ct.GetBufferPointer(), ct.GetBufferPointer() + count);
  // voxels are not cubes: the blur along each axis is that of the mean spacing
  const double spacing = std::cbrt(ct.GetSpacing()[0] * ct.GetSpacing()[1] * ct.GetSpacing()[2]);
  values = blurred({int(size[0]), int(size[1]), int(size[2])}, spacing, values, blur_mm);
  auto result = CtImage::New();
  result->SetRegions(ct.GetBufferedRegion());
  result->SetSpacing(ct.GetSpacing());
  result->SetOrigin(ct.GetOrigin());
  result->SetDirection(ct.GetDirection());
  result->Allocate();
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, noise_hu);
  for (std::size_t v = 0; v < count; ++v)
    result->GetBufferPointer()[v] = static_cast<short>(
        std::lround(std::max(-1024.0, std::min(3071.0, values[v] + noise(random)))));
  return result;
}

double dice(const ScalarGrid& a, const ScalarGrid& b)
{
  double both = 0, sum = 0;
  for (std::size_t s = 0; s < a.values.size(); ++s)
  {
    both += a.values[s] < 0 && b.values[s] < 0;
    sum += (a.values[s] < 0) + (b.values[s] < 0);
  }
  return 2 * both / sum;
}

json compare(const std::string& file, double blur_mm, double noise_hu)
{
  const CtImage::Pointer ct = read_ct(file);
  SegmentOptions options;
  const HeadSegmentation clean = segment_head(*ct, options);
  options.region_ras = clean.region_ras;
  options.skin_threshold_hu = clean.skin_threshold_hu;
  const CtImage::Pointer bad = degraded(*ct, blur_mm, noise_hu);
  const HeadSegmentation automatic = segment_head(*bad, options);
  SegmentOptions same = options;
  same.bone_threshold_hu = clean.bone_threshold_hu;
  const HeadSegmentation threshold = segment_head(*bad, same);
  same.level_set = LevelSetBoneOptions{};
  const HeadSegmentation level_set = segment_head(*bad, same);
  return {{"blur_mm", blur_mm},
          {"noise_hu", noise_hu},
          {"clean_threshold_hu", clean.bone_threshold_hu},
          {"automatic_threshold_hu", automatic.bone_threshold_hu},
          {"dice_threshold", dice(clean.bone, threshold.bone)},
          {"dice_automatic_threshold", dice(clean.bone, automatic.bone)},
          {"dice_level_set", dice(clean.bone, level_set.bone)}};
}

} // namespace

int main(int count, char** arguments)
try
{
  if (count != 4)
  {
    std::cerr << "usage: level_set CT BLUR_MM NOISE_HU\n";
    return 2;
  }
  std::cout << compare(arguments[1], std::stod(arguments[2]), std::stod(arguments[3])).dump(2)
            << '\n';
}
catch (const std::exception& error)
{
  std::cerr << error.what() << '\n';
  return 1;
}
