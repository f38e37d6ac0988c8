#include "Core/models/mass_tensors.hpp"

#include "Core/element/quadrature_element.hpp"

#include <algorithm>
#include <cassert>

namespace f2b
{
namespace
{

/// Shape-function gradients and volume of a tetrahedron, and Lame's constants of its tissue.
struct ElasticTet
{
  ElasticTet(const MixedMesh& mesh, std::size_t tet, const MaterialSet& materials)
  {
    Tet4::Positions X;
    for (std::size_t a = 0; a < 4; ++a)
      X.col(static_cast<Eigen::Index>(a)) = mesh.X[static_cast<std::size_t>(mesh.tets[tet][a])];
    const Tet4 element = make_tet4(X);
    gradients = element.gradients[0];
    volume = element.volumes[0];
    const Law& law = materials.of(mesh.tet_tissue[tet]);
    mu = shear_modulus(law);
    lambda = bulk_modulus(law) - 2 * mu / 3;
  }
  Mat3 tensor(int i, int j) const
  {
    const Vec3 gi = gradients.row(i), gj = gradients.row(j);
    return volume * (lambda * gi * gj.transpose() + mu * gj * gi.transpose() +
                     mu * gi.dot(gj) * Mat3::Identity());
  }

  Tet4::Gradients gradients;
  double volume, mu, lambda;
};

} // namespace

MassTensors::MassTensors(const MixedMesh& mesh, const MaterialSet& materials)
    : m_vertex(mesh.X.size(), Mat3::Zero())
{
  assert(mesh.prisms.empty());
  std::vector<std::vector<int>> neighbours(mesh.X.size());
  for (const auto& tet : mesh.tets)
    for (const int i : tet)
      for (const int j : tet)
        if (i != j)
          neighbours[static_cast<std::size_t>(i)].push_back(j);
  m_first_edge.push_back(0);
  for (auto& of_vertex : neighbours)
  {
    std::sort(of_vertex.begin(), of_vertex.end());
    of_vertex.erase(std::unique(of_vertex.begin(), of_vertex.end()), of_vertex.end());
    m_neighbour.insert(m_neighbour.end(), of_vertex.begin(), of_vertex.end());
    m_first_edge.push_back(m_neighbour.size());
  }
  m_edge.assign(m_neighbour.size(), Mat3::Zero());
  auto edge = [&](int i, int j) -> Mat3&
  {
    const auto first =
        m_neighbour.begin() + static_cast<long>(m_first_edge[static_cast<std::size_t>(i)]);
    const auto last =
        m_neighbour.begin() + static_cast<long>(m_first_edge[static_cast<std::size_t>(i) + 1]);
    return m_edge[static_cast<std::size_t>(std::lower_bound(first, last, j) - m_neighbour.begin())];
  };
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
  {
    const ElasticTet tet(mesh, t, materials);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
      {
        const int i = mesh.tets[t][static_cast<std::size_t>(a)];
        const int j = mesh.tets[t][static_cast<std::size_t>(b)];
        (a == b ? m_vertex[static_cast<std::size_t>(i)] : edge(i, j)) += tet.tensor(a, b);
      }
  }
}

void MassTensors::forces(const std::vector<Vec3>& u, std::vector<Vec3>& f) const
{
  const long count = static_cast<long>(m_vertex.size());
  f.resize(m_vertex.size());
#pragma omp parallel for schedule(static)
  for (long n = 0; n < count; ++n)
  {
    const auto i = static_cast<std::size_t>(n);
    Vec3 sum = m_vertex[i] * u[i];
    for (std::size_t e = m_first_edge[i]; e < m_first_edge[i + 1]; ++e)
      sum += m_edge[e] * u[static_cast<std::size_t>(m_neighbour[e])];
    f[i] = sum;
  }
}

} // namespace f2b
