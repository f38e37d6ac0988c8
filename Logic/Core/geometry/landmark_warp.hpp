#pragma once

#include "Core/geometry/vectors.hpp"

/// How does a face move if some of its points are dragged?
namespace f2b
{

/// A smooth displacement field that takes each `from` point exactly to its `to` point and fades
/// out.
///
/// Sum of Wendland's C2 functions phi(r) = (1 - r/R)^4 (4 r/R + 1) for r < R, centred on the from
/// points; reference: H. Wendland, Adv. Comput. Math. 4 (1995) 389.
class LandmarkWarp
{
public:
  /// From points nearer to each other than this cannot be told apart [mm].
  static constexpr double nearest_mm = 0.1;

  /// \param radius_mm  R: no displacement farther than this from every from point
  /// Throws Error on unequal counts, coincident from points or non-finite coordinates.
  LandmarkWarp(std::vector<Vec3> from, const std::vector<Vec3>& to, double radius_mm);

  Vec3 displacement(const Vec3& point) const;

private:
  std::vector<Vec3> m_from;
  double m_radius_mm;
  Eigen::MatrixXd m_coefficients; ///< one row per from point
};

} // namespace f2b
