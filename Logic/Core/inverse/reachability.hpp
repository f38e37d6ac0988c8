#pragma once

#include "Core/geometry/face_regions.hpp"
#include "Core/inverse/face_model.hpp"

/// Which part of the target does no movement of these fragments give, and where is it?
///
/// What the best rigid fit leaves is that part: rigid-fit minimises the weighted squared distance
/// over all movements of the fragments (design.md 4), so at its converged optimum any other
/// movement leaves more in all. Within one region another movement may leave less, at the cost of
/// the others.
namespace f2b
{

/// What is known of each vertex of the reference skin.
struct SkinParts
{
  std::vector<double> area; ///< 0 where the vertex does not count [mm^2]
  std::vector<FaceRegion> region;
  std::vector<int> fragment_below; ///< -1: bone that stays; as fragments_below() gives
};

/// Figures of one region, weighted by area times the target's weight [mm].
struct RegionReach
{
  FaceRegion region = FaceRegion::Other;
  double area_mm2 = 0;                                ///< of its skin that has a target
  double asked_rms = 0, asked_p90 = 0, asked_max = 0; ///< length of the target displacement
  double left_rms = 0, left_p90 = 0, left_max = 0;    ///< length of target minus reached
  double share_left = 0; ///< left_rms / asked_rms; 1 if nothing was asked but something is left
  double left_over_fragments =
      0;             ///< share of the squared remainder whose skin lies over a fragment
  int fragment = -1; ///< the one that most of that remainder lies over; -1: none
};

struct Reachability
{
  std::vector<double> unreachable_mm; ///< |target - reached| per vertex; NaN without target or area
  RegionReach whole;                  ///< its region says nothing
  std::vector<RegionReach> regions;   ///< those that have a target, in the order of the values
};

/// \param reached  skin displacement of the best fit, per reference-skin vertex [mm]
Reachability reachability(const SkinTarget& target, const std::vector<Vec3>& reached,
                          const SkinParts& parts);

} // namespace f2b
