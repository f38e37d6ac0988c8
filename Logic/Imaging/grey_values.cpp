#include "Imaging/grey_values.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace f2b
{
namespace
{

constexpr int lowest = -32768, count = 65536;
using Histogram = std::array<double, count>;

/// Means over a window of values; noise makes peaks of its own.
Histogram smoothed(const Histogram& histogram, int half_width)
{
  Histogram sums{}, result{};
  double sum = 0;
  for (int v = 0; v < count; ++v)
    sums[static_cast<std::size_t>(v)] = sum += histogram[static_cast<std::size_t>(v)];
  for (int v = 0; v < count; ++v)
  {
    const int high = std::min(count - 1, v + half_width), low = v - half_width - 1;
    result[static_cast<std::size_t>(v)] = (sums[static_cast<std::size_t>(high)] -
                                           (low >= 0 ? sums[static_cast<std::size_t>(low)] : 0)) /
                                          (2 * half_width + 1);
  }
  return result;
}

int highest(const Histogram& histogram, int from, int to)
{
  return static_cast<int>(std::max_element(histogram.begin() + from, histogram.begin() + to) -
                          histogram.begin());
}

/// Values below and above which little lies: padding and metal are not anatomy.
int quantile(const Histogram& histogram, double total, double share)
{
  double sum = 0;
  for (int v = 0; v < count; ++v)
    if ((sum += histogram[static_cast<std::size_t>(v)]) >= share * total)
      return v;
  return count - 1;
}

} // namespace

std::string to_hounsfield(CtImage& ct, const std::string& name)
{
  short* voxels = ct.GetBufferPointer();
  const std::size_t size = ct.GetBufferedRegion().GetNumberOfPixels();
  Histogram raw{};
  const short padding = *std::min_element(voxels, voxels + size);
  double total = 0;
  for (std::size_t v = 0; v < size; ++v)
    if (voxels[v] != padding) // outside the cylinder that a cone beam sees
    {
      raw[static_cast<std::size_t>(voxels[v] - lowest)] += 1;
      total += 1;
    }
  const int low = quantile(raw, total, 0.002), high = quantile(raw, total, 0.998),
            range = std::max(high - low, 1);
  const Histogram histogram = smoothed(raw, std::max(2, range / 100));
  // air is the peak of the lower third; soft tissue the highest one clearly above it
  const int air = highest(histogram, low, low + range / 3);
  const int first = air + range / 8;
  const int tissue = first < high ? highest(histogram, first, low + 3 * range / 4 + 1) : air;
  const bool is_peak = tissue > first && histogram[static_cast<std::size_t>(tissue)] >
                                             1.2 * histogram[static_cast<std::size_t>(first)];
  if (range < 100 || !is_peak)
    throw Error(name,
                "its grey values from " + std::to_string(low + lowest) + " to " +
                    std::to_string(high + lowest) + " show no peaks of air and soft tissue",
                "give a CT whose field of view holds both");
  const double scale = 1040.0 / (tissue - air);
  for (std::size_t v = 0; v < size; ++v)
    voxels[v] = static_cast<short>(
        std::clamp(std::lround((voxels[v] - lowest - air) * scale - 1000.0), -1024L, 32767L));
  return "Grey values " + std::to_string(air + lowest) + " (air) and " +
         std::to_string(tissue + lowest) + " (soft tissue) are taken as -1000 and 40 HU.";
}

} // namespace f2b
