#pragma once

#include "Core/geometry/vectors.hpp"
#include "Core/material/isochoric_laws.hpp"
#include "Core/material/volumetric_law.hpp"

#include <cmath>
#include <limits>

/// What energy and stress does a hyperelastic tissue answer a deformation gradient F with?
namespace f2b
{

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// psi(F) = W(I1b, I2b) + U(J) [MPa]: stress P = dpsi/dF is the first Piola-Kirchhoff stress, the
/// tangent d vec(P) / d vec(F) (column-major vec, symmetric). The isochoric part stands alone too,
/// for elements that take the volume from elsewhere. Stresses need det F > 0; energies are infinite
/// elsewhere. Derivatives of the invariants: J. Bonet & R. D. Wood, Nonlinear Continuum Mechanics
/// for Finite Element Analysis, 2nd ed., 2008, chapter 6.
template <class Isochoric>
struct Hyperelastic
{
  Isochoric isochoric;
  VolumetricLaw volumetric;

  double energy(const Mat3& F) const
  {
    const double J = F.determinant();
    return isochoric_energy(F, J) + volumetric.energy(J);
  }
  Mat3 stress(const Mat3& F) const
  {
    const State s(*this, F);
    return stress(F, s, s.J * volumetric.slope(s.J));
  }
  Mat3 stress(const Mat3& F, Mat9& tangent) const
  {
    const State s(*this, F);
    const double tension = s.J * volumetric.slope(s.J);
    return stress(F, s, tension, tension + s.J * s.J * volumetric.curvature(s.J), tangent);
  }

  double isochoric_energy(const Mat3& F) const { return isochoric_energy(F, F.determinant()); }
  Mat3 isochoric_stress(const Mat3& F) const { return stress(F, State(*this, F), 0); }
  Mat3 isochoric_stress(const Mat3& F, Mat9& tangent) const
  {
    return stress(F, State(*this, F), 0, 0, tangent);
  }

private:
  static constexpr bool second = Isochoric::uses_second_invariant;
  using Vec9 = Eigen::Matrix<double, 9, 1>;

  double isochoric_energy(const Mat3& F, double J) const
  {
    if (!(J > 0))
      return std::numeric_limits<double>::infinity();
    const double scale = 1 / std::cbrt(J * J), I1 = F.squaredNorm();
    double I2 = 3;
    if constexpr (second)
      I2 = 0.5 * (I1 * I1 - (F.transpose() * F).squaredNorm());
    return isochoric.energy(scale * I1, scale * scale * I2);
  }

  /// Invariants of F and the law's slopes there.
  struct State
  {
    State(const Hyperelastic& law, const Mat3& F)
        : J(F.determinant()), I1(F.squaredNorm()), scale1(1 / std::cbrt(J * J)),
          slope1(law.isochoric.slope1(scale1 * I1) * scale1), FinvT(F.inverse().transpose())
    {
      if constexpr (second)
      {
        C = F.transpose() * F;
        FC = F * C;
        I2 = 0.5 * (I1 * I1 - C.squaredNorm());
        slope2 = law.isochoric.slope2() * scale1 * scale1;
      }
    }
    /// Factor of F^-T in the stress, without the volumetric law's J U'.
    double isochoric_tension() const
    {
      double t = -(2.0 / 3.0) * slope1 * I1;
      if constexpr (second)
        t -= (4.0 / 3.0) * slope2 * I2;
      return t;
    }
    /// Factor of F in the stress.
    double stiffness() const { return second ? 2 * (slope1 + slope2 * I1) : 2 * slope1; }

    double J, I1;
    double scale1; ///< J^(-2/3)
    double slope1; ///< scale1 dW/dI1b
    Mat3 FinvT;
    double I2 = 3, slope2 = 0; ///< slope2 = J^(-4/3) dW/dI2b
    Mat3 C, FC;                ///< set only for a law that uses I2
  };

  /// \param tension  J dU/dJ
  Mat3 stress(const Mat3& F, const State& s, double tension) const
  {
    Mat3 P = s.stiffness() * F + (s.isochoric_tension() + tension) * s.FinvT;
    if constexpr (second)
      P -= (2 * s.slope2) * s.FC;
    return P;
  }

  /// \param volume_stiffness  J dU/dJ + J^2 d2U/dJ2
  Mat3 stress(const Mat3& F, const State& s, double tension, double volume_stiffness,
              Mat9& tangent) const
  {
    const Vec9 f = Eigen::Map<const Vec9>(F.data());
    const Vec9 g = Eigen::Map<const Vec9>(s.FinvT.data());
    Vec9 u = (-(4.0 / 3.0) * s.slope1) * f +
             (0.5 * volume_stiffness + (2.0 / 9.0) * s.slope1 * s.I1) * g;
    if constexpr (second)
      u += ((-8.0 / 3.0) * s.slope2) * (s.I1 * f - Eigen::Map<const Vec9>(s.FC.data())) +
           ((8.0 / 9.0) * s.slope2 * s.I2) * g;
    tangent.noalias() = u * g.transpose();
    tangent.noalias() += g * u.transpose();
    if constexpr (!Isochoric::is_linear)
    {
      const Vec9 slope = s.scale1 * (2 * f - ((2.0 / 3.0) * s.I1) * g);
      tangent.noalias() += (isochoric.curvature1(s.scale1 * s.I1) * slope) * slope.transpose();
    }
    tangent.diagonal().array() += s.stiffness();
    // d(F^-T) = -F^-T dF^T F^-T
    add_transposing(s.FinvT, -(s.isochoric_tension() + tension), tangent);
    if constexpr (second)
      add_second_invariant(F, f, s, tangent);
    return stress(F, s, tension);
  }

  /// Adds the map dF -> factor A dF^T A.
  static void add_transposing(const Mat3& A, double factor, Mat9& tangent)
  {
    for (int l = 0; l < 3; ++l)
    {
      const Vec3 scaled = factor * A.col(l);
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          tangent.template block<3, 1>(3 * j, k + 3 * l) += A(k, j) * scaled;
    }
  }

  /// Adds what I2's own curvature gives: dF -> slope2 (4 (F:dF) F - 2 (dF C + F F^T dF + F dF^T F)).
  static void add_second_invariant(const Mat3& F, const Vec9& f, const State& s, Mat9& tangent)
  {
    tangent.noalias() += (4 * s.slope2 * f) * f.transpose();
    const Mat3 B = (-2 * s.slope2) * (F * F.transpose());
    for (int l = 0; l < 3; ++l)
    {
      tangent.template block<3, 3>(3 * l, 3 * l) += B;
      for (int j = 0; j < 3; ++j)
        tangent.template block<3, 3>(3 * j, 3 * l).diagonal().array() -= 2 * s.slope2 * s.C(j, l);
    }
    add_transposing(F, -2 * s.slope2, tangent);
  }
};

using NeoHookean = Hyperelastic<IsochoricNeoHookean>;
using MooneyRivlin = Hyperelastic<IsochoricMooneyRivlin>;
using Yeoh = Hyperelastic<IsochoricYeoh>;

} // namespace f2b
