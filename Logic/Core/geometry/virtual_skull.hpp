#pragma once

#include "Core/geometry/sculpture.hpp"

/// What does the skull of the virtual patient look like?
///
/// Frankfort frame: +R right, +A the nose, +S up, the Frankfort plane at S = -20 mm [mm, RAS].
namespace f2b
{

/// How far the mid-face of the virtual patient lies behind its normal place.
class MidfaceShift
{
public:
  explicit MidfaceShift(double retrusion_mm) : m_retrusion(retrusion_mm) {}

  /// The place of a point of the normal mid-face: full shift from the infraorbital rim to the upper
  /// teeth, none at the nasion and at the ear.
  Vec3 operator()(double r, double a, double s) const;

private:
  double m_retrusion;
};

/// Bones and teeth as signed distances, each symmetric about R = 0.
class VirtualSkull
{
public:
  explicit VirtualSkull(const MidfaceShift& midface);

  struct Distances
  {
    double bone;    ///< all bones and teeth
    double teeth;   ///< crowns and roots
    double vault;   ///< the brain case as a solid body
    double sinuses; ///< cavities in the maxilla
  };
  Distances distances(const Vec3& point) const;
  double mandible(const Vec3& point) const; ///< with its teeth
  double vault(const Vec3& point) const { return m_vault.distance(point); }

private:
  Sculpture m_vault, m_face, m_base, m_openings, m_septa, m_sinuses;
  Sculpture m_mandible, m_spine, m_upper_teeth, m_lower_teeth;
};

} // namespace f2b
