#include "Core/sculpting/brush_area.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

/// Skin that faces away has no weight, with a soft edge from 90 degrees on. What is seen from the
/// edge counts in full: in profile the middle of the face would lag behind a symmetric drag.
double facing(const Vec3& normal, const Vec3& view)
{
  constexpr double none = -0.25;
  const double cosine = -normal.dot(view);
  const double t = std::clamp((cosine - none) / -none, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

struct Side
{
  SurfacePlace place;
  Vec3 view;
  double share; ///< 0 own, 1 mirrored
};

void add_side(const SculptedSkin& skin, const Brush& brush, const Side& side,
              GeodesicDistance& distances, std::vector<BrushedVertex>& vertices)
{
  const bool seen_from_somewhere = side.view != Vec3::Zero();
  const Falloff curve = brush.kind == BrushKind::ElasticGrab ? Falloff::Smooth : brush.curve;
  for (const NearVertex& near : distances.from(skin.points(), side.place, brush.reach_mm()))
  {
    const auto v = static_cast<std::size_t>(near.vertex);
    if ((skin.points()[v] - side.place.point).dot(side.view) > brush.depth_mm)
      continue;
    double weight = falloff(curve, near.distance / brush.reach_mm());
    if (brush.front_faces_only && seen_from_somewhere)
      weight *= facing(skin.normals()[v], side.view);
    if (weight > 0)
      vertices.push_back({near.vertex, weight, side.share});
  }
}

/// One entry for a vertex that both sides reach.
void join(std::vector<BrushedVertex>& vertices)
{
  std::sort(vertices.begin(), vertices.end(),
            [](const BrushedVertex& a, const BrushedVertex& b)
            {
              return std::make_pair(a.vertex, a.mirrored_share) <
                     std::make_pair(b.vertex, b.mirrored_share);
            });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i, ++kept)
  {
    vertices[kept] = vertices[i];
    if (i + 1 < vertices.size() && vertices[i + 1].vertex == vertices[i].vertex)
    {
      const double own = vertices[i].weight, other = vertices[i + 1].weight;
      vertices[kept].weight = std::max(own, other);
      vertices[kept].mirrored_share = other / (own + other);
      ++i;
    }
  }
  vertices.resize(kept);
}

} // namespace

BrushArea brush_area(const SculptedSkin& skin, const Brush& brush, const SurfacePlace& place,
                     const Vec3& view, GeodesicDistance& distances)
{
  BrushArea area{place, {}, {}};
  add_side(skin, brush, {place, view, 0}, distances, area.vertices);
  if (brush.symmetry)
  {
    area.mirror = skin.tree().nearest(brush.symmetry->mirrored(place.point));
    add_side(skin, brush, {*area.mirror, brush.symmetry->mirrored_vector(view), 1}, distances,
             area.vertices);
  }
  join(area.vertices);
  return area;
}

} // namespace f2b
