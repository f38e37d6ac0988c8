#include "Core/assembly/skin_springs.hpp"

#include <map>

namespace f2b
{
namespace
{

SkinSpring unloaded(const SkinWeights& point)
{
  SkinSpring spring;
  spring.prism = point.prism;
  spring.count = point.count;
  spring.mass.setZero();
  spring.pull.setZero();
  return spring;
}

void load(SkinSpring& spring, const SkinWeights& point, double area, const Vec3& target)
{
  const Eigen::Map<const Eigen::Matrix<double, SkinSpring::most, 1>> b(point.weight.data());
  spring.mass += area * b * b.transpose();
  spring.pull += area * target * b.transpose();
  spring.offset += area * target.squaredNorm();
}

} // namespace

std::vector<SkinSpring> make_skin_springs(const Discretization& tissue,
                                          const SkinInterpolation& skin,
                                          const std::vector<Vec3>& displacement,
                                          const std::vector<double>& area)
{
  const std::vector<Vec3> rest = skin.of_change(tissue.rest());
  std::map<int, SkinSpring> springs;
  for (std::size_t v = 0; v < skin.vertices.size(); ++v)
  {
    const SkinWeights& point = skin.vertices[v];
    if (point.prism < 0 || area[v] <= 0)
      continue;
    SkinSpring& spring = springs.emplace(point.prism, unloaded(point)).first->second;
    load(spring, point, area[v], rest[v] + displacement[v]);
  }
  std::vector<SkinSpring> result;
  for (auto& entry : springs)
    result.push_back(entry.second);
  return result;
}

} // namespace f2b
