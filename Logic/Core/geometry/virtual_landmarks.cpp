#include "Core/geometry/virtual_landmarks.hpp"

#include "Core/error.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

using Surface = std::function<double(const Vec3&)>;

constexpr double far = 130; ///< a sight line begins this far from the place it looks at [mm]

/// First point of the surface on the way from `far` outside towards `place` and a little beyond.
Vec3 seen(const Surface& surface, const Vec3& place, const Vec3& from, double start = far)
{
  const Vec3 outwards = from.normalized();
  double t = start, before = start;
  const double step = 0.2;
  while (t > -15 && surface(place + t * outwards) > 0)
  {
    before = t;
    t -= std::max(step, 0.5 * surface(place + t * outwards));
  }
  if (t <= -15)
    throw Error("virtual patient", "a landmark's sight line misses its surface",
                "report this as a bug with the options used");
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (t + before);
    (surface(place + middle * outwards) > 0 ? before : t) = middle;
  }
  return place + t * outwards;
}

void add_pair(std::vector<NamedPoint>& points, const std::string& name, const Vec3& right)
{
  points.push_back({name + "_R", right});
  points.push_back({name + "_L", {-right.x(), right.y(), right.z()}});
}

void add_cranium(std::vector<NamedPoint>& out, const Surface& bone, const MidfaceShift& m)
{
  const Vec3 front = Vec3::UnitY(), below = -Vec3::UnitZ(), right = Vec3::UnitX();
  out.push_back({"N", seen(bone, {0, 75, 5}, front)});
  out.push_back({"S", {0, 14, -4}}); // the middle of virtual_cranium's pituitary fossa
  add_pair(out, "Or", seen(bone, m(33, 66, -23), {0, 1, 0.6}));
  add_pair(out, "Po", seen(bone, {56, -14, -15.5}, right));
  add_pair(out, "Zy", seen(bone, m(60, 24, -26), right));
  out.push_back({"ANS", seen(bone, m(0, 74, -44), front)});
  // From the throat forwards to the back edge of the palate.
  out.push_back({"PNS", seen(bone, m(0, 34, -47), -front, 14)});
  out.push_back({"A", seen(bone, m(0, 74, -50), front)});
  out.push_back({"U1", seen(bone, m(0, 83.2, -70), below, 1.8)});
  add_pair(out, "U6", seen(bone, m(27.2, 54, -70), below, 3));
}

void add_mandible(std::vector<NamedPoint>& out, const Surface& mandible)
{
  const Vec3 front = Vec3::UnitY(), below = -Vec3::UnitZ(), above = Vec3::UnitZ();
  out.push_back({"L1", seen(mandible, {0, 79.6, -77}, above, 4)});
  out.push_back({"B", seen(mandible, {0, 74, -91}, front)});
  out.push_back({"Pg", seen(mandible, {0, 74, -103.5}, front)});
  out.push_back({"Me", seen(mandible, {0, 72, -108}, below)});
  out.push_back({"Gn", seen(mandible, {0, 74, -106}, {0, 1, -1})});
  add_pair(out, "Go", seen(mandible, {46, 14, -86}, {0, -1, -1}));
  add_pair(out, "Co", seen(mandible, {50, -3, -29}, above, 20));
}

void add_soft_tissue(std::vector<NamedPoint>& out, const Surface& skin, const MidfaceShift& m)
{
  const Vec3 front = Vec3::UnitY(), below = -Vec3::UnitZ();
  out.push_back({"N'", seen(skin, {0, 80, 5}, front)});
  out.push_back({"prn", seen(skin, m(0, 100, -33), front)});
  out.push_back({"sn", seen(skin, m(0, 85, -47.5), {0, 1, -0.3}, 40)});
  out.push_back({"cm", seen(skin, m(0, 103, -43), below, 18)});
  out.push_back({"ls", seen(skin, m(0, 88, -64), front)});
  out.push_back({"li", seen(skin, {0, 88, -76.5}, front)});
  out.push_back({"Pg'", seen(skin, {0, 80, -105}, front)});
  out.push_back({"Me'", seen(skin, {0, 70, -110}, below, 60)});
  add_pair(out, "ch", seen(skin, {25.5, 70, -70.5}, {0.5, 1, 0}));
  add_pair(out, "Or'", seen(skin, m(33, 66, -22), front));
}

} // namespace

std::vector<NamedPoint> virtual_landmarks(const LandmarkSurfaces& surfaces,
                                          const MidfaceShift& midface)
{
  std::vector<NamedPoint> points;
  add_cranium(points, surfaces.bone, midface);
  add_mandible(points, surfaces.mandible);
  add_soft_tissue(points, surfaces.skin, midface);
  return points;
}

} // namespace f2b
