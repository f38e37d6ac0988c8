#pragma once

#include "Core/element/quadrature_element.hpp"
#include "Core/element/triangle_rule.hpp"
#include "Core/material/hyperelastic.hpp"
#include "Core/mesh/smooth_skin.hpp"

#include <Eigen/LU>

/// Small problems with smooth prisms, assembled without the sparse machinery under test.
namespace f2b::testing
{

/// Poisson's ratio 0.4.
inline NeoHookean test_law()
{
  return {{0.01}, {VolumetricLaw::Kind::Logarithmic, 0.0933}};
}

/// Stiffness of an element as a full matrix [N/mm].
template <class Element>
Eigen::MatrixXd full_stiffness(const Element& element, const typename Element::Positions& x,
                               const NeoHookean& law)
{
  constexpr int n = Element::corners;
  std::vector<double> blocks(9 * block_count(n));
  (void)element_forces(element, x, law, blocks.data());
  Eigen::MatrixXd K(3 * n, 3 * n);
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
    {
      const Eigen::Map<const Mat3> block(&blocks[std::size_t(9 * block_index(n, a, b))]);
      K.block<3, 3>(3 * a, 3 * b) = block;
      K.block<3, 3>(3 * b, 3 * a) = block.transpose();
    }
  return K;
}

/// Tetrahedra and smooth prisms of a mesh, one law, all control vectors in one dense matrix.
template <class Prism>
class DenseModel
{
public:
  using MakePrism = Prism (*)(const SmoothPrism::Positions&, const FaceMap&);

  DenseModel(const SmoothSkin& skin, MakePrism make) : m_mesh(skin.mesh())
  {
    const std::vector<Vec3> rest = skin.rest();
    m_size = 3 * static_cast<long>(rest.size());
    for (const auto& tet : m_mesh.tets)
      m_tets.push_back(make_tet4(gathered<Tet4>(rest, tet)));
    for (int p = 0; p < static_cast<int>(m_mesh.prisms.size()); ++p)
    {
      m_controls.push_back(skin.controls(p));
      m_prisms.push_back(make(gathered<Prism>(rest, m_controls.back()), skin.face_map(p)));
    }
  }

  double energy(const std::vector<Vec3>& x) const
  {
    double sum = 0;
    for (std::size_t e = 0; e < m_tets.size(); ++e)
      sum += element_energy(m_tets[e], gathered<Tet4>(x, m_mesh.tets[e]), m_law);
    return sum + prism_energy(x);
  }
  double prism_energy(const std::vector<Vec3>& x) const
  {
    double sum = 0;
    for (std::size_t e = 0; e < m_prisms.size(); ++e)
      sum += element_energy(m_prisms[e], gathered<Prism>(x, m_controls[e]), m_law);
    return sum;
  }

  /// Out-of-balance forces, and the stiffness where one is wanted.
  Eigen::VectorXd forces(const std::vector<Vec3>& x, Eigen::MatrixXd* stiffness = nullptr) const
  {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(m_size);
    if (stiffness)
      stiffness->setZero(m_size, m_size);
    for (std::size_t e = 0; e < m_tets.size(); ++e)
      add(m_tets[e], m_mesh.tets[e], x, f, stiffness);
    for (std::size_t e = 0; e < m_prisms.size(); ++e)
      add(m_prisms[e], m_controls[e], x, f, stiffness);
    return f;
  }

  /// Newton's method at the given load on all control vectors; held ones stay. Returns the last
  /// step's largest entry.
  double solve(std::vector<Vec3>& x, const std::vector<char>& held, const Eigen::VectorXd& load,
               int iterations = 12) const
  {
    double step_size = 0;
    for (int iteration = 0; iteration < iterations; ++iteration)
    {
      Eigen::MatrixXd K;
      Eigen::VectorXd r = load - forces(x, &K);
      for (std::size_t c = 0; c < held.size(); ++c)
        if (held[c])
          for (long i = 3 * static_cast<long>(c); i < 3 * static_cast<long>(c) + 3; ++i)
          {
            K.row(i).setZero();
            K.col(i).setZero();
            K(i, i) = 1;
            r[i] = 0;
          }
      const Eigen::VectorXd step = Eigen::PartialPivLU<Eigen::MatrixXd>(K).solve(r);
      for (std::size_t c = 0; c < x.size(); ++c)
        x[c] += step.segment<3>(3 * static_cast<long>(c));
      step_size = step.cwiseAbs().maxCoeff();
      if (step_size < 1e-13)
        break;
    }
    return step_size;
  }

