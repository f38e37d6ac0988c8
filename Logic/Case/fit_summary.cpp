#include "Case/fit_summary.hpp"

#include "Bridge/material_file.hpp"
#include "Core/material/stability.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

template <class... Values>
std::string print(const char* format, Values... values)
{
  char text[400];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

const char* deformation_name(Loading loading)
{
  return loading == Loading::SimpleShear ? "shear" : "stretch";
}

const char* test_name(Loading loading)
{
  return loading == Loading::Uniaxial      ? "uniaxial"
         : loading == Loading::Equibiaxial ? "equibiaxial"
                                           : "simple-shear";
}

/// How far the law with its own Poisson's ratio is from the incompressible fit [MPa].
std::optional<double> effect_of_compressibility(const FittedCurve& fit)
{
  double largest = 0;
  for (const double s : fit.curve.deformation)
  {
    const auto own = compressible_response(fit.fit.law, fit.curve.loading, s);
    if (!own)
      return std::nullopt;
    largest = std::max(
        largest,
        std::abs(own->stress - incompressible_response(fit.fit.law, fit.curve.loading, s).stress));
  }
  return largest;
}

std::string coefficient_lines(const Law& law)
{
  std::string text;
  const nlohmann::ordered_json entry = tissue_entry(law);
  for (const auto& [key, value] : entry.items())
    if (value.is_number() && key != "poisson_ratio")
      text += print("  %-16s %.7g kPa\n", key.c_str(), 1000 * value.get<double>());
  return text;
}

std::string stability_lines(const Law& law)
{
  std::string text;
  bool everywhere = true;
  for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial})
  {
    const DeformationRange grows = growing_range(law, loading, Compressibility::Incompressible);
    const DeformationRange guarded = guarded_range(law, loading);
    everywhere = everywhere && grows.is_everywhere() && guarded.is_everywhere();
    text += print("  %-16s stable at %s; simulations warn outside %s\n", test_name(loading),
                  range_words(grows, loading).c_str(), range_words(guarded, loading).c_str());
  }
  return everywhere ? print("  %-16s every stretch\n", "stable at") : text;
}

} // namespace

std::string range_words(const DeformationRange& range, Loading loading)
{
  const char* name = deformation_name(loading);
  const bool open_below = range.lowest == 0 || std::isinf(range.lowest);
  if (range.is_everywhere())
    return print("every %s", name);
  if (open_below)
    return print("%s %.4f and below", name, range.highest);
  if (std::isinf(range.highest))
    return print("%s %.4f and above", name, range.lowest);
  return print("%s %.4f to %.4f", name, range.lowest, range.highest);
}

std::string curve_description(const StressCurve& curve)
{
  const auto [low, high] = std::minmax_element(curve.deformation.begin(), curve.deformation.end());
  return print("%s test, %zu points, %s %.4g to %.4g", test_name(curve.loading),
               curve.deformation.size(), deformation_name(curve.loading), *low, *high);
}

std::string fit_summary(const FittedCurve& fit)
{
  const Law& law = fit.fit.law;
  const double largest = fit.curve.largest_stress();
  std::string text = fit.name + ": " + curve_description(fit.curve) + "\n";
  text += coefficient_lines(law);
  text += print("  %-16s %.4g kPa at rest\n", "shear modulus", 1000 * shear_modulus(law));
  text += print("  %-16s %.4g kPa, %.2g %% of the largest stress, %.4g kPa\n", "RMS residual",
                1000 * fit.fit.rms_residual, 100 * fit.fit.rms_residual / largest, 1000 * largest);
  text += print("  %-16s %.4g; the fit is incompressible", "Poisson's ratio", poisson_ratio(law));
  if (const auto effect = effect_of_compressibility(fit))
    text += print(", the law itself differs by up to %.2g kPa", 1000 * *effect);
  return text + "\n" + stability_lines(law);
}

} // namespace f2b
