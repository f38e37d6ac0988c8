#pragma once

#include "Core/material/law.hpp"

#include <functional>
#include <optional>

/// Which curve of stress does a law draw when a specimen is loaded, and how far is it stable there?
///
/// The deformation is the stretch of the pulled direction(s), or the amount of shear; the stress is
/// the nominal one, force by rest area [MPa].
namespace f2b
{

/// How a laboratory loads a specimen.
enum class Loading
{
  Uniaxial,    ///< one direction pulled, the two others free
  Equibiaxial, ///< two directions pulled alike, the third free
  SimpleShear, ///< x = X + gamma Y
};

/// The deformation at rest: stretch 1, shear 0.
inline double rest_of(Loading loading)
{
  return loading == Loading::SimpleShear ? 0 : 1;
}

struct CurvePoint
{
  double stress = 0; ///< [MPa]
  double slope = 0;  ///< d stress / d deformation, the sides staying free [MPa]
};

/// The closed form of matter that keeps its volume, whatever the law's bulk modulus.
CurvePoint incompressible_response(const Law& law, Loading loading, double deformation);

/// With the law's own compressibility: the free sides take the width that leaves them without
/// stress. Nothing where no such width is found near the incompressible one.
std::optional<CurvePoint> compressible_response(const Law& law, Loading loading,
                                                double deformation);

enum class Compressibility
{
  Incompressible,
  OfTheLaw,
};

/// The deformations around rest that something holds for.
struct DeformationRange
{
  double lowest;  ///< where it ends below: 0 (stretch) or -infinity (shear) if it does not
  double highest; ///< where it ends above: infinity if it does not

  bool is_everywhere() const;
};

/// Searches from rest outwards, for stretches from 0.2 to 5 and shears from -5 to 5; what holds
/// that far is said to hold everywhere.
DeformationRange range_around_rest(Loading loading, const std::function<bool(double)>& holds);

/// Where the nominal stress grows with the deformation.
DeformationRange growing_range(const Law& law, Loading loading, Compressibility compressibility);

} // namespace f2b
