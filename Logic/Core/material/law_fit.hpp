#pragma once

#include "Core/material/stress_curve.hpp"

#include <string>
#include <vector>

/// Which coefficients let a law follow measured stress best?
namespace f2b
{

/// One specimen's curve.
struct StressCurve
{
  std::string source; ///< what it is, for people
  Loading loading = Loading::Uniaxial;
  std::vector<double> deformation; ///< stretches, or amounts of shear
  std::vector<double> stress;      ///< nominal, as many [MPa]

  double largest_stress() const; ///< absolute [MPa]
};

enum class FittedLaw
{
  OneTermNeoHookean,
  TwoTermMooneyRivlin,
  ThreeTermYeoh,
};

struct FitOptions
{
  FittedLaw law = FittedLaw::ThreeTermYeoh;
  bool stable = false;         ///< every coefficient >= 0, so that every curve grows everywhere
  double poisson_ratio = 0.49; ///< of the law that comes out; the fit itself is incompressible
  VolumetricLaw::Kind volumetric = VolumetricLaw::Kind::Barrier;
};

struct LawFit
{
  Law law;
  double rms_residual = 0; ///< root of the mean square over the points [MPa]
};

/// Linear least squares on the nominal stress of incompressible matter, every point alike. The
/// laws are linear in their coefficients, so the minimum is exact; with `stable` it is the best
/// over all sets of coefficients that may be zero. Throws Error naming the source where the points
/// cannot tell the coefficients apart, or give no stiffness at rest.
LawFit fit_law(const StressCurve& data, const FitOptions& options);

/// A law's own incompressible curve at equal steps, as data to fit another law to.
StressCurve sampled_curve(const Law& law, Loading loading, double first, double last, int points);

} // namespace f2b
