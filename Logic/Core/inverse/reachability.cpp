#include "Core/inverse/reachability.hpp"

#include "Core/inverse/skin_error.hpp"

#include <cmath>
#include <map>

namespace f2b
{
namespace
{

double root_mean_square(const SkinError& e)
{
  return std::sqrt(e.mean * e.mean + e.variance);
}

/// Says over which fragments the remainder lies.
void place_remainder(const std::vector<double>& left, const std::vector<double>& weight,
                     const std::vector<int>& fragment_below, RegionReach& reach)
{
  double all = 0, over_fragments = 0, most = 0;
  std::map<int, double> by_fragment;
  for (std::size_t v = 0; v < left.size(); ++v)
  {
    if (weight[v] <= 0)
      continue;
    const double squared = weight[v] * left[v] * left[v];
    all += squared;
    if (fragment_below[v] >= 0)
      by_fragment[fragment_below[v]] += squared;
  }
  for (const auto& [fragment, squared] : by_fragment)
  {
    over_fragments += squared;
    if (squared > most)
    {
      most = squared;
      reach.fragment = fragment;
    }
  }
  reach.left_over_fragments = all > 0 ? over_fragments / all : 0;
}

RegionReach reach_of(const std::vector<double>& asked, const std::vector<double>& left,
                     const std::vector<double>& weight, const SkinParts& parts)
{
  RegionReach reach;
  for (std::size_t v = 0; v < weight.size(); ++v)
    reach.area_mm2 += weight[v] > 0 ? parts.area[v] : 0;
  const SkinError wish = skin_error(asked, weight), rest = skin_error(left, weight);
  reach.asked_rms = root_mean_square(wish);
  reach.asked_p90 = wish.p90;
  reach.asked_max = wish.max;
  reach.left_rms = root_mean_square(rest);
  reach.left_p90 = rest.p90;
  reach.left_max = rest.max;
  constexpr double nothing_mm = 1e-9;
  reach.share_left = reach.asked_rms > nothing_mm  ? reach.left_rms / reach.asked_rms
                     : reach.left_rms > nothing_mm ? 1
                                                   : 0;
  place_remainder(left, weight, parts.fragment_below, reach);
  return reach;
}

} // namespace

Reachability reachability(const SkinTarget& target, const std::vector<Vec3>& reached,
                          const SkinParts& parts)
{
  const std::size_t n = reached.size();
  std::vector<double> asked(n), left(n), weight(n);
  Reachability result;
  result.unreachable_mm.assign(n, std::nan(""));
  for (std::size_t v = 0; v < n; ++v)
  {
    asked[v] = target.displacement[v].norm();
    left[v] = (target.displacement[v] - reached[v]).norm();
    weight[v] = parts.area[v] * target.weight[v];
    if (weight[v] > 0)
      result.unreachable_mm[v] = left[v];
  }
  result.whole = reach_of(asked, left, weight, parts);
  for (const FaceRegion region : all_face_regions())
  {
    std::vector<double> here = weight;
    for (std::size_t v = 0; v < n; ++v)
      if (parts.region[v] != region)
        here[v] = 0;
    RegionReach reach = reach_of(asked, left, here, parts);
    reach.region = region;
    if (reach.area_mm2 > 0)
      result.regions.push_back(reach);
  }
  return result;
}

} // namespace f2b
