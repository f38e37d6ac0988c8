#pragma once

#include "Case/case_session.hpp"

/// Which face is a plan to reach, and how far is another one from it?
namespace f2b
{

/// The target of a case, on its reference skin.
class PlanTarget
{
public:
  /// Throws Error if there is none, if it is of another reference skin, or if no part of it that
  /// counts lies on the meshed face.
  PlanTarget(const CaseSession& session, const LoadedFace& face);

  const SkinTarget& skin() const { return m_skin; }
  /// The same with a target for every vertex: of a scan, its place nearest to the displaced vertex.
  SkinTarget for_vertices(const std::vector<Vec3>& skin_displacement) const;
  /// Per reference-skin vertex, negative where the face lies behind the target [mm]: to the
  /// vertex's own target, or to the nearest place of a scan.
  std::vector<double> signed_distances(const std::vector<Vec3>& skin_displacement) const;

private:
  void require_overlap(const LoadedFace& face) const;

  SkinTarget m_skin;
  std::vector<Vec3> m_rest;    ///< reference skin [mm]
  std::vector<Vec3> m_normals; ///< of the target's vertices
};

/// Name of the scan that a case keeps.
inline constexpr const char* target_scan_name = "target_scan.vtp";

} // namespace f2b
