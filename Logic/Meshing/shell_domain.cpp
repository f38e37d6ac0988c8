#include "Meshing/shell_domain.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

/// The box within the lattice, one sample off its border where gradients are one-sided.
RegionBox clipped(const RegionBox& box, const ScalarGrid& grid)
{
  const Vec3 first = grid.position(1, 1, 1);
  const Vec3 last = grid.position(grid.size.x() - 2, grid.size.y() - 2, grid.size.z() - 2);
  return {box.lo.cwiseMax(first), box.hi.cwiseMin(last)};
}

} // namespace

ShellDomain::ShellDomain(const ShellFields& fields, const RegionBox& box, double zeta,
                         double least_depth)
    : m_fields(fields), m_box(clipped(box, fields.skin)), m_zeta(zeta), m_least_depth(least_depth),
      m_level(fields.skin)
{
  for (const ScalarGrid* grid : {&fields.closed_bone, &fields.bone, &fields.hu})
    if (!grid->same_lattice(fields.skin) || grid->values.size() != fields.skin.values.size())
      throw Error("distance fields", "skin, bone and HU are sampled on different lattices",
                  "sample them on one lattice");
  if (!((m_box.hi - m_box.lo).minCoeff() > 0.0))
    throw Error("region of interest", "it does not meet the CT", "move it over the face");
  const Eigen::Vector3i& size = m_level.size;
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
      {
        const std::size_t n = m_level.index(i, j, k);
        const float depth =
            fields.skin.values[n] + static_cast<float>(this->zeta(m_level.position(i, j, k)));
        const float bone =
            std::max(fields.closed_bone.values[n], depth + static_cast<float>(m_least_depth));
        m_level.values[n] = std::max(depth, -bone);
      }
}

double ShellDomain::level(const Vec3& p) const
{
  return std::max(wall_level(p), m_level.value(p));
}

double ShellDomain::wall_level(const Vec3& p) const
{
  return std::max((m_box.lo - p).maxCoeff(), (p - m_box.hi).maxCoeff());
}

double ShellDomain::bone_level(const Vec3& p) const
{
  return std::max(m_fields.closed_bone.value(p), skin(p) + zeta(p) + m_least_depth);
}

ShellPart ShellDomain::part(const Vec3& p) const
{
  const double wall = wall_level(p), bone = -bone_level(p), depth = skin(p) + zeta(p);
  if (depth >= wall && depth >= bone)
    return ShellPart::UnderSkin;
  return bone >= wall ? ShellPart::Bone : ShellPart::Wall;
}

double ShellDomain::label_volume() const
{
  const ScalarGrid& grid = m_fields.skin;
  const double step = 0.5 * grid.spacing;
  const Eigen::Array3i count = ((m_box.hi - m_box.lo).array() / step).ceil().cast<int>();
  const Vec3 cell = (m_box.hi - m_box.lo).array() / count.cast<double>();
  std::size_t inside = 0;
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i)
      {
        const Vec3 p = m_box.lo + Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(cell);
        inside += skin(p) < 0.0 && bone_level(p) > 0.0;
      }
  return static_cast<double>(inside) * cell.prod();
}

} // namespace f2b
