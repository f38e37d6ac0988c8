#pragma once

#include "Core/sculpting/brush.hpp"
#include "Core/sculpting/geodesic_distance.hpp"
#include "Core/sculpting/sculpted_skin.hpp"

/// Which vertices does a brush act on, and how strongly?
namespace f2b
{

struct BrushedVertex
{
  int vertex;
  double weight;         ///< in (0, 1]: falloff, facing and depth; not the mask
  double mirrored_share; ///< of the two middles' say: 0 own side, 1 mirror side
};

/// Where a brush acts: at one place, and at the mirrored one if it is symmetric.
struct BrushArea
{
  SurfacePlace place;
  std::optional<SurfacePlace> mirror;
  std::vector<BrushedVertex> vertices; ///< in ascending order, each once
};

/// Distance is measured along the skin, so a dab on the upper lip does not reach the lower one but
/// around the corner of the mouth. Where both sides act, the stronger one's weight counts and the
/// two share the direction: at the middle of the face a symmetric drag is neither doubled nor torn.
/// \param view  unit, from the viewer into the picture; zero: seen from everywhere
/// \param distances  of the skin's links
BrushArea brush_area(const SculptedSkin& skin, const Brush& brush, const SurfacePlace& place,
                     const Vec3& view, GeodesicDistance& distances);

} // namespace f2b
