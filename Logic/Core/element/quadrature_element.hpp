#pragma once

#include "Core/geometry/vectors.hpp"

/// What are an element's energy, forces and stiffness at given corner positions?
namespace f2b
{

/// Shape-function gradients in the rest position at an element's quadrature points.
///
/// \tparam N  corners   \tparam Q  quadrature points
template <int N, int Q>
struct QuadratureElement
{
  static constexpr int corners = N;
  using Positions = Eigen::Matrix<double, 3, N>; ///< one column per corner [mm]
  using Gradients = Eigen::Matrix<double, N, 3>; ///< row i: dN_i/dX [1/mm]
  using Stiffness = Eigen::Matrix<double, 3 * N, 3 * N>;

  std::array<Gradients, Q> gradients;
  std::array<double, Q> volumes; ///< quadrature weight times det dX/dxi [mm^3]
};

/// Linear tetrahedron (paper eq. 3), one point, exact.
using Tet4 = QuadratureElement<4, 1>;
/// Linear prism (paper eq. 4), 3 x 2 points: exact for affine fields on straight-sided prisms.
using Prism6 = QuadratureElement<6, 6>;

/// \param X  rest corners [mm]
Tet4 make_tet4(const Tet4::Positions& X);
/// \param X  rest corners [mm], 0-2 on the face, 3-5 below (see MixedMesh)
Prism6 make_prism6(const Prism6::Positions& X);

/// Strain energy [N mm]; infinite if a quadrature point is inverted.
template <class Element, class Law>
double element_energy(const Element& element, const typename Element::Positions& x, const Law& law)
{
  double energy = 0;
  for (std::size_t q = 0; q < element.gradients.size(); ++q)
    energy += element.volumes[q] * law.energy(x * element.gradients[q]);
  return energy;
}

/// Internal forces dE/dx, one column per corner [N].
template <class Element, class Law>
typename Element::Positions element_forces(const Element& element,
                                           const typename Element::Positions& x, const Law& law)
{
  typename Element::Positions forces = Element::Positions::Zero();
  for (std::size_t q = 0; q < element.gradients.size(); ++q)
  {
    const auto& G = element.gradients[q];
    const Mat3 F = x * G;
    forces += element.volumes[q] * law.stress(F) * G.transpose();
  }
  return forces;
}

/// Internal forces and stiffness d2E/dx2 [N/mm], corner by corner (x, y, z of corner 0, ...).
template <class Element, class Law>
typename Element::Positions element_forces(const Element& element,
                                           const typename Element::Positions& x, const Law& law,
                                           typename Element::Stiffness& stiffness)
{
  constexpr int n = Element::corners;
  typename Element::Positions forces = Element::Positions::Zero();
  stiffness.setZero();
  Eigen::Matrix<double, 9, 9> tangent;
  for (std::size_t q = 0; q < element.gradients.size(); ++q)
  {
    const auto& G = element.gradients[q];
    const double volume = element.volumes[q];
    const Mat3 F = x * G;
    forces += volume * law.stress(F, tangent) * G.transpose();
    for (int b = 0; b < n; ++b)
    {
      // d vec(F) / d x_b is the Kronecker product of row b of G with the identity
      Eigen::Matrix<double, 9, 3> column = tangent.template leftCols<3>() * (volume * G(b, 0));
      column += tangent.template middleCols<3>(3) * (volume * G(b, 1));
      column += tangent.template rightCols<3>() * (volume * G(b, 2));
      for (int a = 0; a < n; ++a)
        stiffness.template block<3, 3>(3 * a, 3 * b) += G(a, 0) * column.template topRows<3>() +
                                                        G(a, 1) * column.template middleRows<3>(3) +
                                                        G(a, 2) * column.template bottomRows<3>();
    }
  }
  return forces;
}

} // namespace f2b
