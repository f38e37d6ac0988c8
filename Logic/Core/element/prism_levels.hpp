#pragma once

#include "Core/element/level_point.hpp"

/// How does a single layer of prisms bend when a prism feels only its mean change of volume?
///
/// A prism's thickness is linear through its depth: it cannot swell on the inner side of a bend and
/// shrink on the outer one, as matter that keeps its volume does. Felt at every point, the volume
/// locks the bend; felt only in the mean it leaves the bend 3 to 9 times too soft. Therefore the
/// thickness strain gets the linear part that is missing, as in shells with seven parameters
/// (N. Buechter, E. Ramm, D. Roehl, Int. J. Numer. Meth. Engng 37 (1994) 2551), but instead of
/// being an unknown it is fixed by the volume: the two levels of quadrature points, upper and
/// lower, with mean dilatations m_1 and m_2, are stretched along the rest normal N by r_l = m/m_l,
/// so that both have the mean m. The energy, of which m's part is that of mean_dilatation.hpp, is
///   sum_q w_q psi_iso(F_q + (r_l - 1) F_q N N^T) + V U(m).
namespace f2b
{

/// What is asked of an element at one state?
enum class Asked
{
  Energy,
  Forces,
  Stiffness, ///< and forces
};

/// A prism's levels at a state: the law of its points, and the energy and stiffness beyond them.
///
/// The quadrature points' first half lies on one level, the second half on the other; the last
/// three control vectors are those of the lower face.
template <class Law, class Element, Asked asked>
class PrismLevels
{
public:
  using Positions = typename Element::Positions;
  using Split = DilatationSplit<Law>;

  PrismLevels(const Element& element, const Positions& x, const Law& law)
      : m_element(element), m_x(x), m_law(law)
  {
    measure();
    if constexpr (asked != Asked::Energy)
      find_tensions();
  }

  LevelPoint<Law> point(std::size_t q) const
  {
    const std::size_t l = level(q);
    const LevelStretch<Law> stretch(m_mean, m_level_mean[l]);
    if constexpr (asked == Asked::Stiffness)
      return {m_law, stretch, m_tension[l], m_normal, &m_shape[q]};
    return {m_law, stretch, m_tension[l], m_normal};
  }
  /// V U(m) [N mm]
  double volume_energy() const { return m_volume * Split::volume_energy(m_law, m_mean); }
  /// Adds what the changes of levels and mean bring to the stiffness of the points.
  void add_stiffness(double* stiffness) const;

private:
  static constexpr std::size_t half = Element::points / 2;
  static std::size_t level(std::size_t q) { return q / half; }
  void measure();
  void find_tensions();
  /// Weights of the products of the derivatives by x of m_1, m_2 and of the works of r_1, r_2.
  /// \param curvature  second derivatives of the energy by r_1 and r_2
  Eigen::Matrix4d coupling(const std::array<double, 2>& curvature) const;
  Eigen::Matrix2d stretch_slopes() const;

