#pragma once

#include "Core/element/mean_dilatation.hpp"

#include <limits>

/// What does a point of a prism feel whose level is stretched along the rest normal N, so that its
/// mean dilatation becomes the prism's (prism_levels.hpp)?
namespace f2b
{

/// The stretch of a level, a function of the prism's and the level's mean dilatations.
template <class Law>
struct LevelStretch;

template <class Isochoric>
struct LevelStretch<Hyperelastic<Isochoric>>
{
  LevelStretch(double mean, double level)
      : value(mean / level), by_mean(1 / level), by_level(-mean / (level * level)),
        by_mean_level(-1 / (level * level)), by_level_level(2 * mean / (level * level * level))
  {
  }
  double value;
  double by_mean, by_level, by_mean_level, by_level_level;

  static bool admissible(const Mat3& F) { return F.determinant() > 0; }
  Mat3 apply(const Mat3& F, const Vec3& N) const
  {
    return F + ((value - 1) * F * N) * N.transpose();
  }
  /// d apply(F) / d value
  static Mat3 slope(const Mat3& F, const Vec3& N) { return (F * N) * N.transpose(); }
  /// What a change of F does to P : slope(F) while P is held.
  static Mat3 slope_of_work(const Mat3& P, const Vec3& N) { return (P * N) * N.transpose(); }
  /// Adjoint of F -> apply(F).
  Mat3 pull_back(const Mat3& P, const Vec3& N) const
  {
    return P + ((value - 1) * P * N) * N.transpose();
  }
  /// The same on both sides of d vec(P) / d vec(F).
  void pull_back(Mat9& tangent, const Vec3& N) const
  {
    Eigen::Matrix<double, 9, 3> across; // tangent (N x 1)
    across = tangent.leftCols<3>() * N[0] + tangent.middleCols<3>(3) * N[1] +
             tangent.rightCols<3>() * N[2];
    for (int k = 0; k < 3; ++k)
      tangent.middleCols<3>(3 * k) += (value - 1) * N[k] * across;
    Eigen::Matrix<double, 3, 9> down;
    down = tangent.topRows<3>() * N[0] + tangent.middleRows<3>(3) * N[1] +
           tangent.bottomRows<3>() * N[2];
    for (int k = 0; k < 3; ++k)
      tangent.middleRows<3>(3 * k) += (value - 1) * N[k] * down;
  }
};

/// For small strain the levels are strained by m - m_l.
template <>
struct LevelStretch<LinearElastic>
{
  LevelStretch(double mean, double level) : value(mean - level) {}
  double value;
  static constexpr double by_mean = 1, by_level = -1, by_mean_level = 0, by_level_level = 0;

  static bool admissible(const Mat3&) { return true; }
  Mat3 apply(const Mat3& F, const Vec3& N) const { return F + value * N * N.transpose(); }
  static Mat3 slope(const Mat3&, const Vec3& N) { return N * N.transpose(); }
  static Mat3 slope_of_work(const Mat3&, const Vec3&) { return Mat3::Zero(); }
  static Mat3 pull_back(const Mat3& P, const Vec3&) { return P; }
  static void pull_back(Mat9&, const Vec3&) {}
};

/// What the stretched state of a point answers with: the stress of its shape, and its tangent.
struct ShapeAnswer
{
  Mat3 stress;
  Mat9 tangent;
};

/// The law of a point on a stretched level that feels a tension on its dilatation.
template <class Law>
struct LevelPoint
{
  using Split = DilatationSplit<Law>;
  const Law& law;
  LevelStretch<Law> stretch;
  double tension; ///< [MPa]
  Vec3 normal;
  const ShapeAnswer* shape = nullptr; ///< if it is known already

  double energy(const Mat3& F) const
  {
    if (!stretch.admissible(F))
      return std::numeric_limits<double>::infinity();
    return Split::shape_energy(law, stretch.apply(F, normal));
  }
  Mat3 stress(const Mat3& F) const
  {
    const Mat3 P = Split::shape_stress(law, stretch.apply(F, normal));
    return stretch.pull_back(P, normal) + tension * Split::dilatation_slope(F);
  }
  Mat3 stress(const Mat3& F, Mat9& tangent) const
  {
    Mat3 P;
    if (shape)
    {
      P = shape->stress;
      tangent = shape->tangent;
    }
    else
      P = Split::shape_stress(law, stretch.apply(F, normal), tangent);
    stretch.pull_back(tangent, normal);
    Split::add_dilatation_curvature(F, tension, tangent);
    return stretch.pull_back(P, normal) + tension * Split::dilatation_slope(F);
  }
};

} // namespace f2b
