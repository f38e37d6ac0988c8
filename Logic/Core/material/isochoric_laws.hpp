#pragma once

/// What does a change of shape cost?
///
/// Each law is W(I1b, I2b) [MPa] of the first two invariants of C = F^T F made free of volume,
/// I1b = J^(-2/3) I1 and I2b = J^(-4/3) I2, and says at compile time which derivatives it has:
/// all here are linear in I2b and have no mixed term. At rest I1b = I2b = 3 and W = 0; the
/// small-strain shear modulus is 2 (dW/dI1b + dW/dI2b).
namespace f2b
{

/// W = c10 (I1b - 3). Reference: L. R. G. Treloar, Trans. Faraday Soc. 39 (1943) 241.
struct IsochoricNeoHookean
{
  static constexpr bool uses_second_invariant = false;
  static constexpr bool is_linear = true; ///< in I1b

  double c10 = 0; ///< > 0 [MPa]

  double energy(double I1b, double /*I2b*/) const { return c10 * (I1b - 3); }
  double slope1(double /*I1b*/) const { return c10; }   ///< dW/dI1b
  double slope2() const { return 0; }                   ///< dW/dI2b
  double curvature1(double /*I1b*/) const { return 0; } ///< d2W/dI1b2
  double shear_modulus() const { return 2 * c10; }
};

/// W = c10 (I1b - 3) + c01 (I2b - 3), the paper's eq. 2. With c01 < 0, as in its Table 1, the law
/// is unstable outside small strain (see stability.hpp).
/// References: M. Mooney, J. Appl. Phys. 11 (1940) 582; R. S. Rivlin, Phil. Trans. R. Soc. A 241
/// (1948) 379.
struct IsochoricMooneyRivlin
{
  static constexpr bool uses_second_invariant = true;
  static constexpr bool is_linear = true;

  double c10 = 0; ///< [MPa]
  double c01 = 0; ///< [MPa]; c10 + c01 > 0

  double energy(double I1b, double I2b) const { return c10 * (I1b - 3) + c01 * (I2b - 3); }
  double slope1(double /*I1b*/) const { return c10; }
  double slope2() const { return c01; }
  double curvature1(double /*I1b*/) const { return 0; }
  double shear_modulus() const { return 2 * (c10 + c01); }
};

/// W = c1 (I1b - 3) + c2 (I1b - 3)^2 + c3 (I1b - 3)^3. With c1 > 0 and c2, c3 >= 0 it is
/// polyconvex. Reference: O. H. Yeoh, Rubber Chem. Technol. 66 (1993) 754.
struct IsochoricYeoh
{
  static constexpr bool uses_second_invariant = false;
  static constexpr bool is_linear = false;

  double c1 = 0; ///< > 0 [MPa]
  double c2 = 0; ///< [MPa]
  double c3 = 0; ///< [MPa]

  double energy(double I1b, double /*I2b*/) const
  {
    const double e = I1b - 3;
    return e * (c1 + e * (c2 + e * c3));
  }
  double slope1(double I1b) const { return c1 + (I1b - 3) * (2 * c2 + 3 * c3 * (I1b - 3)); }
  double slope2() const { return 0; }
  double curvature1(double I1b) const { return 2 * c2 + 6 * c3 * (I1b - 3); }
  double shear_modulus() const { return 2 * c1; }
};

} // namespace f2b
