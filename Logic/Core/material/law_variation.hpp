#pragma once

#include "Core/material/law.hpp"

/// What if a tissue were stiffer, or easier to compress, than its law says?
namespace f2b
{

/// The law with all stresses times a factor > 0; its Poisson's ratio stays.
Law stiffened(const Law& law, double factor);
/// The law with another bulk modulus, so that its small-strain Poisson's ratio is the given one in
/// (-1, 0.5); its answer to a change of shape stays.
Law with_poisson_ratio(const Law& law, double poisson_ratio);

} // namespace f2b
