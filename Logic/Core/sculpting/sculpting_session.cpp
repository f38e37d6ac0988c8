#include "Core/sculpting/sculpting_session.hpp"

#include "Core/error.hpp"
#include "Core/geometry/landmark_warp.hpp"

#include <cassert>
#include <numeric>

namespace f2b
{
namespace
{

/// What part of a brush's effect a vertex takes.
double share(double weight, double mask)
{
  return weight * (1 - mask);
}

} // namespace

std::string name_of(BrushKind kind)
{
  switch (kind)
  {
  case BrushKind::Grab:
    return "Grab";
  case BrushKind::ElasticGrab:
    return "Elastic grab";
  case BrushKind::Draw:
    return "Draw";
  case BrushKind::Smooth:
    return "Smooth";
  case BrushKind::Flatten:
    return "Flatten";
  case BrushKind::Erase:
    return "Erase";
  case BrushKind::Mask:
    return "Mask";
  case BrushKind::Unmask:
    return "Unmask";
  }
  return "";
}

SculptingSession::SculptingSession(TriangleMesh reference, std::vector<Vec3> displacement)
    : m_skin(std::move(reference), std::move(displacement)), m_distances(m_skin.links()),
      m_slot(m_skin.size(), -1)
{
}

void SculptingSession::open(const std::string& name)
{
  end_stroke();
  m_stroking = true;
  m_name = name;
  m_warp_from.clear();
}

/// Keeps a vertex's state before the stroke.
void SculptingSession::remember(int vertex)
{
  int& slot = m_slot[static_cast<std::size_t>(vertex)];
  if (slot >= 0)
    return;
  slot = static_cast<int>(m_touched.size());
  m_touched.push_back(vertex);
  m_before.push_back(m_skin.vertex(vertex));
}

void SculptingSession::change(int vertex, const SkinVertex& state)
{
  if (state == m_skin.vertex(vertex))
    return;
  remember(vertex);
  m_skin.set(vertex, state);
  m_moved.push_back(vertex);
}

/// Moves a vertex by its share of the way to a displacement.
void SculptingSession::move_to(const BrushedVertex& brushed, const Vec3& displacement)
{
  SkinVertex state = m_skin.vertex(brushed.vertex);
  const double s = share(brushed.weight, state.mask);
  if (s <= 0)
    return;
  // at the whole share the goal itself, not what rounding makes of it
  state.displacement =
      s >= 1 ? displacement : Vec3(state.displacement + s * (displacement - state.displacement));
  change(brushed.vertex, state);
}

void SculptingSession::settle()
{
  if (m_moved.empty())
    return;
  m_skin.settle(m_moved);
  m_moved.clear();
  ++m_revision;
}

void SculptingSession::begin_stroke(const Brush& brush, const SurfacePlace& place, const Vec3& view)
{
  assert(place.triangle >= 0);
  open(name_of(brush.kind));
  m_brush = brush;
  m_view = view;
  if (!brush.drags())
    return dab(place);
  m_area = brush_area(m_skin, brush, place, view, m_distances);
  for (const BrushedVertex& b : m_area.vertices)
    remember(b.vertex);
}

void SculptingSession::drag(const Vec3& drag)
{
  assert(m_stroking && m_brush.drags());
  const Vec3 own = m_brush.strength * drag;
  const Vec3 other = m_brush.symmetry ? m_brush.symmetry->mirrored_vector(own) : Vec3(Vec3::Zero());
  const bool elastic = m_brush.kind == BrushKind::ElasticGrab;
  for (std::size_t i = 0; i < m_area.vertices.size(); ++i)
  {
    const BrushedVertex& b = m_area.vertices[i];
    const SkinVertex& before = m_before[i]; // touched in the area's order
    const double s = share(b.weight, before.mask);
    if (s <= 0)
      continue;
    const Vec3 start = m_skin.rest()[static_cast<std::size_t>(b.vertex)] + before.displacement;
    Vec3 pull = Vec3::Zero();
    if (b.mirrored_share < 1)
      pull += (1 - b.mirrored_share) *
              (elastic ? elastic_drag(start - m_area.place.point, own, m_brush.radius_mm) : own);
    if (b.mirrored_share > 0)
      pull +=
          b.mirrored_share *
          (elastic ? elastic_drag(start - m_area.mirror->point, other, m_brush.radius_mm) : other);
    change(b.vertex, {before.displacement + s * pull, before.mask});
  }
  settle();
}

void SculptingSession::dab(const SurfacePlace& place)
{
  assert(m_stroking && !m_brush.drags());
  const BrushArea area = brush_area(m_skin, m_brush, place, m_view, m_distances);
  switch (m_brush.kind)
  {
  case BrushKind::Draw:
    draw(area);
    break;
  case BrushKind::Smooth:
    smooth(area);
    break;
  case BrushKind::Flatten:
    flatten(area);
    break;
  default:
    blend(area);
  }
  settle();
}

/// Along the mean normal of each side: every vertex's own would blow up noise.
void SculptingSession::draw(const BrushArea& area)
{
  Vec3 normal[2] = {Vec3::Zero(), Vec3::Zero()};
  for (const BrushedVertex& b : area.vertices)
  {
    const Vec3& n = m_skin.normals()[static_cast<std::size_t>(b.vertex)];
    normal[0] += (1 - b.mirrored_share) * b.weight * n;
    normal[1] += b.mirrored_share * b.weight * n;
  }
  const double height = (m_brush.inverted ? -0.1 : 0.1) * m_brush.radius_mm * m_brush.strength;
  for (Vec3& n : normal)
    n = n.norm() > 0 ? Vec3(height / n.norm() * n) : Vec3(Vec3::Zero());
  for (const BrushedVertex& b : area.vertices)
  {
    SkinVertex state = m_skin.vertex(b.vertex);
    const Vec3 step = (1 - b.mirrored_share) * normal[0] + b.mirrored_share * normal[1];
    state.displacement += share(b.weight, state.mask) * step;
    change(b.vertex, state);
  }
}

/// Towards the mean displacement of the neighbours.
void SculptingSession::smooth(const BrushArea& area)
{
  std::vector<Vec3> means;
  means.reserve(area.vertices.size());
  for (const BrushedVertex& b : area.vertices)
  {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const int v : m_skin.links().neighbours_of(b.vertex))
    {
      sum += m_skin.displacement()[static_cast<std::size_t>(v)];
      ++count;
    }
    means.push_back(sum / std::max(count, 1));
  }
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    BrushedVertex b = area.vertices[i];
    b.weight *= m_brush.strength;
    move_to(b, means[i]);
  }
}

