#pragma once

#include "Bridge/forward_deck.hpp"

/// How is a forward problem told to FEBio?
namespace f2b
{

/// An FEBio 4.0 input file (.feb, XML): tet4 and penta6 as `elastic-solid`, uncoupled materials,
/// the boundary parts as node sets, the movement as nodal data ramped by a load curve.
///
/// FEBio's uncoupled materials have all three of our volumetric laws as their `pressure_model`:
/// `default` is K/2 (ln J)^2 (log), `NIKE3D` K/4 (J^2 - 1 - 2 ln J) (barrier), `Abaqus`
/// K/2 (J - 1)^2 (quadratic). Its `Yeoh` (FEBio 4.4 and later) takes the stress from
/// dW/dI1 = sum_i c_i (I1 - 3)^(i - 1), without the factor i, so c2 and c3 are written two and
/// three times as large; read in the sources of FEBio 4.11, not run. Throws Error where a tissue
/// has a law that FEBio has not.
std::string febio_deck(const ForwardProblem& problem, const DeckOptions& options);

} // namespace f2b
