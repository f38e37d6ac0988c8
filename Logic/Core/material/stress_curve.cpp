#include "Core/material/stress_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace f2b
{
namespace
{

/// An invariant of incompressible matter, with its derivatives by the deformation.
struct InvariantCurve
{
  double value, first, second;
};

InvariantCurve first_invariant(Loading loading, double s)
{
  switch (loading)
  {
  case Loading::Uniaxial:
    return {s * s + 2 / s, 2 * s - 2 / (s * s), 2 + 4 / (s * s * s)};
  case Loading::Equibiaxial:
    return {2 * s * s + std::pow(s, -4), 4 * s - 4 * std::pow(s, -5), 4 + 20 * std::pow(s, -6)};
  default:
    return {3 + s * s, 2 * s, 2};
  }
}

InvariantCurve second_invariant(Loading loading, double s)
{
  switch (loading)
  {
  case Loading::Uniaxial:
    return {2 * s + 1 / (s * s), 2 - 2 / (s * s * s), 6 * std::pow(s, -4)};
  case Loading::Equibiaxial:
    return {std::pow(s, 4) + 2 / (s * s), 4 * s * s * s - 4 / (s * s * s),
            12 * s * s + 12 * std::pow(s, -4)};
  default:
    return {3 + s * s, 2 * s, 2};
  }
}

template <class Isochoric>
CurvePoint closed_form(const Hyperelastic<Isochoric>& law, Loading loading, double s)
{
  const Isochoric& W = law.isochoric;
  const InvariantCurve I1 = first_invariant(loading, s), I2 = second_invariant(loading, s);
  const double w1 = W.slope1(I1.value);
  // two directions do work in an equibiaxial test
  const double share = loading == Loading::Equibiaxial ? 0.5 : 1;
  return {share * (w1 * I1.first + W.slope2() * I2.first),
          share * (W.curvature1(I1.value) * I1.first * I1.first + w1 * I1.second +
                   W.slope2() * I2.second)};
}

CurvePoint closed_form(const LinearElastic& law, Loading loading, double s)
{
  const double modulus = law.shear_modulus * (loading == Loading::Uniaxial      ? 3
                                              : loading == Loading::Equibiaxial ? 6
                                                                                : 1);
  return {modulus * (s - rest_of(loading)), modulus};
}

/// How many of the three directions are pulled.
int pulled_directions(Loading loading)
{
  return loading == Loading::Uniaxial ? 1 : 2;
}

/// The free sides' stress and everything's slopes at a stretch s and a width w.
struct FreeSides
{
  double stress, side_stress;            ///< [MPa]
  double by_stretch, by_width;           ///< of the stress
  double side_by_stretch, side_by_width; ///< of the sides' stress
};

template <class OneLaw>
FreeSides free_sides(const OneLaw& law, int pulled, double s, double w)
{
  const Vec3 stretches(s, pulled == 2 ? s : w, w);
  Mat9 tangent;
  const Mat3 P = law.stress(stretches.asDiagonal().toDenseMatrix(), tangent);
  auto slope = [&](int of, bool by_width)
  {
    double sum = 0;
    for (int i = by_width ? pulled : 0; i < (by_width ? 3 : pulled); ++i)
      sum += tangent(4 * of, 4 * i);
    return sum;
  };
  return {P(0, 0), P(2, 2), slope(0, false), slope(0, true), slope(2, false), slope(2, true)};
}

/// Newton's method for the width, from that of matter which keeps its volume.
template <class OneLaw>
std::optional<CurvePoint> with_free_sides(const OneLaw& law, Loading loading, double s)
{
  const int pulled = pulled_directions(loading);
  double width = std::pow(s, pulled == 1 ? -0.5 : -2.0);
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    const FreeSides r = free_sides(law, pulled, s, width);
    const double step = -r.side_stress / r.side_by_width;
    if (!std::isfinite(step))
      return std::nullopt;
    if (std::abs(step) < 1e-13 * width)
      return CurvePoint{r.stress, r.by_stretch - r.by_width * r.side_by_stretch / r.side_by_width};
    width += std::clamp(step, -0.2 * width, 0.2 * width);
  }
  return std::nullopt;
}

/// Simple shear keeps the volume and lets no side move.
template <class OneLaw>
CurvePoint sheared(const OneLaw& law, double gamma)
{
  Mat3 F = Mat3::Identity();
  F(0, 1) = gamma;
  Mat9 tangent;
  const Mat3 P = law.stress(F, tangent);
  return {P(0, 1), tangent(3, 3)};
}

/// Where something first fails on the way from rest to `end`; nothing if it holds all the way.
std::optional<double> first_failure(const std::function<bool(double)>& holds, double rest,
                                    double end)
{
  const int steps = 4000;
  double inside = rest;
  for (int i = 1; i <= steps; ++i)
  {
    // stretches in equal ratios, shears in equal differences
    const double t = double(i) / steps;
    double outside = rest > 0 ? std::pow(end, t) : end * t;
    if (holds(outside))
    {
      inside = outside;
      continue;
    }
    for (int halving = 0; halving < 50; ++halving)
    {
      const double middle = 0.5 * (inside + outside);
      (holds(middle) ? inside : outside) = middle;
    }
    return inside;
  }
  return std::nullopt;
}

} // namespace

CurvePoint incompressible_response(const Law& law, Loading loading, double deformation)
{
  return std::visit([&](const auto& l) { return closed_form(l, loading, deformation); }, law);
}

std::optional<CurvePoint> compressible_response(const Law& law, Loading loading, double deformation)
{
  return std::visit(
      [&](const auto& l) -> std::optional<CurvePoint>
      {
        if (loading == Loading::SimpleShear)
          return sheared(l, deformation);
        return with_free_sides(l, loading, deformation);
      },
      law);
}

bool DeformationRange::is_everywhere() const
{
  return std::isinf(highest) && (lowest == 0 || std::isinf(lowest));
}

DeformationRange range_around_rest(Loading loading, const std::function<bool(double)>& holds)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool shear = loading == Loading::SimpleShear;
  const double rest = rest_of(loading);
  return {first_failure(holds, rest, shear ? -5 : 0.2).value_or(shear ? -infinity : 0),
          first_failure(holds, rest, 5).value_or(infinity)};
}

DeformationRange growing_range(const Law& law, Loading loading, Compressibility compressibility)
{
  return range_around_rest(loading,
                           [&](double s)
                           {
                             if (compressibility == Compressibility::Incompressible)
                               return incompressible_response(law, loading, s).slope > 0;
                             // sides that find no rest are a loss too
                             const auto response = compressible_response(law, loading, s);
                             return response && response->slope > 0;
                           });
}

} // namespace f2b
