#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <cmath>

/// Which points of space does a grid sample?
namespace f2b
{

/// A box [mm, RAS].
struct Box
{
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();
};

/// An isotropic lattice whose axes are R, A and S; i runs fastest.
struct Lattice
{
  Vec3 origin = Vec3::Zero();
  double spacing = 1.0;
  Eigen::Vector3i size = Eigen::Vector3i::Zero();

  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
  }
  std::size_t count() const { return static_cast<std::size_t>(size.x()) * size.y() * size.z(); }
  Vec3 position(int i, int j, int k) const { return origin + spacing * Vec3(i, j, k); }
  Vec3 last() const { return position(size.x() - 1, size.y() - 1, size.z() - 1); }
};

inline Lattice lattice_of(const ScalarGrid& grid)
{
  return {grid.origin, grid.spacing, grid.size};
}

/// The smallest lattice that covers a box and has a sample at `anchor` (or would have).
inline Lattice lattice_over(const Box& box, double spacing, const Vec3& anchor)
{
  Lattice lattice;
  lattice.spacing = spacing;
  for (int a = 0; a < 3; ++a)
  {
    const double first = std::floor((box.min[a] - anchor[a]) / spacing + 1e-6);
    const double last = std::ceil((box.max[a] - anchor[a]) / spacing - 1e-6);
    lattice.origin[a] = anchor[a] + first * spacing;
    lattice.size[a] = static_cast<int>(last - first) + 1;
  }
  return lattice;
}

inline ScalarGrid grid_on(const Lattice& lattice, float value)
{
  return {lattice.origin, lattice.spacing, lattice.size,
          std::vector<float>(lattice.count(), value)};
}

} // namespace f2b
