#include "Core/geometry/virtual_face.hpp"
#include "Core/geometry/virtual_face_parts.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

constexpr double deep_layer = 14; ///< depth below the skin from which muscle prevails [mm]

} // namespace

VirtualFace::VirtualFace(const MidfaceShift& midface)
    : m_mask(facial_mask(midface)), m_head(head_and_neck()), m_features(facial_features(midface)),
      m_ear(ear()), m_airway(upper_airway(midface)), m_muscles(soft_muscles(midface))
{
}

double VirtualFace::skin(const Vec3& point) const
{
  // The jaw line: the underside of the mask rises from the chin to the angle of the jaw.
  static const HalfSpace underside{{0, 74, -125}, Vec3(0, -0.36, -0.933)};
  static const HalfSpace top{{0, 0, 42}, Vec3(0, 0, 1)};
  const double open_mask = m_mask.distance(point);
  const double mask = smooth_intersection(smooth_intersection(open_mask, top.distance(point), 30),
                                          underside.distance(point), 16);
  const double head = smooth_union(m_head.distance(point), mask, 12);
  return smooth_union(m_features.distance(point, head), m_ear.distance(point), 4);
}

double VirtualFace::muscle(const Vec3& point, double skin) const
{
  return std::min(m_muscles.distance(point), skin + deep_layer);
}

} // namespace f2b
