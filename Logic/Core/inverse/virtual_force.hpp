#pragma once

#include "Core/inverse/face_model.hpp"

/// What does the paper's own inverse method find (section 2.3; section 3.1, steps 4 to 6)?
namespace f2b
{

struct VirtualForceOptions
{
  double stiffness_n_per_mm3 = 0.02; ///< K_e of eq. 8
  EquilibriumOptions equilibrium;
};

struct VirtualForceResult
{
  std::vector<RigidMotion> motions; ///< rest to deformed Gamma_n, registered rigidly
  std::vector<Vec3> x; ///< control vectors under the virtual force, the mesh nodes first [mm]
  std::vector<Vec3> skin_displacement; ///< what the solve itself leaves the skin at [mm]
  EquilibriumSummary equilibrium;
};

/// Loads the skin with the virtual external force (eq. 8-9, L0 = 0, following), with Gamma_c fixed
/// and Gamma_n free of traction, then registers each fragment's rest and deformed contact nodes.
///
/// Skin outside the target's mask is free. Biased by construction: tissue shears instead of
/// dragging the bone. Throws Error (Numerical) where a fragment has under three contact nodes.
VirtualForceResult drag_skin(const FaceModel& face, const SkinTarget& target,
                             const VirtualForceOptions& options, const Progress& progress);

} // namespace f2b
