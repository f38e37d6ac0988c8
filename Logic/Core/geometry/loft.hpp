#pragma once

#include "Core/geometry/vectors.hpp"

/// How far is a point from a body that is given by its horizontal cross-sections?
namespace f2b
{

/// One cross-section: the ellipse-like curve |r / half_width|^n + |(a - centre) / depth|^n = 1,
/// with depth = front - centre before the centre and `back` behind it [mm].
struct LoftSection
{
  double superior = 0;   ///< S of the section
  double half_width = 1; ///< in R
  double front = 1;      ///< A of the foremost point
};

/// A body through cross-sections, smooth (C1) in between and straight beyond the first and the
/// last.
class Loft
{
public:
  /// \param sections  by falling or rising S
  /// \param centre    A of the widest place [mm]
  /// \param back      depth behind the centre [mm]
  /// \param exponent  2: ellipses; more: squarer
  Loft(std::vector<LoftSection> sections, double centre, double back, double exponent);

  /// Signed distance to first order: exact on the surface, gradient near 1 close to it.
  double distance(const Vec3& point) const;

private:
  struct Outline
  {
    double half_width, front;
    double half_width_slope, front_slope; ///< change per mm of S
  };
  Outline outline(double superior) const;

  std::vector<LoftSection> m_sections;
  std::vector<Outline> m_knots;
  double m_centre;
  double m_back;
  double m_exponent;
};

} // namespace f2b