/// Towards each side's mean plane.
void SculptingSession::flatten(const BrushArea& area)
{
  Vec3 middle[2] = {Vec3::Zero(), Vec3::Zero()}, normal[2] = {Vec3::Zero(), Vec3::Zero()};
  double weight[2] = {0, 0};
  for (const BrushedVertex& b : area.vertices)
    for (int side = 0; side < 2; ++side)
    {
      const auto v = static_cast<std::size_t>(b.vertex);
      const double w = b.weight * (side == 0 ? 1 - b.mirrored_share : b.mirrored_share);
      middle[side] += w * m_skin.points()[v];
      normal[side] += w * m_skin.normals()[v];
      weight[side] += w;
    }
  for (int side = 0; side < 2; ++side)
    if (weight[side] > 0 && normal[side].norm() > 0)
    {
      middle[side] /= weight[side];
      normal[side].normalize();
    }
  for (BrushedVertex b : area.vertices)
  {
    const auto v = static_cast<std::size_t>(b.vertex);
    const double shares[2] = {1 - b.mirrored_share, b.mirrored_share};
    Vec3 step = Vec3::Zero();
    for (int side = 0; side < 2; ++side)
      step -= shares[side] * normal[side].dot(m_skin.points()[v] - middle[side]) * normal[side];
    b.weight *= m_brush.strength;
    move_to(b, m_skin.displacement()[v] + step);
  }
}

