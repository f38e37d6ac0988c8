#pragma once

#include "Core/geometry/vectors.hpp"

/// Which positive semi-definite tangent is nearest to a material's own?
namespace f2b
{

/// Sets the negative eigenvalues of a symmetric dP/dF to zero (Teran et al., Robust quasistatic
/// finite elements and flesh simulation, SCA 2005).
///
/// A stiffness assembled from such tangents is never indefinite, so its Newton step always lowers
/// the energy. Where dP/dF has no negative eigenvalue it is left as it is, bit for bit.
void make_positive(Eigen::Matrix<double, 9, 9>& tangent);

} // namespace f2b
