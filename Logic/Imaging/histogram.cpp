#include "Imaging/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace f2b
{
namespace
{

constexpr int lowest = -1100, highest = 400, bin_width = 5;

std::vector<double> histogram_of(const ScalarGrid& hu)
{
  std::vector<double> counts((highest - lowest) / bin_width, 0.0);
  for (const float v : hu.values)
    if (v >= lowest && v < highest)
      counts[static_cast<std::size_t>((v - lowest) / bin_width)] += 1.0;
  return counts;
}

std::vector<double> smoothed(const std::vector<double>& counts, int half_width)
{
  const int n = static_cast<int>(counts.size());
  std::vector<double> result(counts.size(), 0.0);
  for (int b = 0; b < n; ++b)
    for (int o = std::max(0, b - half_width); o <= std::min(n - 1, b + half_width); ++o)
      result[b] += counts[o];
  return result;
}

int bin_of(double hu)
{
  return static_cast<int>((hu - lowest) / bin_width);
}

double centre_of(int bin)
{
  return lowest + (bin + 0.5) * bin_width;
}

double median_between(const std::vector<double>& counts, double from, double to)
{
  double total = 0.0, sum = 0.0;
  for (int b = bin_of(from); b < bin_of(to); ++b)
    total += counts[b];
  for (int b = bin_of(from); b < bin_of(to); ++b)
    if ((sum += counts[b]) >= 0.5 * total)
      return centre_of(b);
  return from;
}

} // namespace

TissuePeaks tissue_peaks(const ScalarGrid& hu)
{
  const std::vector<double> counts = histogram_of(hu);
  const std::vector<double> smooth = smoothed(counts, 2);
  TissuePeaks peaks;
  peaks.air = median_between(counts, lowest, -500);
  const auto first = smooth.begin() + bin_of(-150), last = smooth.begin() + bin_of(200);
  const auto peak = std::max_element(first, last);
  peaks.soft_tissue = centre_of(static_cast<int>(peak - smooth.begin()));
  // Only the side towards bone: fat lies on the other one.
  auto half = peak;
  while (half != last && *half > 0.5 * *peak)
    ++half;
  peaks.soft_tissue_width = bin_width * static_cast<double>(half - peak);
  return peaks;
}

double automatic_skin_threshold(const TissuePeaks& peaks)
{
  return std::round(peaks.soft_tissue + 0.25 * (peaks.air - peaks.soft_tissue));
}

double automatic_bone_threshold(const TissuePeaks& peaks)
{
  const double above = std::clamp(3.0 * peaks.soft_tissue_width, 160.0, 300.0);
  return std::round(peaks.soft_tissue + above);
}

} // namespace f2b
