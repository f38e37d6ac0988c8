#pragma once

#include "Core/geometry/vectors.hpp"

/// Which functions make a surface over a triangle from its corners' positions and slopes, with a
/// continuous tangent plane (paper eq. 5)?
///
/// Nine degrees of freedom: at corner i, number 3 i is the value, 3 i + 1 the derivative along the
/// edge to corner i + 1 and 3 i + 2 along the edge to corner i + 2 (mod 3; the edge's parameter
/// runs from 0 to 1, so a slope has the unit of the value). With B = L1 L2 L3 the basic
/// interpolation N9 is (Bazeley, Cheung, Irons & Zienkiewicz 1965)
///   value_i = L_i^2 (3 - 2 L_i) + 2 B,   slope_ij = L_i^2 L_j + B / 2,
/// and N9* = N9 + sum_k 4 eps_k (Y_k - Z_k), for the edge opposite corner k, makes the slope across
/// an edge linear along it: eps_k = L_k L_i^2 L_j^2 / ((L_k + L_i) (L_k + L_j)), Y_k is the mean of
/// N9's slopes across the edge at its two ends and Z_k the slope at its middle, both along
/// grad L_k / |grad L_k|^2.
///
/// At edges and corners all values and first derivatives are continuous and are the limits from
/// inside. Second derivatives have no limit at a corner: integrate at interior points only.
namespace f2b
{

/// N9 (rows 0-8) and eps (rows 9-11): all that does not depend on the triangle's shape.
struct FaceFunctions
{
  static constexpr int count = 12;
  Eigen::Matrix<double, count, 1> value;
  /// d/dL_m, the three L taken as independent: along a direction whose L change at rates d (sum 0)
  /// the derivative is `slope * d`.
  Eigen::Matrix<double, count, 3> slope;
};

/// \param L  area coordinates, none < 0, sum 1; on edges and at corners the limits
FaceFunctions face_functions(const Vec3& L);

/// Row k: the amplitude 4 (Y_k - Z_k) of eps_k, as a function of the nine degrees of freedom.
using EdgeCorrection = Eigen::Matrix<double, 3, 9>;

/// \param corners  of the flat triangle in which 'across an edge' is meant, one per column [mm]
EdgeCorrection edge_correction(const Mat3& corners);

/// Values and derivatives of the nine functions of a triangle.
struct HermiteFunctions
{
  Eigen::Matrix<double, 9, 1> value;
  Eigen::Matrix<double, 9, 3> slope; ///< as in FaceFunctions
};

/// N9* for the triangle's correction; N9 with a zero correction.
HermiteFunctions hermite_functions(const EdgeCorrection& correction, const Vec3& L);

} // namespace f2b
