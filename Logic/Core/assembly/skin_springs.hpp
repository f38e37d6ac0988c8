#pragma once

#include "Core/assembly/discretization.hpp"
#include "Core/assembly/element_loops.hpp"

/// What force pulls the skin towards its target (paper eq. 8 and 9)?
namespace f2b
{

/// Which position of the skin eq. 8 calls p0.
enum class VirtualLoad
{
  Following, ///< the current one: the pull dies away as the skin comes near its target
  Dead,      ///< the one at rest: a constant traction, evaluated once
};

/// Eq. 8, per area of skin: f_e = K_e (|p1 - p0| - L0) (p1 - p0) / |p1 - p0|.
///
/// As printed the equation points from the target p1 to the skin p0; a positive K_e is to pull the
/// skin to its target. With L0 > 0 the skin is pushed away where it is nearer than L0, and below
/// 1e-9 mm, where there is no direction, the force is zero. With L0 = 0 no direction is needed:
/// f_e = K_e (p1 - p0) everywhere.
struct VirtualForceLaw
{
  double stiffness_n_per_mm3 = 0; ///< K_e
  double rest_length_mm = 0;      ///< L0 >= 0
  VirtualLoad load = VirtualLoad::Following;
};

/// Energy, its gradient -f_e and its Hessian at one point of the skin, per area.
/// \param target  p1 less the rest position [mm]
/// \param u       displacement of the skin [mm]
double pull_energy(const VirtualForceLaw& law, const Vec3& target, const Vec3& u); ///< [N/mm]
Vec3 pull_gradient(const VirtualForceLaw& law, const Vec3& target, const Vec3& u); ///< [N/mm^2]
/// [N/mm^3]. The positive tangent leaves out what is negative across the direction of the pull.
Mat3 pull_hessian(const VirtualForceLaw& law, const Vec3& target, const Vec3& u, Tangent tangent);

/// The virtual external force on one prism's top face: eq. 9 with its integral taken on the
/// reference skin, whose vertices on that face each stand for an area.
///
/// A vertex moves by the skin's own shape functions N_a of the first `count` control vectors of the
/// prism's element, slopes included, so that the nodal forces sum_v a_v f_e N_a are consistent with
/// the element.
struct SkinSpring
{
  static constexpr int most = SkinWeights::most;
  using Controls = Eigen::Matrix<double, 3, most>; ///< columns from `count` on are zero
  using Weights = Eigen::Matrix<double, most, 1>;

  /// One vertex of the reference skin.
  struct Point
  {
    double area = 0;             ///< [mm^2]
    Vec3 target = Vec3::Zero();  ///< p1 less the rest position [mm]
    Weights N = Weights::Zero(); ///< shape functions
  };

  double energy(const VirtualForceLaw& law, const Controls& u) const;     ///< [N mm]
  Controls gradient(const VirtualForceLaw& law, const Controls& u) const; ///< [N]
  /// Adds N_a N_b times the Hessian to blocks of the lower triangle; `block(a, b)`, a >= b, is the
  /// address of a 3 x 3 block [N/mm].
  template <class Block>
  void add_hessian(const VirtualForceLaw& law, const Controls& u, Tangent tangent,
                   const Block& block) const;

  int prism = -1;
  int count = 0;
  std::vector<Point> points;
};

/// Springs to the targets `X_v + displacement_v`, one per prism that carries loaded vertices, in
/// the order of the prisms.
///
/// The finite-element skin's own rest position stands in for X_v, so that a zero displacement is
/// a zero force whatever the distance between the two skins.
/// \param displacement  target displacement per reference-skin vertex [mm]
/// \param area          loaded area per reference-skin vertex [mm^2], 0 where it is not loaded
std::vector<SkinSpring> make_skin_springs(const SkinInterpolation& skin,
                                          const std::vector<Vec3>& displacement,
                                          const std::vector<double>& area);

template <class Block>
void SkinSpring::add_hessian(const VirtualForceLaw& law, const Controls& u, Tangent tangent,
                             const Block& block) const
{
  for (const Point& point : points)
  {
    const Mat3 H = point.area * pull_hessian(law, point.target, u * point.N, tangent);
    for (int b = 0; b < count; ++b)
      for (int a = b; a < count; ++a)
        Eigen::Map<Mat3>(block(a, b)) += point.N[a] * point.N[b] * H;
  }
}

} // namespace f2b
