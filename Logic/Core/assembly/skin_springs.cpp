#include "Core/assembly/skin_springs.hpp"

#include <algorithm>
#include <map>

namespace f2b
{
namespace
{

/// Below it p1 - p0 has no direction [mm].
constexpr double no_direction_mm = 1e-9;

/// The force f_e on a skin whose target is at `gap` from it.
Vec3 force(const VirtualForceLaw& law, const Vec3& gap)
{
  if (law.rest_length_mm == 0)
    return law.stiffness_n_per_mm3 * gap;
  const double length = gap.norm();
  if (length < no_direction_mm)
    return Vec3::Zero();
  return law.stiffness_n_per_mm3 * (1 - law.rest_length_mm / length) * gap;
}

} // namespace

double pull_energy(const VirtualForceLaw& law, const Vec3& target, const Vec3& u)
{
  if (law.load == VirtualLoad::Dead)
    return -force(law, target).dot(u);
  const double extension = (target - u).norm() - law.rest_length_mm;
  return 0.5 * law.stiffness_n_per_mm3 * extension * extension;
}

Vec3 pull_gradient(const VirtualForceLaw& law, const Vec3& target, const Vec3& u)
{
  return -force(law, law.load == VirtualLoad::Dead ? target : Vec3(target - u));
}

Mat3 pull_hessian(const VirtualForceLaw& law, const Vec3& target, const Vec3& u, Tangent tangent)
{
  if (law.load == VirtualLoad::Dead)
    return Mat3::Zero();
  if (law.rest_length_mm == 0)
    return law.stiffness_n_per_mm3 * Mat3::Identity();
  const Vec3 gap = target - u;
  const double length = gap.norm();
  if (length < no_direction_mm)
    return Mat3::Zero();
  // along the pull the spring's stiffness, across it that of a string
  double across = 1 - law.rest_length_mm / length;
  if (tangent == Tangent::Positive)
    across = std::max(across, 0.0);
  const Vec3 n = gap / length;
  return law.stiffness_n_per_mm3 * (across * Mat3::Identity() + (1 - across) * n * n.transpose());
}

double SkinSpring::energy(const VirtualForceLaw& law, const Controls& u) const
{
  double sum = 0;
  for (const Point& point : points)
    sum += point.area * pull_energy(law, point.target, u * point.N);
  return sum;
}

SkinSpring::Controls SkinSpring::gradient(const VirtualForceLaw& law, const Controls& u) const
{
  Controls sum = Controls::Zero();
  for (const Point& point : points)
    sum += point.area * pull_gradient(law, point.target, u * point.N) * point.N.transpose();
  return sum;
}

std::vector<SkinSpring> make_skin_springs(const SkinInterpolation& skin,
                                          const std::vector<Vec3>& displacement,
                                          const std::vector<double>& area)
{
  std::map<int, SkinSpring> springs;
  for (std::size_t v = 0; v < skin.vertices.size(); ++v)
  {
    const SkinWeights& place = skin.vertices[v];
    if (place.prism < 0 || area[v] <= 0)
      continue;
    SkinSpring& spring = springs[place.prism];
    spring.prism = place.prism;
    spring.count = place.count;
    spring.points.push_back(
        {area[v], displacement[v], Eigen::Map<const SkinSpring::Weights>(place.weight.data())});
  }
  std::vector<SkinSpring> result;
  for (auto& entry : springs)
    result.push_back(std::move(entry.second));
  return result;
}

} // namespace f2b
