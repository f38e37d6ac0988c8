#include "Core/geometry/bone_gap.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

/// Rays nearly along the moved face would tell nothing of its distance.
constexpr double least_facing = 0.2;

bool on_face(const Vec3& p, const std::vector<CutPoint>& face, double spacing_mm)
{
  return std::any_of(face.begin(), face.end(),
                     [&](const CutPoint& c)
                     { return (c.place - p).squaredNorm() < spacing_mm * spacing_mm; });
}

} // namespace

BoneGap gap_between(const CutBone& cut, const MovedPart& part, const MovedPart& other)
{
  BoneGap gap;
  const std::vector<CutPoint> face = common_cut(cut, part.label, other.label);
  const RigidMotion motion = seen_from(other, part);
  double facing_mm2 = 0;
  for (const CutPoint& c : face)
  {
    gap.cut_mm2 += c.area_mm2;
    // from the other part's sawn face along its normal to the moved face of the part
    const Vec3 half_kerf = 0.5 * c.kerf_mm * c.normal, from = c.place - half_kerf;
    const Vec3 normal = motion.rotation * c.normal;
    if (normal.dot(c.normal) < least_facing)
      continue;
    const double distance =
        normal.dot(motion.apply(c.place + half_kerf) - from) / normal.dot(c.normal);
    const Vec3 hit = from + distance * c.normal - motion.translation;
    if (!on_face(motion.rotation.transpose() * hit - half_kerf, face, cut.bone.spacing))
      continue;
    facing_mm2 += c.area_mm2;
    const double width = std::max(0.0, distance - c.kerf_mm);
    gap.volume_mm3 += c.area_mm2 * width;
    if (width > gap.max_mm)
    {
      gap.max_mm = width;
      gap.widest = other.motion.apply(from);
    }
  }
  gap.facing_share = gap.cut_mm2 > 0 ? facing_mm2 / gap.cut_mm2 : 0;
  gap.mean_mm = facing_mm2 > 0 ? gap.volume_mm3 / facing_mm2 : 0;
  return gap;
}

} // namespace f2b
