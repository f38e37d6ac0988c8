#pragma once

#include "Meshing/shell_domain.hpp"
#include "Meshing/skin_prisms.hpp"
#include "Meshing/tet_star.hpp"

/// Which facets of the tetrahedra carry the skin, and where does their sheet end? Lengths in mm.
namespace f2b
{

/// Boundary facets of the tetrahedra, counter-clockwise from outside.
struct ShellFacets
{
  std::vector<Triangle> skin; ///< one connected manifold sheet at depth zeta
  std::vector<Triangle> rest; ///< all others: bone and walls
  int stray = 0;              ///< facets at depth zeta that are not of the sheet
};

/// Facets of the largest sheet at depth zeta. Facets that only round the edge between the sheet
/// and a wall are left out of it.
ShellFacets shell_facets(const TetrahedralMesh& mesh, const ShellDomain& domain, double edge_mm);

/// Takes facets out of the sheet and leaves it connected and manifold.
void drop_from_sheet(ShellFacets& facets, const std::vector<int>& dropped);

/// The sheet with its own node numbers.
struct ShellSheet
{
  PrismSheet prisms;
  std::vector<int> tet_node; ///< node of the tetrahedral mesh, one per sheet node
  std::vector<bool> rim;     ///< on the edge of the sheet, one per sheet node
};

/// Moves rim nodes within `snap_mm` of a wall onto it where no dihedral angle falls below
/// `least_deg`, and numbers the sheet's nodes.
ShellSheet shell_sheet(TetStars& stars, const ShellFacets& facets, const ShellDomain& domain,
                       double snap_mm, double least_deg);

} // namespace f2b
