#pragma once

#include "Core/geometry/swept_curve.hpp"

/// What does a swept curve look like along the saw's direction?
namespace f2b
{

/// The strip that a saw of some width leaves in the plane across its direction.
///
/// A station is a vertex of the curve; straight runs of it are one segment.
class SawTrack
{
public:
  using Vec2 = Eigen::Vector2d;

  struct Station
  {
    /// on the curve and half the width beside it, corners mitred
    Vec2 middle = Vec2::Zero(), left = Vec2::Zero(), right = Vec2::Zero();
    double height = 0;        ///< of the curve, along the direction
  };

  /// Throws Error as `require_swept`.
  SawTrack(const SweptCurve& curve, double width_mm);

  const std::vector<Station>& stations() const { return m_stations; }
  Vec3 point(const Vec2& place, double height) const
  {
    return place.x() * m_x + place.y() * m_y + height * m_z;
  }
  Vec3 direction(const Vec2& along) const { return along.x() * m_x + along.y() * m_y; }

private:
  void place_stations(const SweptCurve& curve);
  void offset_sides(const SweptCurve& curve, double width_mm);
  void require_apart(const SweptCurve& curve) const;

  Vec3 m_x, m_y, m_z; ///< m_z is the saw's direction
  std::vector<Station> m_stations;
};

} // namespace f2b
