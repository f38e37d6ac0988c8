#pragma once

#include "Core/inverse/face_model.hpp"
#include "Core/inverse/movement_space.hpp"

/// Which movement of the bone fragments brings the face nearest to its target?
namespace f2b
{

struct RigidFitOptions
{
  std::vector<FragmentRules> rules; ///< one per fragment; empty: all move freely
  int max_iterations = 40;
  double translation_tolerance_mm = 2e-6; ///< converged when the next step would be below both
  double rotation_tolerance_rad = 2e-8;
  /// Longest step of one iteration: a longer one would leave the range of its linearisation.
  double longest_step_mm = 25, longest_turn_rad = 0.44;
  /// Priors and bites with a tolerance are weighed against skin as if every patch of this area were
  /// one measurement of this standard deviation.
  double skin_sd_mm = 0.5, patch_area_mm2 = 150;
  double wish_weight() const { return skin_sd_mm * skin_sd_mm * patch_area_mm2; } ///< [mm^4]
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
  double objective = 0;      ///< at its beginning [mm^4], see fit_fragments
  double translation_mm = 0; ///< largest translation step
  double rotation_rad = 0;   ///< largest rotation step
};

struct RigidFitResult
{
  RigidFitTermination termination = RigidFitTermination::Converged;
  Eigen::VectorXd q;                   ///< coordinates in the options' movement space
  std::vector<RigidMotion> motions;    ///< one per fragment
  std::vector<Vec3> x;                 ///< control vectors in equilibrium at these motions [mm]
  std::vector<Vec3> skin_displacement; ///< of the reference skin [mm]
  /// Coordinates that a bound holds back, and those of fragments that are held.
  std::vector<Eigen::Index> at_bounds;
  std::vector<int> held_fragments; ///< of which the target says nothing: see unseen_fragments
  /// Shift [mm] and turn [rad] of the target that its registration seems to have left; zero unless
  /// the target says that they are in doubt.
  Eigen::Matrix<double, 6, 1> target_registration = Eigen::Matrix<double, 6, 1>::Zero();
  std::vector<RigidFitIteration> iterations;
  EquilibriumSummary equilibrium; ///< all solves together
};

/// The movements that the options allow for the fragments of a face. Throws as MovementSpace.
MovementSpace movement_space(const FaceModel& face, const RigidFitOptions& options);

/// Levenberg-Marquardt over the movements that the rules allow (6 coordinates on SE(3) per free
/// fragment): minimises 1/2 sum_v w_v a_v |r_v|^2 + 1/2 sd^2 A |wishes|^2, with r the way from the
/// target to the reference skin, subject to the tissue's equilibrium with Gamma_n moved rigidly.
///
/// Sensitivities are those of the converged equilibrium, one back-solve a coordinate with the
/// tangent's factor. The objective never rises. Equilibria on the way are only as exact as the next
/// step needs; the last one meets the options' tolerance.
/// Fragments that the target says nothing of (unseen_fragments) stay where they start.
/// \param start  a plan of the same face under the same rules, such as that of a target that differs
///               little: the fit begins from its equilibrium. Null: from rest
/// Throws Error if the target does not determine a fragment's movement at all.
RigidFitResult fit_fragments(const FaceModel& face, const SkinTarget& target,
                             const RigidFitOptions& options, const Progress& progress,
                             const RigidFitResult* start = nullptr);

} // namespace f2b
