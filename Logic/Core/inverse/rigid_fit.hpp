#pragma once

#include "Core/inverse/face_model.hpp"

/// Which movement of the bone fragments brings the face nearest to its target?
namespace f2b
{

struct RigidFitOptions
{
  int max_iterations = 40;
  double translation_tolerance_mm = 1e-6; ///< converged when the next step would be below both
  double rotation_tolerance_rad = 1e-8;
  EquilibriumOptions equilibrium;
};

enum class RigidFitTermination
{
  Converged,
  NoFurtherDescent, ///< no damped step lowers the objective: the best reachable state
  MaxIterations,
  EquilibriumLost, ///< the tissue could not follow even a heavily damped first step
};

struct RigidFitIteration
{
  double objective = 0;      ///< 1/2 sum_v w_v a_v |u_v - d_v|^2 at its beginning [mm^4]
  double translation_mm = 0; ///< largest translation step
  double rotation_rad = 0;   ///< largest rotation step
};

struct RigidFitResult
{
  RigidFitTermination termination = RigidFitTermination::Converged;
  std::vector<RigidMotion> motions;    ///< one per fragment
  std::vector<Vec3> x;                 ///< control vectors in equilibrium at these motions [mm]
  std::vector<Vec3> skin_displacement; ///< of the reference skin [mm]
  std::vector<RigidFitIteration> iterations;
  EquilibriumSummary equilibrium; ///< all solves together
};

/// Levenberg-Marquardt on SE(3) per fragment: minimises the weighted squared distance of the
/// reference skin to its target, subject to the tissue's equilibrium with Gamma_n moved rigidly.
///
/// Sensitivities are exact: 6 back-solves a fragment with the tangent's factor at equilibrium.
/// Throws Error (Numerical) if the target does not determine a fragment's movement at all.
RigidFitResult fit_fragments(const FaceModel& face, const SkinTarget& target,
                             const RigidFitOptions& options, const Progress& progress);

} // namespace f2b