/// Erase, mask and unmask: towards a fixed value.
void SculptingSession::blend(const BrushArea& area)
{
  for (BrushedVertex b : area.vertices)
  {
    b.weight *= m_brush.strength;
    SkinVertex state = m_skin.vertex(b.vertex);
    if (!m_brush.masks())
    {
      // what no eye can see is erased at once, or it would never be exactly 0
      if (state.mask == 0 && state.displacement.norm() < 0.005)
        b.weight = 1;
      move_to(b, Vec3::Zero());
      continue;
    }
    const double goal = m_brush.kind == BrushKind::Mask ? 1 : 0;
    state.mask = b.weight >= 1 ? goal : state.mask + b.weight * (goal - state.mask);
    // so that a brush held long enough protects fully, not nearly
    if (std::abs(state.mask - goal) < 0.02)
      state.mask = goal;
    change(b.vertex, state);
  }
}

void SculptingSession::begin_warp(std::vector<Vec3> from, double radius_mm, const std::string& name)
{
  open(name);
  m_brush = {};
  m_warp_from = std::move(from);
  m_warp_radius_mm = radius_mm;
  for (std::size_t v = 0; v < m_skin.size(); ++v)
    for (const Vec3& p : m_warp_from)
      if ((m_skin.points()[v] - p).norm() < radius_mm)
        remember(static_cast<int>(v));
}

void SculptingSession::drag_warp(const std::vector<Vec3>& to)
{
  assert(m_stroking);
  const LandmarkWarp warp(m_warp_from, to, m_warp_radius_mm);
  for (std::size_t i = 0; i < m_touched.size(); ++i)
  {
    const SkinVertex& before = m_before[i];
    if (before.mask >= 1)
      continue;
    const Vec3 start = m_skin.rest()[static_cast<std::size_t>(m_touched[i])] + before.displacement;
    change(m_touched[i],
           {before.displacement + (1 - before.mask) * warp.displacement(start), before.mask});
  }
  settle();
}

void SculptingSession::end_stroke()
{
  if (!m_stroking)
    return;
  m_stroking = false;
  Stroke stroke{m_name, {}, {}, {}};
  stroke.vertices.reserve(m_touched.size());
  stroke.before.reserve(m_touched.size());
  stroke.after.reserve(m_touched.size());
  for (std::size_t i = 0; i < m_touched.size(); ++i)
  {
    const int v = m_touched[i];
    m_slot[static_cast<std::size_t>(v)] = -1;
    if (m_skin.vertex(v) == m_before[i])
      continue;
    stroke.vertices.push_back(v);
    stroke.before.push_back(m_before[i]);
    stroke.after.push_back(m_skin.vertex(v));
  }
  m_touched.clear();
  m_before.clear();
  if (!stroke.vertices.empty())
    m_history.add(std::move(stroke));
}

void SculptingSession::cancel_stroke()
{
  for (std::size_t i = 0; i < m_touched.size(); ++i)
    change(m_touched[i], m_before[i]);
  settle();
  end_stroke();
}

void SculptingSession::replace(const std::vector<Vec3>& displacement, const std::string& name)
{
  if (displacement.size() != m_skin.size())
    throw Error("target displacement",
                "it has " + std::to_string(displacement.size()) + " vectors, the skin " +
                    std::to_string(m_skin.size()) + " vertices",
                "make it on this skin");
  for (const Vec3& d : displacement)
    if (!d.allFinite())
      throw Error("target displacement", "it holds a value that is not finite", "make it anew");
  open(name);
  for (std::size_t v = 0; v < displacement.size(); ++v)
    change(static_cast<int>(v), {displacement[v], m_skin.mask()[v]});
  settle();
  end_stroke();
}

void SculptingSession::fill_mask(double value)
{
  open(value > 0 ? "Mask all" : "Clear mask");
  for (std::size_t v = 0; v < m_skin.size(); ++v)
    change(static_cast<int>(v), {m_skin.displacement()[v], value});
  settle();
  end_stroke();
}

void SculptingSession::invert_mask()
{
  open("Invert mask");
  for (std::size_t v = 0; v < m_skin.size(); ++v)
    change(static_cast<int>(v), {m_skin.displacement()[v], 1 - m_skin.mask()[v]});
  settle();
  end_stroke();
}

bool SculptingSession::undo()
{
  if (m_stroking || !m_history.undo(m_skin))
    return false;
  ++m_revision;
  return true;
}

bool SculptingSession::redo()
{
  if (m_stroking || !m_history.redo(m_skin))
    return false;
  ++m_revision;
  return true;
}

} // namespace f2b
