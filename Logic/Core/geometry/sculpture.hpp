#pragma once

#include "Core/geometry/distance_shapes.hpp"

#include <limits>
#include <vector>

/// How far is a point from a body that is modelled by adding and cutting simple shapes one by one?
namespace f2b
{

/// A body that is symmetric about the plane R = 0: each shape stands for itself and its mirror
/// image.
///
/// Steps act in the order they were made. All lengths are in mm; `blend` is the distance over which
/// a step melts into what is there. Shapes too far away to matter are skipped without an error.
class Sculpture
{
public:
  Sculpture& add(const DistanceShape& shape, double blend = 0);
  Sculpture& cut(const DistanceShape& shape, double blend = 0);
  Sculpture& keep(const DistanceShape& shape, double blend = 0);

  /// Signed distance, starting from `initial` (nothing, unless another body is to be worked on).
  double distance(const Vec3& point,
                  double initial = std::numeric_limits<double>::infinity()) const;

private:
  enum class Operation
  {
    Add,
    Cut,
    Keep
  };
  struct Step
  {
    Operation operation;
    double blend;
    BoundingSphere bound;
    DistanceShape shape;
  };
  Sculpture& append(Operation operation, const DistanceShape& shape, double blend);
  static bool matters(const Step& step, const Vec3& point, double so_far);

  std::vector<Step> m_steps;
};

} // namespace f2b
