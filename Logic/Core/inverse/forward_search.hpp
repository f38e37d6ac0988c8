#pragma once

#include "Core/inverse/rigid_fit.hpp"

/// How near can any movement bring the face, by a search that knows nothing of rigid-fit?
namespace f2b
{

struct ForwardSearchOptions
{
  EquilibriumOptions equilibrium;
  double difference_mm = 0.05; ///< a coordinate's shift for central differences
  double lever_mm = 50;        ///< an angle of 1 counts as so many mm
  double tolerance = 1e-4;     ///< relative: of the sum of squares, and of the movement
  int max_predictions = 400;   ///< forward problems solved
};

struct ForwardSearchResult
{
  Eigen::VectorXd q; ///< coordinates of the free movements
  std::vector<RigidMotion> motions;
  double rms_mm = 0; ///< of the distance to the target, by area and weight
  int predictions = 0;
  bool converged = false;
};

/// Minimises the same weighted distance as fit_fragments from the face at rest, but with nothing
/// of its machinery: every value is a full forward solve, every derivative a central difference of
/// two, and the minimiser is MINPACK's Levenberg-Marquardt (J. J. More, Lecture Notes in
/// Mathematics 630 (1978) 105) as Eigen has it. All fragments move freely.
///
/// Slow; it is the yardstick that shows what rigid-fit leaves. Targets without correspondence
/// (SkinTarget::nearest) are not for it. Throws Error (Numerical) if the tissue cannot follow.
ForwardSearchResult search_by_predictions(const FaceModel& face, const SkinTarget& target,
                                          const ForwardSearchOptions& options,
                                          const Progress& progress);

/// Root of the mean squared distance of a face from its target, by area and weight [mm].
double weighted_rms_mm(const FaceModel& face, const SkinTarget& target,
                       const std::vector<Vec3>& skin_displacement);

} // namespace f2b
