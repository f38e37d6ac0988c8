#include "Core/element/quadrature_element.hpp"

#include <Eigen/LU>

#include <cmath>

namespace f2b
{

Tet4 make_tet4(const Tet4::Positions& X)
{
  Mat3 edges;
  for (int i = 0; i < 3; ++i)
    edges.col(i) = X.col(i + 1) - X.col(0);
  const Mat3 inverse = edges.inverse();
  Tet4 element;
  element.gradients[0].bottomRows<3>() = inverse;
  element.gradients[0].row(0) = -inverse.colwise().sum();
  element.volumes[0] = edges.determinant() / 6;
  return element;
}

namespace
{

/// Derivatives of eq. 4's shape functions by (r, s, q), with t = 1 - r - s.
Prism6::Gradients prism_parametric_gradients(double r, double s, double q)
{
  const double L[3] = {r, s, 1 - r - s};
  const double dr[3] = {1, 0, -1};
  const double ds[3] = {0, 1, -1};
  Prism6::Gradients g;
  for (int i = 0; i < 3; ++i)
  {
    g.row(i) << dr[i] * (1 - q), ds[i] * (1 - q), -L[i];
    g.row(i + 3) << dr[i] * q, ds[i] * q, L[i];
  }
  return g;
}

} // namespace

Prism6 make_prism6(const Prism6::Positions& X)
{
  static const double in_plane[3][2] = {{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}};
  const double offset = 0.5 / std::sqrt(3.0);
  Prism6 element;
  std::size_t point = 0;
  for (const double q : {0.5 - offset, 0.5 + offset})
    for (const auto& rs : in_plane)
    {
      const Prism6::Gradients local = prism_parametric_gradients(rs[0], rs[1], q);
      const Mat3 jacobian = X * local; // dX / d(r, s, q)
      element.gradients[point] = local * jacobian.inverse();
      // (r, s, q) with q pointing inwards is left-handed for an outward face: take the absolute
      // orientation out, so that a positive volume means an upright prism
      element.volumes[point] = -jacobian.determinant() / 12;
      ++point;
    }
  return element;
}

} // namespace f2b
