#pragma once

#include "Core/error.hpp"
#include "Core/geometry/osteotomy.hpp"

#include <string>
#include <variant>

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

/// Bone that the saw left between two parts.
struct BoneBridge
{
  std::size_t part = 0, other = 0; ///< 0: uncut bone, 1 + index: a fragment
  Vec3 place = Vec3::Zero();       ///< where it passes a cut beside its edge [mm, RAS]
  std::string cut;                 ///< the plane, or facet of a curve
};

/// "a bridge of bone is left between ...", with its place and a remedy, as bad input.
Error bridge_error(const BoneBridge& bridge, const BonePartition& partition);

/// Saws `bone` exactly along the cuts of the partition's osteotomies; a bridge if that leaves one.
/// \param bone  closed surface of the bone that `partition` was made of [mm, RAS]
/// Throws Error as `saw_bone` does.
std::variant<CutSurfaces, BoneBridge> cut_surfaces(const TriangleMesh& bone,
                                                   const BonePartition& partition);

} // namespace f2b
