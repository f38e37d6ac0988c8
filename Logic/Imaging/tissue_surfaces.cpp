#include "Imaging/tissue_surfaces.hpp"

#include "Imaging/metal_streaks.hpp"
#include "Imaging/signed_distance.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

/// Farther from the coarse head than this, what is above the threshold is holder or cloth.
constexpr float coarse_tolerance = 3.0F;
/// A closing reproduces the surface that it does not shut to about this; keep the exact one there.
constexpr float closing_tolerance = 0.15F;
/// Thinner air inside the head is taken for a fold or a streak; a part of it that does not reach
/// `airway_depth_mm` below the face for an ear; air nearer to the face for a nostril [mm].
constexpr float airway_mm = 4.0F, airway_in_streaks_mm = 8.0F;
constexpr float airway_depth_mm = 15.0F, nostril_depth_mm = 4.0F;
/// A streak is thinner than this along S; lips and teeth may stand out by a stub although they are
/// thin, too. What the filters along S leave rough is smoothed [mm].
constexpr double skin_streak_mm = 6.0, skin_stub_mm = 1.0, skin_smoothing_mm = 1.6;
constexpr double bone_streak_mm = 10.0, bone_stub_mm = 2.5, bone_smoothing_mm = 0.8;

ScalarGrid level_below(const ScalarGrid& hu, double threshold)
{
  ScalarGrid level = hu;
  for (float& v : level.values)
    v = static_cast<float>(threshold) - v;
  return level;
}

void cut_off_what_is_not_head(ScalarGrid& distance, const HeadMask& head)
{
#pragma omp parallel for
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i)
      {
        float& d = distance.values[distance.index(i, j, k)];
        const double coarse = head.head.value(distance.position(i, j, k));
        d = std::max(d, static_cast<float>(coarse) - coarse_tolerance);
      }
}

/// The samples at which a mask of the coarse lattice holds, nearest sample.
BinaryMask sampled(const BinaryMask& coarse, const Lattice& lattice)
{
  LabelGrid labels{coarse.lattice.origin, coarse.lattice.spacing, coarse.lattice.size,
                   coarse.values};
  BinaryMask fine(lattice);
#pragma omp parallel for
  for (int k = 0; k < lattice.size.z(); ++k)
    for (int j = 0; j < lattice.size.y(); ++j)
      for (int i = 0; i < lattice.size.x(); ++i)
        fine.values[lattice.index(i, j, k)] = labels.nearest(lattice.position(i, j, k));
  return fine;
}

/// Makes the parts of the outside that no seed reaches a part of the inside.
void fill_cavities(ScalarGrid& level, const BinaryMask& seeds)
{
  const BinaryMask outside =
      mask_where(lattice_of(level), [&](std::size_t s) { return level.values[s] >= 0; });
  const BinaryMask reached = reconstruct(seeds, outside);
  for (std::size_t s = 0; s < level.values.size(); ++s)
    if (outside.values[s] && !reached.values[s])
      level.values[s] = -std::max(level.values[s], 0.5F * static_cast<float>(level.spacing));
}

/// Closes a body with a ball of `radius` and fills the cavities that `outside` does not reach.
/// \param outside  samples that lie farther than `radius` from the body, on its outside
ScalarGrid closed(const ScalarGrid& distance, const BinaryMask& outside, double radius)
{
  const float r = static_cast<float>(radius);
  ScalarGrid dilated = distance;
  for (float& v : dilated.values)
    v -= r;
  fill_cavities(dilated, outside);
  ScalarGrid result = signed_distance(dilated, 3.0 + radius);
  for (std::size_t s = 0; s < result.values.size(); ++s)
    result.values[s] = std::min(distance.values[s], result.values[s] + r + closing_tolerance);
  fill_cavities(result, outside);
  return signed_distance(result);
}

/// The parts of a mask that reach `depth` below the face.
BinaryMask deep_parts(const BinaryMask& mask, const ScalarGrid& skin, float depth)
{
  const BinaryMask deep =
      mask_where(mask.lattice, [&](std::size_t s) { return skin.values[s] < -depth; });
  return reconstruct(deep, mask);
}

