#pragma once

#include "Core/mesh/boundary_facets.hpp"
#include "Meshing/shell_domain.hpp"

#include <functional>

/// Where do the tops of the skin's prisms stand when their bottoms are facets at depth zeta?
///
/// Every bottom node is traced up the gradient of the smoothed skin distance to the skin, so that
/// feet do not run together at creases; then tops slide on the skin until every prism is well
/// shaped. Lengths in mm, RAS.
namespace f2b
{

struct SkinPrismOptions
{
  double smoothing_mm = 2.0;       ///< Gaussian sigma for the distance that paths follow
  double wanted_jacobian = 0.35;   ///< scaled Jacobian below which tops are moved
  double required_jacobian = 0.12; ///< below it bottoms may move and tops may leave the skin
  int sweeps = 30;
};

/// The sheet on which prisms are to stand: nodes are numbered from 0 in the sheet.
struct PrismSheet
{
  std::vector<Vec3> bottom;        ///< one per node
  std::vector<Vec3> top;           ///< one per node; result
  std::vector<Triangle> triangles; ///< counter-clockwise from outside
  std::vector<unsigned char>
      walls; ///< one per node: bit a for the low wall of axis a, bit a + 3 for the high
};

/// The skin distance smoothed by a Gaussian within a box [mm], for tracing.
ScalarGrid smoothed(const ScalarGrid& field, const RegionBox& box, double sigma_mm);

/// Moves a bottom node if the tetrahedra below allow it.
using BottomMove = std::function<bool(int sheet_node, const Vec3& position)>;

/// Fills `sheet.top`. Nodes on walls stay on them. Bottoms are moved only where a prism cannot be
/// made good enough otherwise.
void place_tops(PrismSheet& sheet, const ShellDomain& domain, const SkinPrismOptions& options,
                const BottomMove& move_bottom);

/// Scaled Jacobian of each prism of the sheet, 0 where it is not positive at a quadrature point.
std::vector<double> prism_qualities(const PrismSheet& sheet);

} // namespace f2b
