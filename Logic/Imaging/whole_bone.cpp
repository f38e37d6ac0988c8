#include "Imaging/whole_bone.hpp"

#include "Core/error.hpp"
#include "Imaging/histogram.hpp"
#include "Imaging/resample_ct.hpp"
#include "Imaging/signed_distance.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

WholeBone find_whole_bone(const CtImage& ct, const std::string& name,
                          std::optional<double> threshold_hu)
{
  constexpr double least_ml = 30;
  WholeBone whole;
  whole.hu = resample_ct(ct, lattice_over(extent_ras(ct), whole_bone_spacing, anchor_ras(ct)));
  whole.threshold_hu =
      threshold_hu ? *threshold_hu : automatic_bone_threshold(tissue_peaks(whole.hu));
  ScalarGrid level = whole.hu;
  for (float& v : level.values)
    v = static_cast<float>(whole.threshold_hu) - v;
  const auto samples =
      std::count_if(level.values.begin(), level.values.end(), [](float v) { return v < 0; });
  const double ml = static_cast<double>(samples) * std::pow(whole_bone_spacing, 3) / 1000;
  if (ml < least_ml)
    throw Error(name,
                "it shows only " + std::to_string(std::lround(ml)) + " ml of bone (above " +
                    std::to_string(std::lround(whole.threshold_hu)) + " HU)",
                "give a CT of the head in Hounsfield units");
  whole.bone = signed_distance(level);
  return whole;
}

} // namespace f2b
