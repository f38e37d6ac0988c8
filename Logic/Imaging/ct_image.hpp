#pragma once

#include <itkImage.h>

/// What is a CT volume here?
namespace f2b
{

/// Hounsfield units on ITK's lattice (LPS, mm); any orthonormal direction.
using CtImage = itk::Image<short, 3>;

} // namespace f2b
