#pragma once

#include "Core/material/hyperelastic.hpp"

/// What energy and stress does Hooke's law of small strain answer a deformation gradient F with?
namespace f2b
{

/// psi = mu e:e + (K/2 - mu/3) tr(e)^2 with e = (F + F^T)/2 - 1 [MPa]. Finite for every F, inverted
/// matter included; rotations are strains to it, so it is for small movements and for comparison.
struct LinearElastic
{
  double shear_modulus = 0; ///< mu > 0 [MPa]
  double bulk_modulus = 0;  ///< K > 0 [MPa]

  double energy(const Mat3& F) const
  {
    const Mat3 e = strain(F);
    return shear_modulus * e.squaredNorm() + 0.5 * lame() * e.trace() * e.trace();
  }
  Mat3 stress(const Mat3& F) const
  {
    const Mat3 e = strain(F);
    return 2 * shear_modulus * e + lame() * e.trace() * Mat3::Identity();
  }
  Mat3 stress(const Mat3& F, Mat9& tangent) const
  {
    tangent = shear_modulus * Mat9::Identity();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        tangent(i + 3 * j, j + 3 * i) += shear_modulus;
        tangent(4 * i, 4 * j) += lame();
      }
    return stress(F);
  }

private:
  static Mat3 strain(const Mat3& F) { return 0.5 * (F + F.transpose()) - Mat3::Identity(); }
  double lame() const { return bulk_modulus - (2.0 / 3.0) * shear_modulus; }
};

} // namespace f2b
