#include "Core/geometry/virtual_skull.hpp"
#include "Core/geometry/virtual_skull_parts.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

constexpr double vault_thickness = 6;
constexpr double joint_space = 3;

double smooth_step(double from, double to, double value)
{
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

} // namespace

Vec3 MidfaceShift::operator()(double r, double a, double s) const
{
  const double below_nasion = 1 - smooth_step(-16, 8, s);
  const double before_ear = smooth_step(0, 26, a);
  return {r, a - m_retrusion * below_nasion * before_ear, s};
}

VirtualSkull::VirtualSkull(const MidfaceShift& midface)
    : m_vault(brain_case()), m_face(facial_skeleton(midface)), m_base(skull_base(midface)),
      m_openings(skull_openings(midface)), m_septa(nasal_septum(midface)),
      m_sinuses(maxillary_sinuses(midface)), m_mandible(mandible_bone()), m_spine(cervical_spine()),
      m_upper_teeth(upper_teeth(midface)), m_lower_teeth(lower_teeth())
{
}

VirtualSkull::Distances VirtualSkull::distances(const Vec3& point) const
{
  const double jaw = m_mandible.distance(point);
  const double lower_teeth = m_lower_teeth.distance(point);
  Distances d;
  d.vault = m_vault.distance(point);
  d.sinuses = m_sinuses.distance(point);
  d.teeth = std::min(m_upper_teeth.distance(point), lower_teeth);
  const double shell = std::max(d.vault, -(d.vault + vault_thickness));
  double cranium = m_base.distance(point, m_face.distance(point, shell));
  cranium = smooth_subtraction(m_openings.distance(point, cranium), d.sinuses, 1);
  cranium = m_septa.distance(point, cranium);
  // The joint space: the cranium keeps clear of the mandible wherever the two meet.
  cranium = std::max(cranium, joint_space - jaw);
  d.bone = std::min({cranium, jaw, d.teeth, m_spine.distance(point)});
  return d;
}

double VirtualSkull::mandible(const Vec3& point) const
{
  return std::min(m_mandible.distance(point), m_lower_teeth.distance(point));
}

} // namespace f2b
