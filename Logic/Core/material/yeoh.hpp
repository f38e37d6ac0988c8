#pragma once

#include "Core/geometry/vectors.hpp"

#include <cmath>
#include <limits>

/// What energy and stress does a tissue answer a deformation with?
namespace f2b
{

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Yeoh's law, deviatoric-volumetric split [MPa = N/mm^2]:
///
///   psi = c1 (I1b - 3) + c2 (I1b - 3)^2 + c3 (I1b - 3)^3 + K/4 (J^2 - 1 - 2 ln J)
///
/// with I1b = J^(-2/3) tr(F^T F). With c1 > 0 and c2, c3 >= 0 it is polyconvex; the volumetric term
/// is a barrier at J = 0. Neo-Hookean for c2 = c3 = 0. Reference: O. H. Yeoh, Rubber Chem. Technol.
/// 66 (1993) 754. Small-strain shear modulus 2 c1, bulk modulus K.
struct Yeoh
{
  double c1 = 0;           ///< > 0 [MPa]
  double c2 = 0;           ///< [MPa]
  double c3 = 0;           ///< [MPa]
  double bulk_modulus = 0; ///< K [MPa]

  double shear_modulus() const { return 2 * c1; }

  /// Bulk modulus of a material with a shear modulus [MPa] and Poisson's ratio in (-1, 0.5).
  static double bulk_from(double shear_modulus, double poisson_ratio)
  {
    return 2 * shear_modulus * (1 + poisson_ratio) / (3 * (1 - 2 * poisson_ratio));
  }

  /// Energy density [MPa]; infinite where det F <= 0.
  double energy(const Mat3& F) const
  {
    const double J = F.determinant();
    if (!(J > 0))
      return std::numeric_limits<double>::infinity();
    const double e = F.squaredNorm() / std::cbrt(J * J) - 3;
    return e * (c1 + e * (c2 + e * c3)) + 0.25 * bulk_modulus * (J * J - 1 - 2 * std::log(J));
  }

  /// First Piola-Kirchhoff stress dpsi/dF [MPa]; det F > 0.
  Mat3 stress(const Mat3& F) const
  {
    const Terms t(*this, F);
    return t.slope * t.dI + t.pressure_J * t.FinvT;
  }

  /// Stress and its derivative d vec(P) / d vec(F) (column-major vec, symmetric) [MPa]; det F > 0.
  Mat3 stress(const Mat3& F, Mat9& tangent) const
  {
    const Terms t(*this, F);
    using Vec9 = Eigen::Matrix<double, 9, 1>;
    const Vec9 dI = Eigen::Map<const Vec9>(t.dI.data());
    const Vec9 f = Eigen::Map<const Vec9>(F.data());
    const Vec9 g = Eigen::Map<const Vec9>(t.FinvT.data());
    const double scale = 1 / std::cbrt(t.J * t.J);

    tangent = t.curvature * dI * dI.transpose();
    tangent.diagonal().array() += t.slope * 2 * scale;
    const Mat9 cross = f * g.transpose();
    tangent -= t.slope * scale * (4.0 / 3.0) * (cross + cross.transpose());
    tangent +=
        (t.slope * scale * (4.0 / 9.0) * t.I1 + bulk_modulus * t.J * t.J) * (g * g.transpose());
    // d(F^-T) = -F^-T dF^T F^-T, from both the isochoric and the volumetric part
    const double twist = t.slope * scale * (2.0 / 3.0) * t.I1 - t.pressure_J;
    for (int l = 0; l < 3; ++l)
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i)
            tangent(i + 3 * j, k + 3 * l) += twist * t.FinvT(i, l) * t.FinvT(k, j);
    return t.slope * t.dI + t.pressure_J * t.FinvT;
  }

private:
  struct Terms
  {
    Terms(const Yeoh& m, const Mat3& F) : J(F.determinant()), I1(F.squaredNorm())
    {
      FinvT = F.inverse().transpose();
      const double scale = 1 / std::cbrt(J * J);
      const double e = scale * I1 - 3;
      slope = m.c1 + e * (2 * m.c2 + 3 * m.c3 * e);
      curvature = 2 * m.c2 + 6 * m.c3 * e;
      dI = scale * (2 * F - (2.0 / 3.0) * I1 * FinvT);
      pressure_J = 0.5 * m.bulk_modulus * (J * J - 1);
    }
    double J, I1;
    double slope;      ///< dpsi / dI1b
    double curvature;  ///< d2psi / dI1b^2
    double pressure_J; ///< J dU/dJ
    Mat3 FinvT, dI;
  };
};

} // namespace f2b
