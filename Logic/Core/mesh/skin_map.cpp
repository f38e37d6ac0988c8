#include "Core/mesh/skin_map.hpp"

namespace f2b
{

std::vector<Vec3> SkinMap::displacement(const MixedMesh& mesh, const std::vector<Vec3>& x) const
{
  std::vector<Vec3> u(places.size(), Vec3::Zero());
  for (std::size_t v = 0; v < places.size(); ++v)
  {
    if (places[v].prism < 0)
      continue;
    const auto& corners = mesh.prisms[static_cast<std::size_t>(places[v].prism)];
    for (int i = 0; i < 3; ++i)
    {
      const auto node = static_cast<std::size_t>(corners[static_cast<std::size_t>(i)]);
      u[v] += places[v].weights[i] * (x[node] - mesh.X[node]);
    }
  }
  return u;
}

} // namespace f2b
