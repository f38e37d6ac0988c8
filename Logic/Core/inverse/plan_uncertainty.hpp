#pragma once

#include "Core/inverse/rigid_fit.hpp"

/// How sure is each coordinate of a plan?
namespace f2b
{

/// What a plan does not know, as independent causes: each the root mean square of its distance from
/// what the plan takes it to be.
struct UncertaintySources
{
  double skin_sd_mm = 0.5;         ///< of each component of the target's noise
  double skin_correlation_mm = 5;  ///< c(r) = exp(-r^2 / (2 l^2)); 0: white
  double registration_sd_mm = 0.3; ///< of each component of a shift of the whole target
  /// Of the logarithm of each tissue's stiffness: 0.5 to 2 times as stiff, all factors alike.
  double stiffness_log_sd = 0.4;
  /// Of every tissue's at once: between 0.45 and the 0.49 that the laws have.
  double poisson_ratio_sd = 0.023;
  double skin_thickness_sd_mm = 0.29; ///< 1 to 2 mm
};

/// Standard deviations of one coordinate of the plan [rad or mm], by cause, and their sum.
struct CoordinateUncertainty
{
  double noise = 0, registration = 0;
  std::array<double, tissue_count> stiffness{}; ///< by Tissue
  double poisson_ratio = 0, skin_thickness = 0;

  double sd() const;
  /// Half of the interval that holds 90 % of what is likely.
  double half_90() const { return 1.6449 * sd(); }
};

/// Of every coordinate of `space`, by first-order propagation through the fit at its solution.
///
/// The fit answers a change du of the predicted skin, or -du of the target, by
/// dq = -H^-1 C^T W du. The skin's change with a parameter of the tissue is that of the equilibrium,
/// K dx = -df, with df the force that the changed tissue puts on the unknowns in the same state.
/// Coordinates at a bound have no spread.
/// \param positions  of the reference skin's vertices at rest [mm]: what correlates the noise
/// Throws Error (Numerical) if the target leaves a combination of coordinates free.
std::vector<CoordinateUncertainty> plan_uncertainty(const FaceModel& face, const SkinTarget& target,
                                                    const RigidFitOptions& options,
                                                    const RigidFitResult& plan,
                                                    const std::vector<Vec3>& positions,
                                                    const UncertaintySources& sources);

} // namespace f2b
