#include "analytic_head.hpp"

#include <algorithm>
#include <cmath>

namespace f2b::testing
{

namespace
{

double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii)
{
  const Vec3 q = (p - centre).cwiseQuotient(radii);
  const double length = q.norm(), slope = q.cwiseQuotient(radii).norm();
  return slope < 1e-12 ? -radii.minCoeff() : length * (length - 1.0) / slope;
}

double joined(double a, double b)
{
  constexpr double width = 4.0;
  const double share = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * width * share * share;
}

double skin_distance(const Vec3& p)
{
  double d = ellipsoid(p, {0, 0, 0}, {70, 90, 95});
  d = joined(d, ellipsoid(p, {0, 90, -5}, {14, 20, 22}));    // nose
  d = joined(d, ellipsoid(p, {0, 80, -38}, {24, 14, 7}));    // upper lip
  return joined(d, ellipsoid(p, {0, 77, -50}, {22, 14, 7})); // lower lip
}

double closed_bone_distance(const Vec3& p)
{
  const double cranium = ellipsoid(p, {0, -4, 0}, {60, 80, 88});
  return std::min(cranium, ellipsoid(p, {0, 80, 40}, {40, 5.5, 12})); // brow, close to the skin
}

double hu_value(double skin, double bone)
{
  if (skin > 0.0)
    return -1000.0;
  if (bone < 0.0)
    return 900.0;
  return skin > -5.0 ? -90.0 : 50.0;
}

} // namespace

AnalyticHead analytic_head(double spacing_mm)
{
  ScalarGrid lattice;
  lattice.spacing = spacing_mm;
  lattice.origin = Vec3(-90, -20, -90);
  lattice.size = (Vec3(180, 150, 170) / spacing_mm).array().ceil().cast<int>();
  lattice.values.resize(lattice.count());
  AnalyticHead head{lattice, lattice, lattice, lattice};
  for (int k = 0; k < lattice.size.z(); ++k)
    for (int j = 0; j < lattice.size.y(); ++j)
      for (int i = 0; i < lattice.size.x(); ++i)
      {
        const Vec3 p = lattice.position(i, j, k);
        const std::size_t n = lattice.index(i, j, k);
        const double skin = skin_distance(p), closed = closed_bone_distance(p);
        const double bone = std::max(closed, -ellipsoid(p, cavity_centre(), {16, 14, 15}));
        head.skin.values[n] = static_cast<float>(skin);
        head.closed_bone.values[n] = static_cast<float>(closed);
        head.bone.values[n] = static_cast<float>(bone);
        head.hu.values[n] = static_cast<float>(hu_value(skin, bone));
      }
  return head;
}

RegionBox face_region()
{
  return {Vec3(-62, 20, -66), Vec3(62, 118, 58)};
}

Vec3 cavity_centre()
{
  return {30, 61, 12};
}

} // namespace f2b::testing
