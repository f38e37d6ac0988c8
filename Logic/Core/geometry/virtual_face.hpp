#pragma once

#include "Core/geometry/loft.hpp"
#include "Core/geometry/virtual_skull.hpp"

/// What do the soft tissues of the virtual patient look like?
///
/// Signed distances in the frame of virtual_skull.hpp, symmetric about R = 0 [mm, RAS].
namespace f2b
{

class VirtualFace
{
public:
  explicit VirtualFace(const MidfaceShift& midface);

  /// Outside of the head with mouth and nostrils closed; the neck runs on downwards without end.
  double skin(const Vec3& point) const;
  /// Airway from the nostrils to the windpipe, without regard to bone.
  double airway(const Vec3& point) const { return m_airway.distance(point); }
  /// Chewing and mimic muscles, tongue, eyes, neck and all that lies deep below the skin, without
  /// regard to bone. `skin` is the signed distance of the point.
  double muscle(const Vec3& point, double skin) const;

private:
  Loft m_mask;
  Sculpture m_head, m_features, m_ear, m_airway, m_muscles;
};

} // namespace f2b
