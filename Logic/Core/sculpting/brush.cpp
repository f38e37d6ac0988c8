#include "Core/sculpting/brush.hpp"

#include <cmath>

namespace f2b
{
namespace
{

constexpr double poisson_ratio = 0.45; // nearly as tissue; the shape hardly depends on it
constexpr double a = 1, b = a / (4 * (1 - poisson_ratio));

/// Kelvinlet of a unit force, size epsilon, without the factor of the shear modulus.
Vec3 kelvinlet(const Vec3& r, const Vec3& force, double epsilon)
{
  const double size = std::sqrt(r.squaredNorm() + epsilon * epsilon);
  const double cubed = size * size * size;
  return ((a - b) / size + a * epsilon * epsilon / (2 * cubed)) * force +
         b / cubed * r.dot(force) * r;
}

} // namespace

double falloff(Falloff curve, double t)
{
  if (!(t < 1))
    return 0;
  switch (curve)
  {
  case Falloff::Smooth:
    return (1 - t * t) * (1 - t * t);
  case Falloff::Sphere:
    return std::sqrt(1 - t * t);
  case Falloff::Linear:
    return 1 - t;
  case Falloff::Sharp:
    return (1 - t) * (1 - t);
  case Falloff::Constant:
    break;
  }
  return 1;
}

Vec3 elastic_drag(const Vec3& offset, const Vec3& drag, double radius_mm)
{
  const double small = 0.5 * radius_mm, large = radius_mm;
  const double at_middle = (1.5 * a - b) * (1 / small - 1 / large);
  return (kelvinlet(offset, drag, small) - kelvinlet(offset, drag, large)) / at_middle;
}

} // namespace f2b
