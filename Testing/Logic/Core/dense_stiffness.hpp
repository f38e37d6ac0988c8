#pragma once

#include "Core/element/quadrature_element.hpp"

/// An element's stiffness as one full matrix, for comparison.
namespace f2b::testing
{

template <class Element>
using DenseStiffness = Eigen::Matrix<double, 3 * Element::corners, 3 * Element::corners>;

/// Forces, and the stiffness control vector by control vector (x, y, z of the first, ...).
template <class Element, class PointLaw>
typename Element::Positions element_forces(const Element& element,
                                           const typename Element::Positions& x,
                                           const PointLaw& law, DenseStiffness<Element>& stiffness)
{
  constexpr int n = Element::corners;
  std::array<double, 9 * block_count(n)> blocks;
  const typename Element::Positions forces = f2b::element_forces(element, x, law, blocks.data());
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
    {
      const Mat3 block = Eigen::Map<const Mat3>(blocks.data() + 9 * block_index(n, a, b));
      stiffness.template block<3, 3>(3 * a, 3 * b) = block;
      stiffness.template block<3, 3>(3 * b, 3 * a) = block.transpose();
    }
  return forces;
}

} // namespace f2b::testing