  /// Largest deviation of the stress from a constant one, over all quadrature points [MPa].
  double stress_deviation(const std::vector<Vec3>& x, const Mat3& expected) const
  {
    double worst = 0;
    auto look = [&](const auto& element, const auto& positions)
    {
      for (const auto& G : element.gradients)
        worst = std::max(worst, (m_law.stress(positions * G) - expected).cwiseAbs().maxCoeff());
    };
    for (std::size_t e = 0; e < m_tets.size(); ++e)
      look(m_tets[e], gathered<Tet4>(x, m_mesh.tets[e]));
    for (std::size_t e = 0; e < m_prisms.size(); ++e)
      look(m_prisms[e], gathered<Prism>(x, m_controls[e]));
    return worst;
  }

  const std::vector<Prism>& prisms() const { return m_prisms; }
  const NeoHookean& law() const { return m_law; }

  template <class Element, std::size_t N>
  static typename Element::Positions gathered(const std::vector<Vec3>& x,
                                              const std::array<int, N>& controls)
  {
    typename Element::Positions p;
    for (std::size_t i = 0; i < N; ++i)
      p.col(static_cast<Eigen::Index>(i)) = x[static_cast<std::size_t>(controls[i])];
    return p;
  }

private:
  template <class Element, std::size_t N>
  void add(const Element& element, const std::array<int, N>& controls, const std::vector<Vec3>& x,
           Eigen::VectorXd& f, Eigen::MatrixXd* stiffness) const
  {
    const auto positions = gathered<Element>(x, controls);
    const typename Element::Positions of_element = element_forces(element, positions, m_law);
    const Eigen::MatrixXd K =
        stiffness ? full_stiffness(element, positions, m_law) : Eigen::MatrixXd();
    for (std::size_t a = 0; a < N; ++a)
    {
      const auto i = static_cast<Eigen::Index>(a);
      f.segment<3>(3 * controls[a]) += of_element.col(i);
      for (std::size_t b = 0; stiffness && b < N; ++b)
        stiffness->block<3, 3>(3 * controls[a], 3 * controls[b]) +=
            K.block<3, 3>(3 * i, 3 * static_cast<Eigen::Index>(b));
    }
  }

  const MixedMesh& m_mesh;
  NeoHookean m_law = test_law();
  long m_size = 0;
  std::vector<Tet4> m_tets;
  std::vector<Prism> m_prisms;
  std::vector<std::array<int, 12>> m_controls;
};

/// Load of a constant nominal stress P on the face: integral of N_a P n dA per control vector, by a
/// rule of its own (864 points a prism).
inline Eigen::VectorXd face_traction(const SmoothSkin& skin, const Mat3& P)
{
  static const auto rule = corner_graded_rule(12);
  const std::vector<Vec3> rest = skin.rest();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<long>(rest.size()));
  for (int p = 0; p < static_cast<int>(skin.mesh().prisms.size()); ++p)
  {
    const auto controls = skin.controls(p);
    Eigen::Matrix<double, 3, 9> Q;
    for (std::size_t i = 0; i < 9; ++i)
      Q.col(static_cast<Eigen::Index>(i)) = rest[static_cast<std::size_t>(controls[i])];
    const FaceMap map = skin.face_map(p);
    for (const TrianglePoint& at : rule)
    {
      const FaceFunctions f = face_functions(at.L);
      const Eigen::Matrix<double, 9, 1> N = map * f.value;
      const Mat3 slope = Q * (map * f.slope);
      const Vec3 along = slope.col(1) - slope.col(0), across = slope.col(2) - slope.col(0);
      const Vec3 traction = 0.5 * at.weight * P * along.cross(across);
      for (std::size_t i = 0; i < 9; ++i)
        load.segment<3>(3 * controls[i]) += N[static_cast<Eigen::Index>(i)] * traction;
    }
  }
  return load;
}

} // namespace f2b::testing
