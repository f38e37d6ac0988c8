#pragma once

#include "Core/geometry/vectors.hpp"
#include "Core/material/positive_tangent.hpp"

/// What are an element's energy, forces and stiffness at given control vectors?
namespace f2b
{

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Shape-function gradients in the rest position at an element's quadrature points.
///
/// The element is x = sum_a N_a q_a with scalar N_a; its control vectors q_a are corner positions
/// or slopes.
/// \tparam N  control vectors   \tparam Q  quadrature points
template <int N, int Q>
struct QuadratureElement
{
  static constexpr int corners = N;
  static constexpr int points = Q;
  using Positions = Eigen::Matrix<double, 3, N>; ///< one column per control vector [mm]
  using Gradients = Eigen::Matrix<double, N, 3>; ///< row i: dN_i/dX [1/mm]

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

/// Where 3 x 3 block (a, b), a >= b, lies in the lower half of a symmetric matrix of n x n blocks
/// that is kept block column by block column, each block as 9 numbers in columns.
constexpr int block_index(int n, int a, int b)
{
  return b * n - b * (b - 1) / 2 + a - b;
}
constexpr int block_count(int n)
{
  return n * (n + 1) / 2;
}

/// The law of quadrature point q; overloaded for laws that differ from point to point.
template <class PointLaw, class Gradients>
const PointLaw& law_at(const PointLaw& law, std::size_t /*q*/, const Gradients& /*at_q*/)
{
  return law;
}

/// Strain energy [N mm]; infinite if the law is at a quadrature point.
template <class Element, class PointLaw>
double element_energy(const Element& element, const typename Element::Positions& x,
                      const PointLaw& law)
{
  double energy = 0;
  for (std::size_t q = 0; q < Element::points; ++q)
    energy +=
        element.volumes[q] * law_at(law, q, element.gradients[q]).energy(x * element.gradients[q]);
  return energy;
}

/// Internal forces dE/dx, one column per control vector [N].
template <class Element, class PointLaw>
typename Element::Positions
element_forces(const Element& element, const typename Element::Positions& x, const PointLaw& law)
{
  typename Element::Positions forces = Element::Positions::Zero();
  for (std::size_t q = 0; q < Element::points; ++q)
  {
    const auto& G = element.gradients[q];
    const Mat3 F = x * G;
    forces += element.volumes[q] * law_at(law, q, G).stress(F) * G.transpose();
  }
  return forces;
}

/// The (i, j) components of all 3 x 3 blocks at once, sum_d left(a, d) right(b, d), and for i != j
/// the (j, i) components, which are their transposes.
///
/// Long columns of one component run through vector registers; a 3 x 3 block does not.
template <int N, int D>
void write_component(const Eigen::Matrix<double, N, D>& left, const double* right, int i, int j,
                     double* stiffness)
{
  using Column = Eigen::Matrix<double, N, 1>;
  Eigen::Matrix<double, N, N> K;
  static_assert(N % 2 == 0);
  for (int b = 0; b < N; b += 2)
  {
    Column even = Column::Zero(), odd = Column::Zero();
    for (int d = 0; d < D; ++d)
    {
      even += left.col(d) * right[d * N + b];
      odd += left.col(d) * right[d * N + b + 1];
    }
    K.col(b) = even;
    K.col(b + 1) = odd;
  }
  for (int b = 0; b < N; ++b)
    for (int a = b; a < N; ++a)
    {
      double* block = stiffness + 9 * block_index(N, a, b);
      block[j + 3 * i] = K(b, a);
      block[i + 3 * j] = K(a, b);
    }
}

/// Internal forces and stiffness d2E/dx2 [N/mm].
/// \param[out] stiffness  9 block_count(N) numbers, see `block_index`
/// \param positive        makes every point's tangent positive semi-definite
template <class Element, class PointLaw>
typename Element::Positions
element_forces(const Element& element, const typename Element::Positions& x, const PointLaw& law,
               double* stiffness, bool positive = false)
{
  constexpr int N = Element::corners, Q = Element::points;
  static constexpr int pairs[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  using Strided = Eigen::Map<const Mat3, Eigen::Unaligned, Eigen::Stride<27, 3>>;
  typename Element::Positions forces = Element::Positions::Zero();
  std::array<Eigen::Matrix<double, N, 3 * Q>, 6> left; // gradients times tangent, by (i, j)
  Mat9 tangent;
  for (std::size_t q = 0; q < Q; ++q)
  {
    const auto& G = element.gradients[q];
    const Mat3 F = x * G;
    forces += element.volumes[q] * law_at(law, q, G).stress(F, tangent) * G.transpose();
    if (positive)
      make_positive(tangent);
    for (std::size_t p = 0; p < 6; ++p)
    {
      const Mat3 part =
          element.volumes[q] * Strided(tangent.data() + pairs[p][0] + 9 * pairs[p][1]);
      left[p].template middleCols<3>(3 * static_cast<Eigen::Index>(q)).noalias() = G * part;
    }
  }
  static_assert(sizeof(element.gradients) == sizeof(double) * N * 3 * Q, "one after the other");
  for (std::size_t p = 0; p < 6; ++p)
    write_component<N, 3 * Q>(left[p], element.gradients[0].data(), pairs[p][0], pairs[p][1],
                              stiffness);
  return forces;
}

} // namespace f2b
