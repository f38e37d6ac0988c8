#include "Core/inverse/reachability_words.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace f2b
{
namespace
{

std::string millimetres(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.1f mm", value);
  return text;
}

/// "a, b and c".
std::string listed(const std::vector<std::string>& items)
{
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

/// Regions about which the same is to be said.
struct Group
{
  ReachVerdict verdict = ReachVerdict::Reached;
  std::string remedy; ///< the end of the sentence, after a semicolon
  bool operator<(const Group& other) const
  {
    return verdict != other.verdict ? verdict > other.verdict : remedy < other.remedy;
  }
};

bool over_a_fragment(const RegionReach& reach)
{
  return reach.left_over_fragments > 0.5;
}

std::string cut_text(const CutForRegion& cut)
{
  return "a cut of " + cut.bone + (cut.template_name.empty() ? "" : " (" + cut.template_name + ")");
}

std::string remedy_for(const RegionReach& reach, const PlannedCuts& planned)
{
  if (over_a_fragment(reach))
    return "that lies over the moved fragment '" +
           planned.fragments.at(static_cast<std::size_t>(reach.fragment)) +
           "', and no rigid movement of it gives the rest (soft tissue)";
  const CutForRegion cut = cut_for(reach.region);
  if (cut.bone.empty())
    return "no cut of the facial bones moves it";
  const auto& templates = planned.templates;
  if (std::find(templates.begin(), templates.end(), cut.template_name) != templates.end())
    return "the planned " + cut.template_name + " does not take the bone below it along";
  return "this needs " + cut_text(cut);
}

std::string sentence(const Group& group, const std::vector<const RegionReach*>& members,
                     bool regions_known)
{
  const bool one = members.size() == 1;
  std::vector<std::string> names, left;
  for (const RegionReach* reach : members)
  {
    const std::string name = regions_known ? name_of(reach->region) : "face";
    names.push_back("the " + name +
                    (group.verdict == ReachVerdict::TakenAlong
                         ? ""
                         : " target (" + millimetres(reach->asked_p90) + ")"));
    left.push_back(millimetres(reach->left_p90));
  }
  std::string text = listed(names);
  switch (group.verdict)
  {
  case ReachVerdict::OutOfReach:
    text += (one ? " is" : " are") + std::string(" out of reach of these cuts: ");
    break;
  case ReachVerdict::ReachedInPart:
    text += (one ? " is" : " are") + std::string(" reached in part by these cuts: ");
    break;
  case ReachVerdict::TakenAlong:
    text += (one ? " hardly moves" : " hardly move") +
            std::string(" in the target, but these cuts take ") + (one ? "it" : "them") +
            " along: ";
    break;
  case ReachVerdict::Reached:
    break;
  }
  text += listed(left) + " are left there" + (group.remedy.empty() ? "" : "; " + group.remedy);
  text[0] = 'T';
  return text + ".";
}

/// A template's name, if this program has it.
std::string if_known(const std::string& template_name)
{
  const std::vector<std::string> known = osteotomy_template_names();
  return std::find(known.begin(), known.end(), template_name) != known.end() ? template_name : "";
}

std::string all_is_reached(const Reachability& reachability)
{
  return "These cuts reach the whole target: 90 % of its skin lies within " +
         millimetres(reachability.whole.left_p90) + " of it.";
}

} // namespace

std::string stays_unseen(const std::string& fragment)
{
  return "'" + fragment +
         "' stays: hardly any of the skin that it moves is under the target; sculpt the face there, "
         "or say by its rules how it is to move";
}

ReachVerdict verdict_on(const RegionReach& reach, const ReachLimits& limits)
{
  if (reach.area_mm2 < limits.least_area_mm2 || reach.left_p90 < limits.left_mm)
    return ReachVerdict::Reached;
  if (reach.asked_p90 < 0.5 * reach.left_p90)
    return ReachVerdict::TakenAlong;
  return reach.left_p90 >= limits.out_of_reach * reach.asked_p90 ? ReachVerdict::OutOfReach
                                                                 : ReachVerdict::ReachedInPart;
}

CutForRegion cut_for(FaceRegion region)
{
  switch (region)
  {
  case FaceRegion::Forehead:
    return {"the frontal bone", ""};
  case FaceRegion::OrbitRight:
  case FaceRegion::OrbitLeft:
  case FaceRegion::Nose:
  case FaceRegion::CheekRight:
  case FaceRegion::CheekLeft:
    return {"the mid-face", "le-fort-3"};
  case FaceRegion::UpperLip:
    return {"the maxilla", "le-fort-1"};
  case FaceRegion::LowerLip:
  case FaceRegion::JawRight:
  case FaceRegion::JawLeft:
    return {"the mandible", if_known("bsso")};
  case FaceRegion::Chin:
    return {"the chin", "genioplasty"};
  case FaceRegion::Neck:
  case FaceRegion::Other:
    break;
  }
  return {};
}

std::vector<std::string> reach_sentences(const Reachability& reachability,
                                         const PlannedCuts& planned, const ReachLimits& limits)
{
  const auto& regions = reachability.regions;
  // without landmarks all skin is Other: then nothing can be said about where
  const bool regions_known = regions.size() != 1 || regions[0].region != FaceRegion::Other;
  std::map<Group, std::vector<const RegionReach*>> groups;
  for (const RegionReach& reach : regions)
  {
    const ReachVerdict verdict = verdict_on(reach, limits);
    if (verdict == ReachVerdict::Reached)
      continue;
    const std::string remedy = verdict == ReachVerdict::TakenAlong ? ""
                               : !regions_known && !over_a_fragment(reach)
                                   ? "without landmarks no cut is named"
                                   : remedy_for(reach, planned);
    groups[{verdict, remedy}].push_back(&reach);
  }
  std::vector<std::string> sentences;
  for (const auto& [group, members] : groups)
    sentences.push_back(sentence(group, members, regions_known));
  if (sentences.empty())
    sentences.push_back(all_is_reached(reachability));
  return sentences;
}

} // namespace f2b
