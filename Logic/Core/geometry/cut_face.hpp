#pragma once

#include "Core/geometry/osteotomy.hpp"

/// Where do two parts of the cut bone face each other across the saw?
namespace f2b
{

/// The bone and its parts as the verb `cut` leaves them; all outlive its users.
struct CutBone
{
  const ScalarGrid& bone; ///< signed distance of the actual bone, negative inside
  const LabelGrid& parts; ///< BonePartition::labels, on the same lattice
  const std::vector<Osteotomy>& osteotomies;
};

/// A small piece of the saw's middle plane with bone on both sides.
struct CutPoint
{
  Vec3 place = Vec3::Zero();   ///< [mm, RAS]
  Vec3 normal = Vec3::UnitX(); ///< unit, towards the part
  double area_mm2 = 0;
  double kerf_mm = 0; ///< bone is gone up to half of it on either side
};

/// The common cut of two parts, at rest. The areas sum to that of the plane within the bone.
/// \param part, other  labels of BonePartition
std::vector<CutPoint> common_cut(const CutBone& cut, unsigned char part, unsigned char other);

/// All cuts of a part, whatever is beyond them.
std::vector<CutPoint> cuts_of(const CutBone& cut, unsigned char part);

/// How far a point lies from the sawn face of a part: from the middle plane less half the kerf;
/// infinite without cut points. Beyond the rim of the cut, the distance to the rim.
double distance_to_cut(const Vec3& p, const std::vector<CutPoint>& cuts, double spacing_mm);

} // namespace f2b
