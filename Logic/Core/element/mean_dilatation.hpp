#pragma once

#include "Core/element/quadrature_element.hpp"
#include "Core/material/law.hpp"

/// What is left to the points of an element that feels only the mean of its change of volume?
///
/// The cure of volumetric locking: a domain of volume V (a prism, or a patch of tetrahedra) has the
/// energy sum_q w_q psi_iso(F_q) + V U(d), d = sum_q w_q J_q / V. It is Nagtegaal, Parks & Rice
/// (CMAME 4 (1974) 153) in the energy form of Simo, Taylor & Pister (CMAME 51 (1985) 177). Its
/// second derivative is that of sum_q w_q (psi_iso + t J)(F_q) with the tension t = U'(d) held,
/// plus U''(d)/V g g^T with g = d(V d)/dx.
namespace f2b
{

/// A law as a function of shape plus a function U of dilatation.
template <class Law>
struct DilatationSplit;

template <class Isochoric>
struct DilatationSplit<Hyperelastic<Isochoric>>
{
  using Law = Hyperelastic<Isochoric>;

  static double dilatation(const Mat3& F) { return F.determinant(); }
  /// dJ/dF, the cofactors of F.
  static Mat3 dilatation_slope(const Mat3& F)
  {
    Mat3 cofactor;
    for (int i = 0; i < 3; ++i)
      cofactor.col(i) = F.col((i + 1) % 3).cross(F.col((i + 2) % 3));
    return cofactor;
  }
  static double volume_energy(const Law& law, double d) { return law.volumetric.energy(d); }
  static double volume_slope(const Law& law, double d) { return law.volumetric.slope(d); }
  static double volume_curvature(const Law& law, double d) { return law.volumetric.curvature(d); }

  /// Adds t d2J/dF2.
  static void add_dilatation_curvature(const Mat3& F, double t, Mat9& tangent)
  {
    // column i + 1 of the cofactors changes with column i by the cross product with column i + 2
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const Vec3 v = t * F.col((i + 2) % 3);
      Mat3 cross;
      cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
      tangent.template block<3, 3>(3 * j, 3 * i) += cross;
      tangent.template block<3, 3>(3 * i, 3 * j) -= cross;
    }
  }

  static double shape_energy(const Law& law, const Mat3& F) { return law.isochoric_energy(F); }
  static Mat3 shape_stress(const Law& law, const Mat3& F) { return law.isochoric_stress(F); }
  static Mat3 shape_stress(const Law& law, const Mat3& F, Mat9& tangent)
  {
    return law.isochoric_stress(F, tangent);
  }
};

/// The same for small strain: the mean of 1 + tr(e) stands for the mean of J.
template <>
struct DilatationSplit<LinearElastic>
{
  static double dilatation(const Mat3& F) { return F.trace() - 2; }
  static Mat3 dilatation_slope(const Mat3&) { return Mat3::Identity(); }
  static double volume_energy(const LinearElastic& law, double d)
  {
    return 0.5 * law.bulk_modulus * (d - 1) * (d - 1);
  }
  static double volume_slope(const LinearElastic& law, double d)
  {
    return law.bulk_modulus * (d - 1);
  }
  static double volume_curvature(const LinearElastic& law, double) { return law.bulk_modulus; }

  static void add_dilatation_curvature(const Mat3&, double, Mat9&) {}

  /// Without a bulk modulus, what remains is the energy of the deviatoric strain.
  static double shape_energy(const LinearElastic& law, const Mat3& F)
  {
    return shape(law).energy(F);
  }
  static Mat3 shape_stress(const LinearElastic& law, const Mat3& F) { return shape(law).stress(F); }
  static Mat3 shape_stress(const LinearElastic& law, const Mat3& F, Mat9& tangent)
  {
    return shape(law).stress(F, tangent);
  }

private:
  static LinearElastic shape(const LinearElastic& law) { return {law.shear_modulus, 0}; }
};

/// The law of a point whose domain feels the tension t: psi_iso(F) + t J(F), without t in `energy`.
template <class Law>
struct AveragedPoint
{
  using Split = DilatationSplit<Law>;
  const Law& law;
  double tension = 0; ///< [MPa]

  double energy(const Mat3& F) const { return Split::shape_energy(law, F); }
  Mat3 stress(const Mat3& F) const
  {
    return Split::shape_stress(law, F) + tension * Split::dilatation_slope(F);
  }
  Mat3 stress(const Mat3& F, Mat9& tangent) const
  {
    const Mat3 shape = Split::shape_stress(law, F, tangent);
    Split::add_dilatation_curvature(F, tension, tangent);
    return shape + tension * Split::dilatation_slope(F);
  }
};

/// Volume at rest [mm^3].
template <class Element>
double rest_volume(const Element& element)
{
  double volume = 0;
  for (const double part : element.volumes)
    volume += part;
  return volume;
}

/// Volume at x, by the law's measure of dilatation [mm^3].
template <class Law, class Element>
double dilated_volume(const Element& element, const typename Element::Positions& x)
{
  double volume = 0;
  for (std::size_t q = 0; q < Element::points; ++q)
    volume += element.volumes[q] * DilatationSplit<Law>::dilatation(x * element.gradients[q]);
  return volume;
}

/// Its derivative, one column per control vector [mm^2].
template <class Law, class Element>
typename Element::Positions dilated_volume_slope(const Element& element,
                                                 const typename Element::Positions& x)
{
  typename Element::Positions slope = Element::Positions::Zero();
  for (std::size_t q = 0; q < Element::points; ++q)
  {
    const auto& G = element.gradients[q];
    const Mat3 F = x * G;
    slope += element.volumes[q] * DilatationSplit<Law>::dilatation_slope(F) * G.transpose();
  }
  return slope;
}

} // namespace f2b
