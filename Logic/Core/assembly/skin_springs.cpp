#include "Core/assembly/skin_springs.hpp"

#include <map>

namespace f2b
{

std::vector<SkinSpring> make_skin_springs(const MixedMesh& mesh, const SkinMap& map,
                                          const std::vector<Vec3>& displacement,
                                          const std::vector<double>& area)
{
  std::map<int, SkinSpring> springs;
  for (std::size_t v = 0; v < map.places.size(); ++v)
  {
    const SkinPlace& place = map.places[v];
    if (place.prism < 0 || area[v] <= 0)
      continue;
    Vec3 target = displacement[v];
    const auto& corners = mesh.prisms[static_cast<std::size_t>(place.prism)];
    for (int i = 0; i < 3; ++i)
      target +=
          place.weights[i] * mesh.X[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
    SkinSpring& spring = springs[place.prism];
    spring.prism = place.prism;
    spring.mass += area[v] * place.weights * place.weights.transpose();
    spring.pull += area[v] * target * place.weights.transpose();
    spring.offset += area[v] * target.squaredNorm();
  }
  std::vector<SkinSpring> result;
  for (auto& entry : springs)
    result.push_back(entry.second);
  return result;
}

} // namespace f2b
