#pragma once

#include "Core/assembly/discretization.hpp"

/// What force pulls the skin towards its target (paper eq. 8 and 9)?
namespace f2b
{

/// The virtual external force of one prism's top face, with L0 = 0 and the following position:
/// energy 1/2 K_e sum_v a_v |sum_i b_vi q_i - p1_v|^2 over the reference-skin vertices on it, with
/// the weights b of the skin's own shape functions on the first `count` control vectors q of the
/// prism's element: consistent with the element, slopes included.
///
/// This is eq. 9 with its integral taken on the reference skin, whose vertices carry an area a_v.
struct SkinSpring
{
  static constexpr int most = SkinWeights::most;

  int prism = -1;
  int count = 0;
  Eigen::Matrix<double, most, most> mass; ///< sum_v a_v b_vi b_vj [mm^2]
  Eigen::Matrix<double, 3, most> pull;    ///< column i: sum_v a_v b_vi p1_v [mm^3]
  double offset = 0;                      ///< sum_v a_v |p1_v|^2 [mm^4]
};

/// Springs to the targets `X_v + displacement_v`, one per prism that carries loaded vertices.
///
/// The finite-element skin's own rest position stands in for X_v, so that a zero displacement is
/// a zero force whatever the distance between the two skins.
/// \param displacement  target displacement per reference-skin vertex [mm]
/// \param area          loaded area per reference-skin vertex [mm^2], 0 where it is not loaded
std::vector<SkinSpring> make_skin_springs(const Discretization& tissue,
                                          const SkinInterpolation& skin,
                                          const std::vector<Vec3>& displacement,
                                          const std::vector<double>& area);

} // namespace f2b
