#pragma once

#include "Core/mesh/mixed_mesh.hpp"
#include "Meshing/shell_domain.hpp"

/// How far are the mesh's skin and the CT's skin from each other, both ways? Lengths in mm, RAS.
namespace f2b
{

struct DistanceFigures
{
  std::size_t samples = 0;
  double median = 0.0, p95 = 0.0, p995 = 0.0, max = 0.0; ///< [mm]
  Vec3 max_place = Vec3::Zero();
};

/// A part of the CT's skin that the mesh leaves out, such as a flap thinner than two prisms.
struct LeftOut
{
  double distance = 0.0; ///< of its farthest point to the mesh [mm]
  Vec3 place = Vec3::Zero();
};

struct SkinFidelity
{
  DistanceFigures mesh_to_ct;    ///< from points of the prisms' tops to the zero level
  DistanceFigures ct_to_mesh;    ///< from the zero level on the lattice's edges to the tops
  std::vector<LeftOut> left_out; ///< the worst places over 1.5 mm, at least 10 mm apart, at most 12
};

/// Leaves out what is nearer to the region's walls than `wall_margin_mm`.
SkinFidelity skin_fidelity(const MixedMesh& mesh, const ShellDomain& domain, double wall_margin_mm);

} // namespace f2b
