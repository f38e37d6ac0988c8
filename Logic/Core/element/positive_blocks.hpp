#pragma once

/// Which positive semi-definite stiffness is nearest to an element's own?
namespace f2b
{

/// Sets the negative eigenvalues of an element's stiffness to zero; where there is none, nothing is
/// changed.
/// \param stiffness  9 block_count(n) numbers, see `block_index`
/// \param n          control vectors of the element
void make_positive(double* stiffness, int n);

} // namespace f2b
