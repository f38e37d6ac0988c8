#pragma once

#include "Core/geometry/vectors.hpp"

/// At which points, with which weights, is a function integrated over a line or a triangle?
namespace f2b
{

struct LinePoint
{
  double at;     ///< in (0, 1)
  double weight; ///< of all points: sum 1
};

/// Gauss-Legendre on (0, 1): exact for polynomials of degree 2 n - 1.
std::vector<LinePoint> gauss_rule(int n);

struct TrianglePoint
{
  Vec3 L;        ///< area coordinates, all > 0: no rule has points on an edge or a corner
  double weight; ///< of all points: sum 1, so that the integral is the area times the weighted sum
};

/// Symmetric rules with positive weights (Strang & Fix 1973; Dunavant 1985):
/// 3, 6, 7 or 12 points, exact for polynomials of degree 2, 4, 5 and 6; 96 points are
/// `corner_graded_rule(4)`.
std::vector<TrianglePoint> triangle_rule(int points);

/// 6 n^2 points for functions that are smooth along every ray from a corner, but not at the corner
/// itself: each half of a corner's third of the triangle is a Gauss square collapsed to that corner.
std::vector<TrianglePoint> corner_graded_rule(int n);

} // namespace f2b