  const Element& m_element;
  const Positions& m_x;
  const Law& m_law;
  Vec3 m_normal; ///< one for the prism, else a constant stress would not be in balance
  double m_volume = 0, m_mean = 1;
  std::array<double, 2> m_level_volume{}, m_level_mean{};
  std::array<double, 2> m_work{};    ///< d sum w psi_iso / d r_l [N mm]
  std::array<double, 2> m_tension{}; ///< dW/dm_l over the level's volume [MPa]
  std::array<Mat3, Element::points> m_F;
  std::array<ShapeAnswer, asked == Asked::Stiffness ? Element::points : 0> m_shape;
};

template <class Law, class Element, Asked asked>
LevelPoint<Law> law_at(const PrismLevels<Law, Element, asked>& levels, std::size_t q,
                       const typename Element::Gradients&)
{
  return levels.point(q);
}

template <class Law, class Element, Asked asked>
void PrismLevels<Law, Element, asked>::measure()
{
  Vec3 depth_gradient = Vec3::Zero(); // the depth is the sum of the lower face's shape functions
  for (std::size_t q = 0; q < Element::points; ++q)
  {
    m_F[q] = m_x * m_element.gradients[q];
    m_level_volume[level(q)] += m_element.volumes[q];
    m_level_mean[level(q)] += m_element.volumes[q] * Split::dilatation(m_F[q]);
    depth_gradient += m_element.volumes[q] *
                      m_element.gradients[q].template bottomRows<3>().colwise().sum().transpose();
  }
  m_normal = depth_gradient.normalized();
  m_volume = m_level_volume[0] + m_level_volume[1];
  m_mean = (m_level_mean[0] + m_level_mean[1]) / m_volume;
  for (std::size_t l = 0; l < 2; ++l)
    m_level_mean[l] /= m_level_volume[l];
}

/// Row l: derivatives of r_l by m_1 and m_2, of which m is the weighted mean.
template <class Law, class Element, Asked asked>
Eigen::Matrix2d PrismLevels<Law, Element, asked>::stretch_slopes() const
{
  Eigen::Matrix2d slopes;
  for (int l = 0; l < 2; ++l)
  {
    const LevelStretch<Law> stretch(m_mean, m_level_mean[static_cast<std::size_t>(l)]);
    for (int k = 0; k < 2; ++k)
      slopes(l, k) = stretch.by_mean * m_level_volume[static_cast<std::size_t>(k)] / m_volume +
                     (l == k ? stretch.by_level : 0);
  }
  return slopes;
}

template <class Law, class Element, Asked asked>
void PrismLevels<Law, Element, asked>::find_tensions()
{
  for (std::size_t q = 0; q < Element::points; ++q)
  {
    const LevelStretch<Law> stretch(m_mean, m_level_mean[level(q)]);
    const Mat3 stretched = stretch.apply(m_F[q], m_normal);
    Mat3 P;
    if constexpr (asked == Asked::Stiffness)
      P = m_shape[q].stress = Split::shape_stress(m_law, stretched, m_shape[q].tangent);
    else
      P = Split::shape_stress(m_law, stretched);
    m_work[level(q)] +=
        m_element.volumes[q] * P.cwiseProduct(stretch.slope(m_F[q], m_normal)).sum();
  }
  const Eigen::Matrix2d slopes = stretch_slopes();
  for (std::size_t k = 0; k < 2; ++k)
  {
    const auto column = static_cast<Eigen::Index>(k);
    const double by_stretch = m_work[0] * slopes(0, column) + m_work[1] * slopes(1, column);
    m_tension[k] = Split::volume_slope(m_law, m_mean) + by_stretch / m_level_volume[k];
  }
}

template <class Law, class Element, Asked asked>
Eigen::Matrix4d
PrismLevels<Law, Element, asked>::coupling(const std::array<double, 2>& curvature) const
{
  const Eigen::Matrix2d R = stretch_slopes();
  const Eigen::Vector2d share(m_level_volume[0] / m_volume, m_level_volume[1] / m_volume);
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
  M.topLeftCorner<2, 2>() =
      m_volume * Split::volume_curvature(m_law, m_mean) * share * share.transpose();
  for (int l = 0; l < 2; ++l)
  {
    const auto i = static_cast<std::size_t>(l);
    const LevelStretch<Law> stretch(m_mean, m_level_mean[i]);
    M.topLeftCorner<2, 2>() += curvature[i] * R.row(l).transpose() * R.row(l);
    M.row(l).head<2>() += m_work[i] * stretch.by_mean_level * share.transpose();
    M.col(l).head<2>() += m_work[i] * stretch.by_mean_level * share;
    M(l, l) += m_work[i] * stretch.by_level_level;
  }
  M.topRightCorner<2, 2>() = R.transpose();
  M.bottomLeftCorner<2, 2>() = R;
  return M;
}

template <class Law, class Element, Asked asked>
void PrismLevels<Law, Element, asked>::add_stiffness(double* stiffness) const
{
  using Vec9 = Eigen::Matrix<double, 9, 1>;
  constexpr int n = Element::corners;
  // derivatives by x of m_1, m_2 and of the works at held r_1, r_2
  std::array<Positions, 4> by_x;
  by_x.fill(Positions::Zero());
  std::array<double, 2> curvature{}; // of the energy by r_l
  for (std::size_t q = 0; q < Element::points; ++q)
  {
    const std::size_t l = level(q);
    const double volume = m_element.volumes[q];
    const auto& G = m_element.gradients[q];
    const Mat3& F = m_F[q];
    const LevelPoint<Law> at = point(q);
    const Mat3& P = m_shape[q].stress;
    const Mat3 slope = at.stretch.slope(F, at.normal);
    Mat3 change; // of P with r_l
    Eigen::Map<Vec9>(change.data()) = m_shape[q].tangent * Eigen::Map<const Vec9>(slope.data());
    curvature[l] += volume * change.cwiseProduct(slope).sum();
    by_x[l] += volume / m_level_volume[l] * Split::dilatation_slope(F) * G.transpose();
    by_x[l + 2] +=
        volume *
        (at.stretch.slope_of_work(P, at.normal) + at.stretch.pull_back(change, at.normal)) *
        G.transpose();
  }
  const Eigen::Matrix4d M = coupling(curvature);
  std::array<Eigen::Matrix<double, 3, 4>, n> of_control;
  for (std::size_t a = 0; a < n; ++a)
    for (int i = 0; i < 4; ++i)
      of_control[a].col(i) = by_x[static_cast<std::size_t>(i)].col(static_cast<Eigen::Index>(a));
  for (int b = 0; b < n; ++b)
  {
    const Eigen::Matrix<double, 4, 3> weighted =
        M.lazyProduct(of_control[static_cast<std::size_t>(b)].transpose());
    for (int a = b; a < n; ++a)
      Eigen::Map<Mat3>(stiffness + 9 * block_index(n, a, b)) +=
          of_control[static_cast<std::size_t>(a)].lazyProduct(weighted);
  }
}

} // namespace f2b
