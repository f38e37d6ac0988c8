#pragma once

#include "Core/geometry/vectors.hpp"

#include <limits>
#include <optional>

/// What does a brush do to the face, how far does it reach, and how does it fade out?
namespace f2b
{

enum class BrushKind
{
  Grab,        ///< drags the skin under the brush along
  ElasticGrab, ///< the same as if the face were a soft solid: no crease at the brush's border
  Draw,        ///< builds up along the normal, or carves where it is inverted
  Smooth,      ///< evens out the displacement, not the patient's own features
  Flatten,     ///< towards the mean plane under the brush
  Erase,       ///< back to the patient's own face
  Mask,        ///< protects from all other brushes
  Unmask,
};

/// How a brush's strength falls from 1 at its middle to 0 at its radius, t = distance / radius.
enum class Falloff
{
  Smooth,   ///< (1 - t^2)^2
  Sphere,   ///< sqrt(1 - t^2)
  Linear,   ///< 1 - t
  Sharp,    ///< (1 - t)^2
  Constant, ///< 1
};

/// \param t  >= 0; the result is 0 from 1 on
double falloff(Falloff curve, double t);

/// A plane that the face is worked on symmetrically about.
struct SymmetryPlane
{
  Vec3 point = Vec3::Zero(); ///< [mm]
  Vec3 normal = Vec3::UnitX();

  Vec3 mirrored(const Vec3& p) const { return p - 2 * normal.dot(p - point) * normal; }
  Vec3 mirrored_vector(const Vec3& v) const { return v - 2 * normal.dot(v) * normal; }
};

struct Brush
{
  static constexpr double least_radius_mm = 1, most_radius_mm = 80;

  BrushKind kind = BrushKind::Grab;
  double radius_mm = 15; ///< along the skin
  /// In [0, 1]. Grabs: share of the drag that the middle follows; Draw: millimetres of a dab as a
  /// share of radius / 10; others: share of the whole effect that a dab has.
  double strength = 1;
  Falloff curve = Falloff::Smooth;
  bool inverted = false;        ///< Draw: inwards
  bool front_faces_only = true; ///< leaves skin that faces away from the viewer
  double depth_mm = std::numeric_limits<double>::infinity(); ///< leaves skin farther behind the
                                                             ///< middle, as the viewer sees it
  std::optional<SymmetryPlane> symmetry;

  bool drags() const { return kind == BrushKind::Grab || kind == BrushKind::ElasticGrab; }
  bool masks() const { return kind == BrushKind::Mask || kind == BrushKind::Unmask; }
  /// How far from the middle anything may change [mm].
  double reach_mm() const { return kind == BrushKind::ElasticGrab ? 2 * radius_mm : radius_mm; }
};

/// Displacement of a soft infinite solid at `offset` from where a ball of it is dragged, exactly the
/// drag at 0: difference of two regularised Kelvinlets (sizes radius/2 and radius), which fades with
/// the cube of the distance. F. de Goes and D. James, ACM Trans. Graph. 36 (2017) 40, eqs. 6 and 10.
/// \param radius_mm  of the ball
Vec3 elastic_drag(const Vec3& offset, const Vec3& drag, double radius_mm);

} // namespace f2b
