#include "Case/plan_findings.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/geometry/bite.hpp"
#include "Core/mesh/contact.hpp"

#include <algorithm>
#include <cstdio>

namespace f2b
{
namespace
{

using nlohmann::json;

/// Wider than this on average, a gap is told about.
constexpr double wide_gap_mm = 3;

template <class... Values>
std::string formatted(const char* format, Values... values)
{
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

unsigned char label_of(std::size_t fragment)
{
  return static_cast<unsigned char>(BonePartition::first_fragment + fragment);
}

json bite_json(const Bite& b)
{
  return {{"overjet_mm", b.overjet_mm},
          {"overbite_mm", b.overbite_mm},
          {"lower_to_upper_midline_mm", b.dental_midline_mm},
          {"upper_midline_mm", b.upper_midline_mm},
          {"lower_midline_mm", b.lower_midline_mm}};
}

} // namespace

MovedBones::MovedBones(const CaseFolder& folder)
    : m_bone(read_scalar_grid(folder.require("bone_distance.nrrd", "segment"))),
      m_parts(read_label_grid(folder.require("bone_parts.nrrd", "cut"))),
      m_osteotomies(placed_osteotomies(folder))
{
  if (folder.has("landmarks.mrk.json"))
    m_landmarks = read_landmarks(folder.file("landmarks.mrk.json"));
}

std::vector<BoneMeeting> MovedBones::meetings(const std::vector<RigidMotion>& motions) const
{
  const CutBone cut{m_bone, m_parts, m_osteotomies};
  std::vector<BoneMeeting> list;
  for (std::size_t f = 0; f < motions.size(); ++f)
    for (std::size_t g = f + 1; g <= motions.size(); ++g)
    {
      // behind the last fragment comes the bone that stays
      const bool stays = g == motions.size();
      const MovedPart part{label_of(f), motions[f]};
      const MovedPart other = stays ? MovedPart{} : MovedPart{label_of(g), motions[g]};
      BoneMeeting meeting{m_osteotomies.at(f).fragment,
                          stays ? uncut_bone_name : m_osteotomies.at(g).fragment,
                          overlap_between(cut, part, other), gap_between(cut, part, other)};
      if (stays || meeting.overlap.volume_mm3 > 0 || meeting.gap.cut_mm2 > 0)
        list.push_back(std::move(meeting));
    }
  return list;
}

int MovedBones::fragment_under(const std::string& landmark) const
{
  const auto& teeth = tooth_landmarks();
  const bool is_tooth = std::count(teeth.begin(), teeth.end(), landmark) > 0;
  const Vec3 at = is_tooth ? bone_of_tooth(m_landmarks, landmark) : m_landmarks.at(landmark);
  const unsigned char label = nearest_bone(m_parts, at);
  return label - BonePartition::first_fragment;
}

Landmarks MovedBones::moved_landmarks(const std::vector<RigidMotion>& motions) const
{
  Landmarks moved = m_landmarks;
  for (auto& [name, position] : moved)
    if (const int f = fragment_under(name); f >= 0)
      position = motions.at(static_cast<std::size_t>(f)).apply(position);
  return moved;
}

json MovedBones::bite_at_rest() const
{
  const std::vector<std::string> missing = missing_for_bite(m_landmarks);
  if (!missing.empty())
    return {{"missing_landmarks", missing}};
  json rides_on;
  for (const std::string& tooth : tooth_landmarks())
  {
    const int f = fragment_under(tooth);
    rides_on[tooth] =
        f < 0 ? uncut_bone_name : m_osteotomies.at(static_cast<std::size_t>(f)).fragment;
  }
  return {
      {"before", bite_json(bite(m_landmarks, mid_sagittal_plane(m_landmarks)))},
      {"landmarks_ride_on", rides_on},
      {"occlusal_plane", "through U1, U6_R and U6_L, moves with them"},
      {"mid_sagittal_plane",
       "through N, at right angles to the mean direction of the pairs Or and Zy, at rest"},
      {"signs", "overjet: U1 in front; overbite: L1 above U1; midlines: to the patient's right"}};
}

json MovedBones::bite_after(const std::vector<RigidMotion>& motions) const
{
  if (!missing_for_bite(m_landmarks).empty())
    return nullptr;
  Landmarks moved = m_landmarks;
  for (const std::string& tooth : tooth_landmarks())
    if (const int f = fragment_under(tooth); f >= 0)
      moved[tooth] = motions.at(static_cast<std::size_t>(f)).apply(moved[tooth]);
  return bite_json(bite(moved, mid_sagittal_plane(m_landmarks)));
}

json to_json(const std::vector<BoneMeeting>& meetings)
{
  json list = json::array();
  for (const BoneMeeting& m : meetings)
    list.push_back({{"between", {m.part, m.other}},
                    {"overlap",
                     {{"volume_mm3", m.overlap.volume_mm3},
                      {"depth_mm", m.overlap.depth_mm},
                      {"deepest_ras", to_json(m.overlap.deepest)}}},
                    {"gap",
                     {{"cut_mm2", m.gap.cut_mm2},
                      {"facing_share", m.gap.facing_share},
                      {"mean_mm", m.gap.mean_mm},
                      {"max_mm", m.gap.max_mm},
                      {"volume_mm3", m.gap.volume_mm3},
                      {"widest_ras", to_json(m.gap.widest)}}}});
  return list;
}

std::vector<std::string> warnings_of(const std::vector<BoneMeeting>& meetings, double voxel_mm)
{
  std::vector<std::string> warnings;
  for (const BoneMeeting& m : meetings)
  {
    const std::string other =
        m.other == uncut_bone_name ? "bone that stays" : "the moved '" + m.other + "'";
    const BoneOverlap& o = m.overlap;
    if (o.depth_mm >= voxel_mm)
      warnings.push_back(formatted(
          "'%s' runs into %s, %.1f mm deep and %.0f mm3 in all, deepest at R %.0f, A %.0f, S %.0f",
          m.part.c_str(), other.c_str(), o.depth_mm, o.volume_mm3, o.deepest.x(), o.deepest.y(),
          o.deepest.z()));
    const BoneGap& g = m.gap;
    if (g.mean_mm > wide_gap_mm)
      warnings.push_back(formatted(
          "the cut between '%s' and %s opens by %.1f mm on average, %.1f mm at most (R %.0f, A "
          "%.0f, S %.0f), %.1f cm3 beyond the kerf",
          m.part.c_str(), other.c_str(), g.mean_mm, g.max_mm, g.widest.x(), g.widest.y(),
          g.widest.z(), g.volume_mm3 / 1000));
  }
  return warnings;
}

namespace
{

json reach_json(const RegionReach& r)
{
  return {{"area_mm2", r.area_mm2},
          {"asked_mm", {{"rms", r.asked_rms}, {"p90", r.asked_p90}, {"max", r.asked_max}}},
          {"left_mm", {{"rms", r.left_rms}, {"p90", r.left_p90}, {"max", r.left_max}}},
          {"share_left", r.share_left},
          {"left_over_fragments", r.left_over_fragments}};
}

} // namespace

json to_json(const Reachability& reachability, const std::vector<std::string>& sentences)
{
  const ReachLimits limits;
  json regions = json::object();
  for (const RegionReach& region : reachability.regions)
    regions[key_of(region.region)] = reach_json(region);
  return {{"method", "rigid-fit"},
          {"whole", reach_json(reachability.whole)},
          {"regions", regions},
          {"told_from",
           {{"left_p90_mm", limits.left_mm},
            {"out_of_reach_share", limits.out_of_reach},
            {"area_mm2", limits.least_area_mm2}}},
          {"sentences", sentences}};
}

std::vector<std::pair<std::string, std::string>> bite_rows(const json& plan)
{
  const json& bite = plan.at("bite");
  if (!bite.contains("before"))
    return {};
  std::vector<std::pair<std::string, std::string>> rows;
  const std::pair<const char*, const char*> figures[] = {
      {"overjet_mm", "Overjet"},
      {"overbite_mm", "Overbite"},
      {"lower_to_upper_midline_mm", "Lower to upper midline, to the right"},
      {"upper_midline_mm", "Upper midline, to the right of the face's"},
      {"lower_midline_mm", "Lower midline, to the right of the face's"}};
  for (const auto& [key, name] : figures)
    rows.emplace_back(name, formatted("%.1f mm before, %.1f mm after", // + 0.0: no minus zero
                                      bite.at("before").at(key).get<double>() + 0.0,
                                      bite.at("rigid-fit").at(key).get<double>() + 0.0));
  std::string carriers;
  for (const auto& [tooth, part] : bite.at("landmarks_ride_on").items())
    carriers += (carriers.empty() ? "" : ", ") + tooth + " on " + part.get<std::string>();
  rows.emplace_back("Landmarks ride", carriers);
  return rows;
}

std::vector<std::pair<std::string, std::string>> cut_rows(const json& plan)
{
  std::vector<std::pair<std::string, std::string>> rows;
  for (const json& m : plan.at("methods").at("rigid-fit").at("bone_contacts"))
  {
    const json& gap = m.at("gap");
    const json& overlap = m.at("overlap");
    std::string text = formatted(
        "gap %.1f mm on average, %.1f mm at most, %.1f cm3; %.0f %% of the cut still faces it",
        gap.at("mean_mm").get<double>(), gap.at("max_mm").get<double>(),
        gap.at("volume_mm3").get<double>() / 1000, 100 * gap.at("facing_share").get<double>());
    text += overlap.at("volume_mm3") > 0 ? formatted("; overlap %.1f mm deep, %.0f mm3",
                                                     overlap.at("depth_mm").get<double>(),
                                                     overlap.at("volume_mm3").get<double>())
                                         : "; no overlap";
    rows.emplace_back(m.at("between").at(0).get<std::string>() + " - " +
                          m.at("between").at(1).get<std::string>(),
                      text);
  }
  return rows;
}

} // namespace f2b
