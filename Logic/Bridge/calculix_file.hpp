#pragma once

#include "Bridge/forward_deck.hpp"

/// How is a forward problem told to CalculiX (ccx), so that anyone can check us?
namespace f2b
{

/// An input deck (.inp): C3D4 and C3D6, *HYPERELASTIC, the boundary parts as node sets, the held
/// nodes fixed, the fragments' nodes moved in equal increments, all displacements printed.
///
/// ccx knows one volumetric law for its rubbers, sum_i 1/D_i (J - 1)^(2 i), so D_1 = 2 / K is our
/// `quadratic`; it replaces a D_i that is absent or zero by its own guess, so the higher ones are
/// written so large that their terms vanish. Throws Error where a tissue has another law.
/// Reference: CalculiX CrunchiX User's Manual 2.20, *HYPERELASTIC; hyperelastics.f of its source.
std::string calculix_deck(const ForwardProblem& problem, const DeckOptions& options);

} // namespace f2b
