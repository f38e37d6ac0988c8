#pragma once

#include "Case/case_session.hpp"
#include "Core/inverse/live_operator.hpp"
#include "Core/inverse/rigid_fit.hpp"

#include <memory>

/// How do bones and face follow a target that is still being made?
namespace f2b
{

/// The face that one set of movements gives, beside the one that is asked for.
struct FollowedPlan
{
  std::vector<RigidMotion> motions;    ///< one per fragment, in the mesh's order
  std::vector<Vec3> skin_displacement; ///< of the reference skin [mm]
  std::vector<double> unreached_mm;    ///< what is left of the target; NaN where nothing is asked
  double doubt_mm = 0;                 ///< of a preview: its own error (LiveOperator); 0 if solved
  bool solved = false;                 ///< by the full equilibrium, not to first order
  std::vector<std::string> notes;      ///< sentences on fragments that were not moved
};

/// A meshed case in memory, linearised about rest: previews in milliseconds, the full fit on demand.
/// Only the constructor reads the case's folder. Calls that are const may come from several threads
/// at once.
class LivePlan
{
public:
  /// Throws Error where the case has not been meshed.
  explicit LivePlan(const CaseSession& session);
  /// Linearises: one factorisation and a little more. To be called once, before `preview`.
  void prepare(const Progress& progress);

  const std::vector<std::string>& fragments() const { return m_face.mesh.fragments; }
  const std::vector<Vec3>& reference_points() const { return m_face.reference_points; }
  /// 1 where a vertex of the reference skin is on the mesh, else 0.
  std::vector<char> known_skin() const;

  /// The best movements to first order. Not const: remembers what of the face counts.
  /// \param displacement  of the target, one per reference-skin vertex [mm]
  /// Throws Error where the target says too little to move the fragments by.
  FollowedPlan preview(const std::vector<Vec3>& displacement);
  /// The best movements by the full fit; `progress` may throw to cancel.
  FollowedPlan solve(const std::vector<Vec3>& displacement, const Progress& progress) const;
  /// The face of stated movements by the full equilibrium.
  FollowedPlan predict(const std::vector<RigidMotion>& motions,
                       const std::vector<Vec3>& displacement, const Progress& progress) const;

private:
  std::vector<std::string> notes_on(const std::vector<int>& held_fragments) const;
  std::vector<double> weights(const std::vector<Vec3>& displacement) const;
  std::vector<double> unreached(const std::vector<Vec3>& wanted,
                                const std::vector<Vec3>& got) const;

  LoadedFace m_face;
  FaceModel m_model;
  double m_mask_mm;
  RigidFitOptions m_options;
  std::unique_ptr<LiveOperator> m_operator;
};

} // namespace f2b
