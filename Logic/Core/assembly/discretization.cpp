#include "Core/assembly/discretization.hpp"

namespace f2b
{

Discretization::Discretization(const MixedMesh& mesh, ElementScheme scheme)
    : m_mesh(mesh), m_scheme(scheme), m_rest(mesh.X)
{
  if (scheme.skin != SkinElement::Smooth)
    return;
  m_smooth = std::make_shared<const SmoothSkin>(mesh);
  m_rest = m_smooth->rest();
}

int Discretization::node_of(std::size_t control) const
{
  const std::size_t nodes = m_mesh.X.size();
  return control < nodes ? static_cast<int>(control)
                         : m_smooth->tangents()[(control - nodes) / 2].node;
}

std::vector<char> Discretization::control_flags(const std::vector<char>& node_flags) const
{
  std::vector<char> flags = node_flags;
  if (m_smooth)
    for (const SkinTangents& tangents : m_smooth->tangents())
      flags.insert(flags.end(), 2, node_flags[static_cast<std::size_t>(tangents.node)]);
  return flags;
}

SkinWeights Discretization::skin_weights(const SkinPlace& place) const
{
  SkinWeights point;
  if (place.prism < 0)
    return point;
  point.prism = place.prism;
  if (m_smooth)
  {
    const SurfaceWeights smooth = m_smooth->surface_weights(place.prism, place.weights);
    point.count = SkinWeights::most;
    point.control = smooth.control;
    Eigen::Map<Eigen::Matrix<double, 9, 1>>(point.weight.data()) = smooth.weight;
    return point;
  }
  point.count = 3;
  for (std::size_t i = 0; i < 3; ++i)
  {
    point.control[i] = m_mesh.prisms[static_cast<std::size_t>(place.prism)][i];
    point.weight[i] = place.weights[static_cast<Eigen::Index>(i)];
  }
  return point;
}

SkinInterpolation::SkinInterpolation(const Discretization& tissue, const SkinMap& map)
    : m_rest(tissue.rest())
{
  vertices.reserve(map.places.size());
  for (const SkinPlace& place : map.places)
    vertices.push_back(tissue.skin_weights(place));
}

std::vector<Vec3> SkinInterpolation::of_change(const std::vector<Vec3>& change) const
{
  std::vector<Vec3> u(vertices.size(), Vec3::Zero());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t i = 0; i < static_cast<std::size_t>(vertices[v].count); ++i)
      u[v] += vertices[v].weight[i] * change[static_cast<std::size_t>(vertices[v].control[i])];
  return u;
}

std::vector<Vec3> SkinInterpolation::displacement(const std::vector<Vec3>& x) const
{
  std::vector<Vec3> change = x;
  for (std::size_t c = 0; c < change.size(); ++c)
    change[c] -= m_rest[c];
  return of_change(change);
}

} // namespace f2b
