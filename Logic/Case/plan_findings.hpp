#pragma once

#include "Case/case_session.hpp"
#include "Core/geometry/bone_gap.hpp"
#include "Core/inverse/reachability_words.hpp"

/// What must the surgeon know with a plan, beyond the movements and the face?
namespace f2b
{

/// Two parts of the bone after a movement that share a cut, or of which one runs into the other.
struct BoneMeeting
{
  std::string part, other; ///< a fragment, and a fragment or `uncut_bone_name`
  BoneOverlap overlap;
  BoneGap gap;
};
inline constexpr const char* uncut_bone_name = "uncut bone";

/// The cut bone of a case with its landmarks, ready to be moved.
class MovedBones
{
public:
  /// Throws Error where the case has not been cut.
  explicit MovedBones(const CaseFolder& folder);

  double voxel_mm() const { return m_bone.spacing; }
  /// \param motions  one per fragment
  std::vector<BoneMeeting> meetings(const std::vector<RigidMotion>& motions) const;

  /// `bite` of plan.json but for the methods: what landmarks are missing; or the figures before,
  /// what each tooth landmark rides on, and the planes.
  nlohmann::json bite_at_rest() const;
  /// The figures after a movement; null where landmarks are missing.
  nlohmann::json bite_after(const std::vector<RigidMotion>& motions) const;

  const Landmarks& landmarks() const { return m_landmarks; } ///< empty where the case has none
  /// Every landmark where a movement takes the bone that carries it.
  Landmarks moved_landmarks(const std::vector<RigidMotion>& motions) const;

private:
  int fragment_under(const std::string& landmark) const;

  ScalarGrid m_bone;
  LabelGrid m_parts;
  std::vector<Osteotomy> m_osteotomies;
  Landmarks m_landmarks;
};

nlohmann::json to_json(const std::vector<BoneMeeting>& meetings);
/// Sentences on overlaps deeper than a voxel (touching surfaces raise no alarm) and on gaps wider
/// than 3 mm on average, from which on surgeons consider a graft.
std::vector<std::string> warnings_of(const std::vector<BoneMeeting>& meetings, double voxel_mm);

/// `reachability` of plan.json.
nlohmann::json to_json(const Reachability& reachability, const std::vector<std::string>& sentences);

/// Rows such as "Overjet", "8.3 mm before, 2.1 mm after (rigid-fit)"; empty without a bite.
std::vector<std::pair<std::string, std::string>> bite_rows(const nlohmann::json& plan);
/// Rows such as "mid-face - uncut bone", "gap 3.1 mm (up to 6.0 mm, 2.1 cm3)", of rigid-fit.
std::vector<std::pair<std::string, std::string>> cut_rows(const nlohmann::json& plan);

} // namespace f2b
