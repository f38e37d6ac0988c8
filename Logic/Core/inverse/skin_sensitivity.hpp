#pragma once

#include "Core/inverse/face_model.hpp"

/// How does the skin follow small movements of the bone fragments?
namespace f2b
{

/// First-order changes of the reference skin, six a fragment in the mesh's order: turns about R, A
/// and S through the fragment's moved reference point [mm/rad], then shifts along them [mm/mm].
///
/// \param solver   of a model of `face` with bone and fragments held
/// \param x        an equilibrium [mm]
/// \param motions  of the fragments there
std::vector<std::vector<Vec3>> skin_sensitivity(const FaceModel& face, EquilibriumSolver& solver,
                                                const std::vector<Vec3>& x,
                                                const std::vector<RigidMotion>& motions);

} // namespace f2b
