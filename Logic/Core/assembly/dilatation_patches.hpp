#pragma once

#include "Core/mesh/boundary_facets.hpp"

/// Which tetrahedra share one change of volume?
namespace f2b
{

/// Face-connected sets of tetrahedra that cover all of them once.
struct DilatationPatches
{
  std::vector<int> tets;  ///< patch by patch
  std::vector<int> start; ///< patch p is tets[start[p]] ... tets[start[p + 1] - 1]

  int count() const { return static_cast<int>(start.size()) - 1; }
  int size(int patch) const
  {
    const auto p = static_cast<std::size_t>(patch);
    return start[p + 1] - start[p];
  }
};

/// Grows patches one after the other, each to `size` tetrahedra, by the neighbour that brings the
/// fewest new nodes; what is left over in pieces under half the size joins its neighbours. The
/// same tetrahedra always give the same patches.
///
/// Reference for such patches: E. A. de Souza Neto, F. M. Andrade Pires, D. R. J. Owen, Int. J.
/// Numer. Meth. Engng 62 (2005) 353.
DilatationPatches make_dilatation_patches(const std::vector<Tet>& tets, int size);

} // namespace f2b
