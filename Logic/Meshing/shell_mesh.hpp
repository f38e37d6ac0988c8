#pragma once

#include "Core/mesh/mesh_quality.hpp"
#include "Core/progress.hpp"
#include "Meshing/shell_domain.hpp"
#include "Meshing/skin_fidelity.hpp"
#include "Meshing/skin_prisms.hpp"

/// How is the facial shell made into conforming prisms on tetrahedra (design 5)? mm, RAS.
namespace f2b
{

struct ShellMeshOptions
{
  RegionBox region;
  double zeta = 1.5; ///< thickness of the skin, height of the prisms, where no map tells [mm]
  double least_depth = 1.5; ///< least tissue kept below the prisms [mm]
  double density = 1.0;     ///< 1 gives about 11k prisms on a face; lengths go with density^(-1/3)
  double contact_tolerance_mm = 2.0; ///< inner nodes farther from bone than this are free
  double fat_below_hu = -30.0;       ///< a tetrahedron with a lower mean is fat, else muscle
  double sliver_bound_deg = 12.0;    ///< dihedral angle that the mesher perturbs vertices for
  double wall_margin_mm = 5.0;       ///< skin nearer to the walls is not compared with the CT
  SkinPrismOptions prisms;
};

/// A place that a person should look at.
struct MeshRemark
{
  std::string what;
  Vec3 where = Vec3::Zero(); ///< [mm, RAS]
};

struct ShellMeshReport
{
  int prisms = 0;
  int tets = 0;
  int nodes = 0;
  MeshQuality quality;
  double mesh_volume = 0.0;  ///< [mm^3]
  double label_volume = 0.0; ///< of the labels that were meshed, by counting sub-voxels [mm^3]
  SkinFidelity fidelity;
  int dropped_tets = 0;       ///< not connected to the largest part
  int split_nodes = 0;        ///< added where parts touched in a node or edge only
  int stray_facets = 0;       ///< at depth zeta, but not of the one sheet
  int holes = 0;              ///< boundary loops of the skin that are not on the walls
  int bad_prisms = 0;         ///< with a scaled Jacobian below 0.1
  int tops_off_skin = 0;      ///< tops farther than 0.1 mm from the skin
  int non_manifold_nodes = 0; ///< of the whole boundary
  double mesh_seconds = 0.0;  ///< tetrahedra
  double prism_seconds = 0.0;
  double total_seconds = 0.0;
  std::vector<MeshRemark> remarks;
};

struct ShellMesh
{
  MixedMesh mesh;
  ShellMeshReport report;
};

/// Throws f2b::Error when the region holds no tissue or no skin.
ShellMesh build_shell_mesh(const ShellFields& fields, const ShellMeshOptions& options,
                           const Progress& progress = no_progress);

} // namespace f2b
