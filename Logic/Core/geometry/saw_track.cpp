#include "Core/geometry/saw_track.hpp"

#include "Core/error.hpp"

#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

using Vec2 = SawTrack::Vec2;

/// Two vertices nearer than this, seen along the saw, are one.
constexpr double same_place_mm = 0.02;

double cross(const Vec2& a, const Vec2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

Vec2 left_of(const Vec2& along)
{
  return {-along.y(), along.x()};
}

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
  const bool c_d = (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0);
  const bool a_b = (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
  return c_d && a_b;
}

std::string place_of(const Vec3& p)
{
  char text[64];
  std::snprintf(text, sizeof text, "(%.1f, %.1f, %.1f)", p.x(), p.y(), p.z());
  return text;
}

} // namespace

SawTrack::SawTrack(const SweptCurve& curve, double width_mm)
{
  const std::string who = "curve '" + curve.name + "'";
  if (!(curve.direction.norm() > 1e-6) || !curve.direction.allFinite())
    throw Error(who, "its saw direction has no length", "give a direction");
  if (!(curve.depth_mm + curve.lead_mm > 1e-3))
    throw Error(who, "the blade has no depth", "give a depth_mm above 0");
  m_z = curve.direction.normalized();
  m_x = m_z.unitOrthogonal();
  m_y = m_z.cross(m_x);
  place_stations(curve);
  if (m_stations.size() < (curve.closed ? 3U : 2U))
    throw Error(who,
                "seen along the saw it has " + std::to_string(m_stations.size()) + " places, " +
                    (curve.closed ? "3" : "2") + " are needed",
                "draw it longer, or turn the saw direction");
  offset_sides(curve, width_mm);
  require_apart(curve);
}

void SawTrack::place_stations(const SweptCurve& curve)
{
  auto same = [](const Station& a, const Station& b)
  { return (a.middle - b.middle).norm() < same_place_mm; };
  for (const Vec3& p : curve.points)
  {
    Station s;
    s.middle = {m_x.dot(p), m_y.dot(p)};
    s.height = m_z.dot(p);
    if (m_stations.empty() || !same(m_stations.back(), s))
      m_stations.push_back(s);
  }
  while (curve.closed && m_stations.size() > 1 && same(m_stations.back(), m_stations.front()))
    m_stations.pop_back();
}

void SawTrack::offset_sides(const SweptCurve& curve, double width_mm)
{
  const std::size_t n = m_stations.size();
  auto along = [&](std::size_t i)
  { return Vec2((m_stations[(i + 1) % n].middle - m_stations[i].middle).normalized()); };
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool first = i == 0 && !curve.closed, last = i + 1 == n && !curve.closed;
    const Vec2 before = first ? along(i) : along((i + n - 1) % n), after = last ? before : along(i);
    const Vec2 sum = left_of(before) + left_of(after);
    // the mitre of a turn by more than about 140 degrees is a spike
    if (sum.norm() < 0.7)
      throw Error("curve '" + curve.name + "'",
                  "it turns back on itself at " +
                      place_of(point(m_stations[i].middle, m_stations[i].height)),
                  "draw the corner blunter, or as two curves");
    const Vec2 half = sum * (width_mm / sum.squaredNorm());
    m_stations[i].left = m_stations[i].middle + half;
    m_stations[i].right = m_stations[i].middle - half;
  }
}

void SawTrack::require_apart(const SweptCurve& curve) const
{
  const std::size_t n = m_stations.size(), segments = curve.closed ? n : n - 1;
  auto refuse = [&](std::size_t i)
  {
    throw Error("curve '" + curve.name + "'",
                "seen along the saw it comes back to itself, or turns within the kerf, at " +
                    place_of(point(m_stations[i].middle, m_stations[i].height)),
                "draw it without loops, use a smaller kerf, or turn the saw direction");
  };
  for (std::size_t i = 0; i < segments; ++i)
  {
    const Station &a = m_stations[i], &b = m_stations[(i + 1) % n];
    const Vec2 along = b.middle - a.middle;
    if (!((b.left - a.left).dot(along) > 0) || !((b.right - a.right).dot(along) > 0))
      refuse(i);
    for (std::size_t j = i + 1; j < segments; ++j)
    {
      const Station &c = m_stations[j], &d = m_stations[(j + 1) % n];
      const bool adjacent = j == i + 1 || (curve.closed && i == 0 && j + 1 == segments);
      const Vec2* first[2][2] = {{&a.left, &b.left}, {&a.right, &b.right}};
      const Vec2* second[2][2] = {{&c.left, &d.left}, {&c.right, &d.right}};
      for (int side = 0; side < 2; ++side)
        for (int other = 0; other < 2; ++other)
          if (!(adjacent && side == other) &&
              cross_each_other(*first[side][0], *first[side][1], *second[other][0],
                               *second[other][1]))
            refuse(i);
    }
  }
}

} // namespace f2b
