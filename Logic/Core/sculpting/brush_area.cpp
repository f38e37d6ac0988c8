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

/// In ascending order, as what is done to them reads the skin; one entry for a vertex that both sides
/// reach. By a table, not by sorting: a large brush reaches a quarter of the skin.
void put_in_order(std::vector<BrushedVertex>& vertices, std::size_t skin_size)
{
  std::vector<int> place(skin_size, -1);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    int& there = place[static_cast<std::size_t>(vertices[i].vertex)];
    if (there < 0)
    {
      there = static_cast<int>(i);
      continue;
    }
    BrushedVertex& both = vertices[static_cast<std::size_t>(there)]; // the own side's came first
    const double mirrored = vertices[i].weight;
    both.mirrored_share = mirrored / (both.weight + mirrored);
    both.weight = std::max(both.weight, mirrored);
  }
  std::vector<BrushedVertex> ordered;
  ordered.reserve(vertices.size());
  for (const int i : place)
    if (i >= 0)
      ordered.push_back(vertices[static_cast<std::size_t>(i)]);
  vertices = std::move(ordered);
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
  put_in_order(area.vertices, skin.size());
  return area;
}

} // namespace f2b
