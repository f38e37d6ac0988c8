#include "Imaging/head_region.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

constexpr double cranium_height = 110.0; ///< from the vertex to about the orbits' floor
constexpr double face_height = 260.0;    ///< the chin is not farther below the vertex
constexpr double forehead = 60.0;        ///< of the height below the vertex, not part of the face

/// Bounds of the samples with `inside(sample)` and a position that `within` accepts.
template <class Inside, class Within>
Box bounds_where(const Lattice& lattice, Inside inside, Within within)
{
  Box box{lattice.last(), lattice.origin};
  for (int k = 0; k < lattice.size.z(); ++k)
    for (int j = 0; j < lattice.size.y(); ++j)
      for (int i = 0; i < lattice.size.x(); ++i)
      {
        const Vec3 p = lattice.position(i, j, k);
        if (!inside(lattice.index(i, j, k)) || !within(p))
          continue;
        box.min = box.min.cwiseMin(p);
        box.max = box.max.cwiseMax(p);
      }
  return box;
}

} // namespace

Box face_region(const HeadMask& head)
{
  const Lattice lattice = lattice_of(head.head);
  auto in_head = [&](std::size_t s) { return head.head.values[s] < 0; };
  auto in_bone = [&](std::size_t s) { return head.bone.values[s] != 0; };
  const double vertex = bounds_where(lattice, in_head, [](const Vec3&) { return true; }).max.z();
  const Box cranium = bounds_where(lattice, in_bone,
                                   [&](const Vec3& p) { return p.z() > vertex - cranium_height; });
  const double middle = 0.5 * (cranium.min.y() + cranium.max.y());
  const double front = middle + 0.2 * (cranium.max.y() - cranium.min.y());
  const double lowest = vertex - face_height;
  const Box jaws = bounds_where(lattice, in_bone,
                                [&](const Vec3& p) { return p.y() > front && p.z() > lowest; });
  const double bottom = jaws.min.z() - 10.0;
  Box face = bounds_where(
      lattice, in_head,
      [&](const Vec3& p) { return p.y() > middle && p.z() > bottom && p.z() < vertex - forehead; });
  const double clearance = 4.0;
  face.min -= Vec3(clearance, 0.0, 0.0);
  face.max += Vec3(clearance, clearance, 0.0);
  face.min.y() = middle;
  face.min.z() = std::max(bottom, lattice.origin.z());
  return face;
}

} // namespace f2b
