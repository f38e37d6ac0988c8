#include "Core/geometry/lattice_cuts.hpp"

#include "Core/geometry/saw_blade.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace f2b
{
namespace
{

auto order(const LatticeCuts::Passage& p)
{
  return std::tuple(p.sample, p.axis, p.cut);
}

/// The samples around a rectangle, one beyond it on each side.
std::pair<Eigen::Vector3i, Eigen::Vector3i> box_around(const BoundedPlane& plane,
                                                       const ScalarGrid& lattice)
{
  const Vec3 reach = (plane.half_u * plane.u).cwiseAbs() + (plane.half_v * plane.v).cwiseAbs();
  const Vec3 low = (plane.center - reach - lattice.origin) / lattice.spacing,
             high = (plane.center + reach - lattice.origin) / lattice.spacing;
  Eigen::Vector3i first, last;
  for (int a = 0; a < 3; ++a)
  {
    const double most = lattice.size[a] - 1;
    first[a] = static_cast<int>(std::clamp(std::floor(low[a]) - 1, 0.0, most));
    last[a] = static_cast<int>(std::clamp(std::ceil(high[a]) + 1, 0.0, most));
  }
  return {first, last};
}

} // namespace

LatticeCuts::LatticeCuts(const ScalarGrid& lattice, const std::vector<Osteotomy>& osteotomies)
    : m_passed(lattice.count(), 0)
{
  for (std::size_t k = 0; k < osteotomies.size(); ++k)
  {
    const std::string who = "osteotomy '" + osteotomies[k].fragment + "', ";
    for (const BoundedPlane& plane : osteotomies[k].planes)
      m_cuts.push_back({k, who + "plane '" + plane.name + "'", plane.may_miss});
    for (const SweptCurve& curve : osteotomies[k].curves)
      m_cuts.push_back({k, who + "curve '" + curve.name + "'", false});
  }
  for (const SawFacet& facet : saw_facets(osteotomies))
    add(lattice, facet.plane, facet.cut);
  std::sort(m_passages.begin(), m_passages.end(),
            [](const Passage& a, const Passage& b) { return order(a) < order(b); });
}

void LatticeCuts::add(const ScalarGrid& lattice, const BoundedPlane& plane, std::size_t cut)
{
  const auto [first, last] = box_around(plane, lattice);
  Vec3 at;
  for (int k = first.z(); k <= last.z(); ++k)
    for (int j = first.y(); j <= last.y(); ++j)
      for (int i = first.x(); i <= last.x(); ++i)
      {
        const Vec3 p = lattice.position(i, j, k);
        if (std::abs(plane.signed_distance(p)) > lattice.spacing)
          continue;
        const std::size_t sample = lattice.index(i, j, k);
        for (int axis = 0; axis < 3; ++axis)
        {
          Eigen::Vector3i next(i, j, k);
          if (++next[axis] >= lattice.size[axis] ||
              !plane.separates(p, lattice.position(next.x(), next.y(), next.z()), at))
            continue;
          m_passed[sample] |= static_cast<unsigned char>(1 << axis);
          m_passages.push_back({sample, axis, cut, at});
        }
      }
}

const LatticeCuts::Passage& LatticeCuts::passage(std::size_t sample, int axis) const
{
  return *std::lower_bound(m_passages.begin(), m_passages.end(), std::pair(sample, axis),
                           [](const Passage& p, const std::pair<std::size_t, int>& key)
                           { return std::pair(p.sample, p.axis) < key; });
}

} // namespace f2b
