#pragma once

#include <cmath>
#include <limits>

/// What does a change of volume cost?
namespace f2b
{

/// Energy density of the volume ratio J = det F [MPa]; infinite where J <= 0, whatever the kind, so
/// that a solver never accepts inverted matter. All have U(1) = U'(1) = 0 and U''(1) = K.
struct VolumetricLaw
{
  enum class Kind
  {
    Quadratic,   ///< K/2 (J - 1)^2: CalculiX and Abaqus, whose D1 is 2/K; finite down to J = 0
    Logarithmic, ///< K/2 (ln J)^2: FEBio; convex in J up to e only
    Barrier,     ///< K/4 (J^2 - 1 - 2 ln J): convex in J, infinite towards J = 0
  };

  Kind kind = Kind::Barrier;
  double bulk_modulus = 0; ///< K > 0 [MPa]

  double energy(double J) const
  {
    if (!(J > 0))
      return std::numeric_limits<double>::infinity();
    if (kind == Kind::Quadratic)
      return 0.5 * bulk_modulus * (J - 1) * (J - 1);
    const double log_J = std::log(J);
    return kind == Kind::Logarithmic ? 0.5 * bulk_modulus * log_J * log_J
                                     : 0.25 * bulk_modulus * (J * J - 1 - 2 * log_J);
  }

  /// dU/dJ, the pressure's negative [MPa]; J > 0.
  double slope(double J) const
  {
    if (kind == Kind::Quadratic)
      return bulk_modulus * (J - 1);
    return kind == Kind::Logarithmic ? bulk_modulus * std::log(J) / J
                                     : 0.5 * bulk_modulus * (J - 1 / J);
  }

  /// d2U/dJ2 [MPa]; J > 0.
  double curvature(double J) const
  {
    if (kind == Kind::Quadratic)
      return bulk_modulus;
    return kind == Kind::Logarithmic ? bulk_modulus * (1 - std::log(J)) / (J * J)
                                     : 0.5 * bulk_modulus * (1 + 1 / (J * J));
  }
};

} // namespace f2b
