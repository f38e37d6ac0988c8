#pragma once

#include "Core/geometry/vectors.hpp"

#include <cstddef>

/// What is the value of a sampled field at any point of space?
namespace f2b
{

/// A scalar field on an isotropic grid whose axes are R, A and S.
///
/// Sample (i, j, k) lies at `origin + spacing * (i, j, k)` [mm, RAS], i fastest in `values`.
struct ScalarGrid
{
  Vec3 origin = Vec3::Zero();
  double spacing = 1.0;
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<float> values;

  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
  }
  std::size_t count() const { return static_cast<std::size_t>(size.x()) * size.y() * size.z(); }
  Vec3 position(int i, int j, int k) const { return origin + spacing * Vec3(i, j, k); }
  bool same_lattice(const ScalarGrid& other) const
  {
    return size == other.size && spacing == other.spacing && origin == other.origin;
  }

  /// Trilinear value; points outside take the value of the nearest point of the grid's box.
  double value(const Vec3& point_ras) const;
  /// Gradient of the trilinear interpolant by central differences over half a cell [1/mm].
  Vec3 gradient(const Vec3& point_ras) const;
};

/// Labels on the lattice of a ScalarGrid.
struct LabelGrid
{
  Vec3 origin = Vec3::Zero();
  double spacing = 1.0;
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<unsigned char> values;

  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
  }
  std::size_t count() const { return static_cast<std::size_t>(size.x()) * size.y() * size.z(); }
  Vec3 position(int i, int j, int k) const { return origin + spacing * Vec3(i, j, k); }
  /// Label of the sample nearest to a point; outside the grid's box, of the nearest sample in it.
  unsigned char nearest(const Vec3& point_ras) const;
};

} // namespace f2b
