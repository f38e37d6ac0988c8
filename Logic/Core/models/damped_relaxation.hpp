#pragma once

#include "Core/models/mass_tensors.hpp"
#include "Core/progress.hpp"

/// Where do the vertices of a mass-tensor model come to rest?
namespace f2b
{

struct RelaxationOptions
{
  double tolerance = 1e-5; ///< at rest when |residual| <= tolerance |reactions|, see below
  int max_steps = 100000;
};

/// What a relaxation did.
struct RelaxationSummary
{
  bool converged = false;
  int steps = 0;
  double residual = 0;           ///< reached, relative to the reactions
  double largest_eigenvalue = 0; ///< of M^-1 K, by power iteration [1/s^2]
  double time_step = 0;          ///< [s]
};

/// Lets free vertices move from where they are until the forces on them vanish: M u'' = -f(u) -
/// c M u', integrated explicitly (central differences, velocities at half steps).
///
/// Only the state at rest counts, so mass and damping are chosen for speed, and are no property of
/// the tissue. Mass: lumped, m_i = trace(K_ii) / 3 s^2, which gives stiff small elements and soft
/// large ones about the same largest frequency. Time step: 0.95 of the largest stable one,
/// 2 / sqrt(largest eigenvalue of M^-1 K); that eigenvalue is estimated by power iteration, which
/// comes from below, and raised by a tenth. Damping: critical for the lowest frequency that is
/// still moving, c = 2 omega with omega^2 = du.K du / du.M du of the last step's du, anew in every
/// step. Rest: the 2-norm of the forces on the free vertices falls under `tolerance` times that of
/// the forces that hold the others where they are. Reference: P. Underwood, "Dynamic relaxation",
/// in Computational Methods for Transient Analysis, North-Holland 1983, chapter 5.
///
/// Deterministic: sums do not depend on the number of threads.
/// \param u     displacements, one per vertex; those of held vertices are given and stay [mm]
/// \param held  one flag per vertex
RelaxationSummary relax(const MassTensors& tensors, std::vector<Vec3>& u,
                        const std::vector<char>& held, const RelaxationOptions& options,
                        const Progress& progress);

} // namespace f2b
