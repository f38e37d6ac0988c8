#pragma once

#include "Core/inverse/contact_registration.hpp"
#include "Core/inverse/face_model.hpp"

/// What does the paper's own inverse method find (section 2.3; section 3.1, steps 4 to 6)?
namespace f2b
{

struct VirtualForceOptions
{
  /// K_e of eq. 8 [N/mm^3]; without it, as stiff as `residual_mm` needs.
  std::optional<double> stiffness_n_per_mm3;
  double residual_mm = 0.5;  ///< mean distance of the loaded skin to its target that K_e is for
  double rest_length_mm = 0; ///< L0 of eq. 8
  VirtualLoad load = VirtualLoad::Following;
  std::vector<ContactLandmark> landmarks; ///< for the registration of Gamma_n; none: all of it
  int max_solves = 20;                    ///< equilibria that the choice of K_e may try
  EquilibriumOptions equilibrium;
};

/// How K_e came about.
enum class StiffnessChoice
{
  Given,
  Met,        ///< chosen; the skin comes as near to its target as was asked for
  NotMet,     ///< the skin cannot be brought as near; of what was tried, K_e brings it nearest
  NoneNeeded, ///< the skin at rest is near enough already: no force
};

struct VirtualForceResult
{
  std::vector<RigidMotion> motions;                ///< rest to deformed Gamma_n, registered rigidly
  std::vector<FragmentRegistration> registrations; ///< in full, one per fragment
  std::vector<Vec3> x; ///< control vectors under the virtual force, the mesh nodes first [mm]
  std::vector<Vec3> skin_displacement; ///< what the solve itself leaves the skin at [mm]
  double stiffness_n_per_mm3 = 0;      ///< K_e of that state
  double residual_mm = 0; ///< mean distance of the loaded skin to its target, by area and weight
  double residual_at_rest_mm = 0; ///< the same without force
  StiffnessChoice choice = StiffnessChoice::Given;
  int solves = 0;                 ///< equilibria that were looked for
  EquilibriumSummary equilibrium; ///< all solves together

  /// What a reader of the plan must know, one sentence each.
  std::vector<std::string> warnings(const VirtualForceOptions& options) const;
};

/// Loads the skin with the virtual external force (eq. 8-9) where the target has weight, with
/// Gamma_c fixed and Gamma_n free of traction, then registers each fragment's rest and deformed
/// contact surface.
///
/// Skin outside the target's mask is free. Biased by construction: tissue shears instead of
/// dragging the bone. Throws Error where no skin is loaded, for settings out of range, where the
/// contact nodes or landmarks do not determine a fragment's movement (contact_registration.hpp),
/// and (Numerical) if no share of the way to the target can be gone.
VirtualForceResult drag_skin(const FaceModel& face, const SkinTarget& target,
                             const VirtualForceOptions& options, const Progress& progress);

} // namespace f2b
