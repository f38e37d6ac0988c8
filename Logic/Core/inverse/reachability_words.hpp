#pragma once

#include "Core/inverse/reachability.hpp"

#include <string>
#include <vector>

/// How does a surgeon read what these cuts cannot give? Plain sentences that name the region.
namespace f2b
{

/// From when on a remainder is worth a sentence.
struct ReachLimits
{
  /// 90th percentile of what is left [mm]. 2 mm is the error up to which studies of predicted faces
  /// call a prediction accurate (as R. J. Peterman et al., Prog. Orthod. 17 (2016) 19).
  double left_mm = 2;
  /// "Out of reach" when at least this share of the asked length is left, else "reached in part".
  double out_of_reach = 0.5;
  /// A region with less skin under target than this is not told about [mm^2]: at the rim of a
  /// target's mask a few vertices say nothing.
  double least_area_mm2 = 100;
};

enum class ReachVerdict
{
  Reached,
  TakenAlong, ///< the target asks for less than half of what is left: it is to stay, but moves
  ReachedInPart,
  OutOfReach,
};
ReachVerdict verdict_on(const RegionReach& reach, const ReachLimits& limits = {});

/// That a fragment is not moved, as the target says nothing of it (unseen_fragments).
std::string stays_unseen(const std::string& fragment);

/// The operation that moves a region.
struct CutForRegion
{
  std::string bone;          ///< "the chin"; empty: no cut of the facial bones moves it
  std::string template_name; ///< of osteotomy_template_names(), empty if none does it yet
};
CutForRegion cut_for(FaceRegion region);

/// What is planned, in the words of the case.
struct PlannedCuts
{
  std::vector<std::string> fragments; ///< names
  std::vector<std::string> templates; ///< that they were made from; cuts by hand have none
};

/// At least one sentence; regions that need the same are told about in one.
///
/// "The chin target (6.1 mm) is out of reach of these cuts: 5.4 mm are left there; it needs a cut
/// of the chin (genioplasty)." Lengths are 90th percentiles of the region's skin under target.
/// Where most of the remainder lies over a fragment, it says that no rigid movement gives the rest
/// (soft tissue).
std::vector<std::string> reach_sentences(const Reachability& reachability,
                                         const PlannedCuts& planned,
                                         const ReachLimits& limits = {});

} // namespace f2b
