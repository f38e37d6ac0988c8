#pragma once

#include <Core/geometry/osteotomy.hpp>

#include <algorithm>

/// A block of bone to be sawn: 60 x 40 x 30 mm about the origin, on a lattice of 1 mm.
namespace f2b::testing
{

inline const Vec3 box_half{30, 20, 15};

/// Signed distance of a block (outside its edges by the largest axis only) [mm].
inline double box_distance(const Vec3& p, const Vec3& center, const Vec3& half)
{
  return ((p - center).cwiseAbs() - half).maxCoeff();
}

template <class Distance>
ScalarGrid sampled(Distance distance)
{
  ScalarGrid grid;
  grid.origin = {-40.5, -30.5, -25.5};
  grid.size = {82, 62, 82};
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        grid.values.push_back(static_cast<float>(distance(grid.position(i, j, k))));
  return grid;
}

inline ScalarGrid box_bone()
{
  return sampled([](const Vec3& p) { return box_distance(p, Vec3::Zero(), box_half); });
}

/// Volume inside the zero level, with partial volumes at the border [mm^3]; for faces along the
/// axes.
inline double volume(const ScalarGrid& field)
{
  double sum = 0;
  for (const float value : field.values)
    sum += std::clamp(0.5 - double(value) / field.spacing, 0.0, 1.0);
  return sum * field.spacing * field.spacing * field.spacing;
}

/// A plane at right angles to R.
inline BoundedPlane plane_at(double r, double half_a = 28, double half_s = 22)
{
  BoundedPlane plane;
  plane.name = "at R " + std::to_string(r);
  plane.center = {r, 0, 0};
  plane.u = Vec3::UnitY();
  plane.v = Vec3::UnitZ();
  plane.half_u = half_a;
  plane.half_v = half_s;
  return plane;
}

inline Osteotomy cut_at(double r, double fragment_r, const std::string& fragment = "end",
                        double kerf_mm = 2)
{
  return {fragment, {plane_at(r)}, {fragment_r, 0, 0}, kerf_mm};
}

} // namespace f2b::testing
