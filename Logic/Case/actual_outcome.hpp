#pragma once

#include "Case/verbs.hpp"

/// What did the operation really do, and how far is a face from it?
namespace f2b
{

/// The outcome that predictions and plans are judged by.
struct ActualOutcome
{
  std::vector<RigidMotion> motions; ///< of the fragments
  SkinTarget skin;                  ///< the face as it was measured; weight 0 where it is not known
  std::vector<double> area;         ///< per reference-skin vertex, 0 where nothing is known [mm^2]
  /// Signed distance per vertex of a displaced reference skin to the measured face, negative behind
  /// it [mm].
  std::function<std::vector<double>(const std::vector<Vec3>& skin_displacement)> distances;
  /// The same to the face without the noise of measuring it; empty where nobody knows it.
  std::function<std::vector<double>(const std::vector<Vec3>& skin_displacement)> exact_distances;
  nlohmann::json document; ///< what it is, and how it differs from what the plan believes
};

/// Of a virtual patient who is not as the plan believes (virtual_truth.hpp), measured with noise.
/// Throws Error (Numerical) where the virtual patient's tissue cannot follow the movements.
ActualOutcome virtual_outcome(const CaseSession& session, const LoadedFace& face,
                              const std::vector<RigidMotion>& motions,
                              const EvaluateOptions& options);

/// Of a post-operative CT: distances are to the nearest point of its skin, as there is no
/// correspondence. Throws as postoperative_findings.
ActualOutcome postoperative_outcome(const CaseSession& session, const LoadedFace& face,
                                    const EvaluateOptions& options);

/// Signed distances of corresponding vertices: of the reference skin displaced by u to the same
/// displaced by the target's displacement [mm].
std::vector<double> distances_to_target(const MeshedFace& face, const std::vector<Vec3>& u,
                                        const std::vector<Vec3>& target);

} // namespace f2b