/// Sinuses, nose, mouth and pharynx, but not gaps as thin as a dark streak.
BinaryMask airways(const ScalarGrid& hu, const ScalarGrid& skin, double threshold)
{
  const Lattice lattice = lattice_of(hu);
  const BinaryMask zone = streak_zone(hu);
  const BinaryMask solid = mask_where(lattice, [&](std::size_t s)
                                      { return hu.values[s] >= threshold || skin.values[s] >= 0; });
  const ScalarGrid clearance = distance_to(solid);
  auto is_core = [&](std::size_t s)
  { return clearance.values[s] > (zone.values[s] ? airway_in_streaks_mm : airway_mm) / 2; };
  const BinaryMask core = deep_parts(mask_where(lattice, is_core), skin, airway_depth_mm);
  const ScalarGrid from_core = distance_to(core);
  auto is_near = [&](std::size_t s)
  { return from_core.values[s] <= (zone.values[s] ? airway_in_streaks_mm : airway_mm) / 2 + 1; };
  return mask_where(lattice, is_near);
}

ScalarGrid inner_air_distance(const ScalarGrid& hu, const ScalarGrid& skin, double threshold)
{
  const BinaryMask near_airway = airways(hu, skin, threshold);
  ScalarGrid level = hu;
  for (std::size_t s = 0; s < level.values.size(); ++s)
  {
    level.values[s] -= static_cast<float>(threshold);
    if (!near_airway.values[s])
      level.values[s] = std::max(level.values[s], 100.0F);
  }
  ScalarGrid air = signed_distance(level);
  for (std::size_t s = 0; s < air.values.size(); ++s)
    air.values[s] = std::max(air.values[s], skin.values[s] + nostril_depth_mm);
  return air;
}

void drop_small_pieces(ScalarGrid& level, double smallest_ml)
{
  const BinaryMask inside =
      mask_where(lattice_of(level), [&](std::size_t s) { return level.values[s] < 0; });
  const Components parts = components_of(inside);
  const double sample_ml = std::pow(level.spacing, 3) / 1000.0;
  for (std::size_t s = 0; s < level.values.size(); ++s)
  {
    const int part = parts.label[s] - 1;
    if (part >= 0 && !parts.touches_wall[part] &&
        static_cast<double>(parts.size[part]) * sample_ml < smallest_ml)
      level.values[s] = std::max(-level.values[s], 0.5F);
  }
}

} // namespace

ScalarGrid face_distance(const ScalarGrid& hu, const HeadMask& head,
                         const TissueSurfaceOptions& options)
{
  const ScalarGrid grey = signed_distance(level_below(hu, options.skin_threshold_hu));
  const BinaryMask zone = streak_zone(hu);
  const bool streaks = zone.count() > 0;
  ScalarGrid open = grey;
  if (streaks)
  {
    remove_streaks(open, zone, skin_streak_mm, skin_stub_mm);
    fill_streaks(open, zone, skin_streak_mm, skin_stub_mm);
  }
  cut_off_what_is_not_head(open, head);
  ScalarGrid face = closed(open, sampled(head.outer_air, lattice_of(hu)), options.head_closing_mm);
  if (!streaks)
    return face;
  // Streaks and the closing of what they cut into leave ridges; elsewhere the closing is smooth.
  ScalarGrid unchanged = face;
  for (std::size_t s = 0; s < face.values.size(); ++s)
    if (zone.values[s])
      unchanged.values[s] = grey.values[s];
  smooth_near_changes(face, unchanged, skin_smoothing_mm);
  return signed_distance(face);
}

ScalarGrid bone_distance(const ScalarGrid& hu, const HeadMask& head,
                         const TissueSurfaceOptions& options)
{
  ScalarGrid level = level_below(hu, options.bone_threshold_hu);
  const BinaryMask zone = streak_zone(hu);
  if (zone.count() > 0)
  {
    level = signed_distance(level);
    const ScalarGrid before = level;
    remove_streaks(level, zone, bone_streak_mm, bone_stub_mm);
    smooth_near_changes(level, before, bone_smoothing_mm);
  }
  drop_small_pieces(level, options.smallest_bone_ml);
  ScalarGrid bone = signed_distance(level);
  cut_off_what_is_not_head(bone, head);
  return bone;
}

ScalarGrid closed_bone_distance(const ScalarGrid& hu, const ScalarGrid& skin,
                                const ScalarGrid& bone, const HeadMask& head,
                                const TissueSurfaceOptions& options)
{
  ScalarGrid body = inner_air_distance(hu, skin, options.skin_threshold_hu);
  for (std::size_t s = 0; s < body.values.size(); ++s)
    body.values[s] = std::min(body.values[s], bone.values[s]);
  return closed(body, sampled(head.outside_bone, lattice_of(hu)), options.bone_closing_mm);
}

} // namespace f2b
