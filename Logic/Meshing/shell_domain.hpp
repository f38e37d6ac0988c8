#pragma once

#include "Core/geometry/scalar_grid.hpp"

/// Which part of space is the facial shell, and which of its bounds is near? Lengths in mm, RAS.
namespace f2b
{

/// Signed distances on one lattice, negative inside [mm], and the CT itself.
struct ShellFields
{
  const ScalarGrid& skin;        ///< the head with its cavities closed
  const ScalarGrid& closed_bone; ///< bone with sinuses and orbits closed
  const ScalarGrid& bone;        ///< bone as it is
  const ScalarGrid& hu;          ///< Hounsfield units
  /// The skin's thickness where it differs from place to place, on any lattice [mm].
  const ScalarGrid* thickness = nullptr;
};

/// The region of interest.
struct RegionBox
{
  Vec3 lo = Vec3::Zero();
  Vec3 hi = Vec3::Zero();
};

/// The part of the boundary of the tetrahedra that a point lies on.
enum class ShellPart
{
  UnderSkin, ///< depth zeta below the skin, where the prisms stand
  Bone,      ///< closed bone, or the artificial floor that keeps the least tissue depth
  Wall,      ///< the region's walls
};

/// Tissue below the prisms: deeper than zeta, outside closed bone, in the box. Where bone lies
/// nearer to the skin than zeta + least_depth, the floor is there instead.
class ShellDomain
{
public:
  /// The box is clipped to the fields' lattice; throws f2b::Error when nothing is left of it or
  /// the lattices differ.
  /// \param zeta  thickness of the skin where the fields do not tell it [mm]
  ShellDomain(const ShellFields& fields, const RegionBox& box, double zeta, double least_depth);

  const ShellFields& fields() const { return m_fields; }
  const RegionBox& box() const { return m_box; }
  /// Thickness of the skin [mm].
  double zeta(const Vec3& p) const
  {
    return m_fields.thickness ? m_fields.thickness->value(p) : m_zeta;
  }

  double skin(const Vec3& p) const { return m_fields.skin.value(p); }
  /// Negative inside the region to fill with tetrahedra.
  double level(const Vec3& p) const;
  /// Signed distance to the box, negative inside.
  double wall_level(const Vec3& p) const;
  /// Signed distance to the closed bone or the floor of the least depth, negative in bone.
  double bone_level(const Vec3& p) const;
  /// The bound that is nearest to a point of the boundary.
  ShellPart part(const Vec3& p) const;
  /// Volume of skin and tissue together, by counting sub-voxels [mm^3].
  double label_volume() const;

private:
  ShellFields m_fields;
  RegionBox m_box;
  double m_zeta;
  double m_least_depth;
  ScalarGrid m_level; ///< the greater of depth and bone level, without the walls
};

} // namespace f2b
