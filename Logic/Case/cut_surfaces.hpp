#pragma once

#include "Core/geometry/osteotomy.hpp"

/// Which closed surfaces have the pieces of the sawn bone?
namespace f2b
{

/// The bone's surface without the kerf, by the parts that the lattice found.
struct CutSurfaces
{
  std::vector<TriangleMesh> parts; ///< uncut bone, then the fragments [mm, RAS]
  std::vector<double> volume_mm3;  ///< the same order
  double bone_mm3 = 0, kerf_mm3 = 0;
  double imbalance = 0; ///< |parts + kerf - bone| / bone
};

/// Saws `bone` exactly along the cuts of the partition's osteotomies.
/// \param bone  closed surface of the bone that `partition` was made of [mm, RAS]
/// Throws Error (bad input) where a bridge of bone is left between two parts, with its place, and as
/// `saw_bone` does.
CutSurfaces cut_surfaces(const TriangleMesh& bone, const BonePartition& partition);

} // namespace f2b
