#include "Core/geometry/sculpture.hpp"

#include <cmath>

namespace f2b
{

Sculpture& Sculpture::append(Operation operation, const DistanceShape& shape, double blend)
{
  const BoundingSphere bound = std::visit([](const auto& s) { return s.bound(); }, shape);
  m_steps.push_back({operation, blend, bound, shape});
  return *this;
}

Sculpture& Sculpture::add(const DistanceShape& shape, double blend)
{
  return append(Operation::Add, shape, blend);
}

Sculpture& Sculpture::cut(const DistanceShape& shape, double blend)
{
  return append(Operation::Cut, shape, blend);
}

Sculpture& Sculpture::keep(const DistanceShape& shape, double blend)
{
  return append(Operation::Keep, shape, blend);
}

bool Sculpture::matters(const Step& step, const Vec3& point, double so_far)
{
  // Outside its bounding sphere a shape is at least this far away; a step changes nothing
  // when that leaves its blending range.
  const double reach = step.bound.radius + step.blend;
  switch (step.operation)
  {
  case Operation::Add:
  {
    const double limit = reach + so_far;
    return limit >= 0 && (point - step.bound.centre).squaredNorm() < limit * limit;
  }
  case Operation::Cut:
  {
    const double limit = reach - so_far;
    return limit >= 0 && (point - step.bound.centre).squaredNorm() < limit * limit;
  }
  case Operation::Keep:
    return true;
  }
  return true;
}

double Sculpture::distance(const Vec3& point, double initial) const
{
  const Vec3 folded(std::abs(point.x()), point.y(), point.z());
  double so_far = initial;
  for (const Step& step : m_steps)
  {
    if (!matters(step, folded, so_far))
      continue;
    const double d =
        std::visit([&folded](const auto& shape) { return shape.distance(folded); }, step.shape);
    if (so_far == std::numeric_limits<double>::infinity() && step.operation == Operation::Add)
      so_far = d;
    else if (step.operation == Operation::Add)
      so_far = smooth_union(so_far, d, step.blend);
    else if (step.operation == Operation::Cut)
      so_far = smooth_subtraction(so_far, d, step.blend);
    else
      so_far = smooth_intersection(so_far, d, step.blend);
  }
  return so_far;
}

} // namespace f2b
