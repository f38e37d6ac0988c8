#pragma once

#include "Core/geometry/scalar_grid.hpp"
#include "Core/geometry/swept_curve.hpp"

#include <string>

/// Which bone is freed by the surgeon's cuts?
namespace f2b
{

/// A rectangle that a saw cuts along. Positions in mm, RAS; axes are orthonormal.
struct BoundedPlane
{
  std::string name;
  Vec3 center = Vec3::Zero();
  Vec3 u = Vec3::UnitX(), v = Vec3::UnitY(); ///< in-plane axes; the normal is u x v
  double half_u = 50, half_v = 50;           ///< half lengths [mm]
  bool may_miss = false; ///< no error where it meets no bone, as between teeth that do not touch

  Vec3 normal() const { return u.cross(v); }
  double signed_distance(const Vec3& p) const { return normal().dot(p - center); }
  /// Does the normal line through p meet the rectangle, widened by a margin?
  bool faces(const Vec3& p, double margin_mm) const;
  /// Does the segment pq pass through the rectangle? If so, `at` is where.
  bool separates(const Vec3& p, const Vec3& q, Vec3& at) const;
};

/// One operation: the planes and curves that it cuts along and the fragment that it frees.
struct Osteotomy
{
  std::string fragment; ///< name of the freed fragment
  std::vector<BoundedPlane> planes;
  Vec3 fragment_point = Vec3::Zero(); ///< a point on or near the bone that is to be free
  double kerf_mm = 1.0;               ///< width of bone that the saw takes away
  std::vector<SweptCurve> curves = {};
};

/// The bone after the cuts, on the lattice of its distance maps.
struct BonePartition
{
  static constexpr unsigned char no_bone = 0, uncut = 1, first_fragment = 2;

  LabelGrid labels; ///< of the closed bone: no_bone, uncut or first_fragment + index
  std::vector<Osteotomy> osteotomies;
  std::vector<std::vector<Vec3>> cut_points; ///< per fragment: points of its cut faces [mm]
  std::vector<double> fragment_volume_mm3;   ///< of actual bone
};

/// Cuts the bone along all planes and curves at once and names the freed fragments.
///
/// Bone is connected through face neighbours of the lattice unless a cut passes between them.
/// Cavities of the closed bone, and islands of bone, go with the nearest connected bone.
/// \param bone         signed distance of the actual bone, negative inside
/// \param closed_bone  the same with cavities closed; contains `bone`
/// Throws Error where a plane or curve misses the bone, where a fragment point is far from bone, where cuts
/// do not free their fragment, or where two fragments are one piece.
BonePartition cut_bone(const ScalarGrid& bone, const ScalarGrid& closed_bone,
                       const std::vector<Osteotomy>& osteotomies);

/// Level-set field of one part of the bone (actual bone, kerf removed); its zero level is a closed
/// surface with flat cut faces.
/// \param label  BonePartition::uncut or first_fragment + index
ScalarGrid part_field(const ScalarGrid& bone, const BonePartition& partition, unsigned char label);

} // namespace f2b
