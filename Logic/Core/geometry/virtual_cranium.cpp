#include "Core/geometry/virtual_skull_parts.hpp"

namespace f2b
{

Sculpture brain_case()
{
  Sculpture s;
  s.add(Ellipsoid{{0, -3, 34}, {60, 88, 66}});
  s.add(Ellipsoid{{0, -28, 38}, {70, 60, 58}}, 16);     // parietal and occipital
  s.add(RoundedBox{{0, 26, 34}, {57, 55, 52}, 44}, 16); // frontal
  s.add(Ellipsoid{{0, -14, 8}, {64, 68, 44}}, 12);      // temporal
  s.keep(HalfSpace{{0, 80, 6}, Vec3(0, 0.36, -0.933).normalized()}, 14);
  return s;
}

namespace
{

void add_brow(Sculpture& s, const MidfaceShift& m)
{
  s.add(Tube{{{0, 78, 13}, m(14, 78, 14.5), m(27, 76, 18), m(40, 68, 16.5), m(50, 59, 9)},
             {7, 6, 5, 5, 4.5}},
        12);
  s.add(Tube{{{50, 60, 9}, m(50.5, 57, -6), m(49, 56, -20)}, {4.2, 4, 6}}, 3);
}

void add_nose_bones(Sculpture& s, const MidfaceShift& m)
{
  s.add(Tube{{{0, 75, 9}, m(0, 81, 0), m(0, 87, -13)}, {6.5, 5, 4}}, 4);
  s.add(Tube{{m(8, 76, 4), m(13, 75, -16), m(16.5, 71, -34), m(15, 70, -48)}, {4, 4.5, 6, 7}}, 4);
  s.add(Sheet{m(2, 80, 2), m(10, 76, 2), m(13, 76, -14), m(2.5, 87, -12), 2.2}, 3);
}

void add_cheek_bones(Sculpture& s, const MidfaceShift& m)
{
  s.add(Tube{{m(48, 58, -21), m(34, 66, -24), m(20, 70, -18), m(14, 73, -8)}, {5, 4, 3.5, 3.5}}, 4);
  s.add(Ellipsoid{m(46, 56, -28), {14, 10, 10.5}, turned(0, 0, -35)}, 5);
  s.add(Tube{{m(50, 53, -34), m(36, 54, -48)}, {5, 7}}, 6); // zygomatico-alveolar crest
}

void add_arches(Sculpture& s, const MidfaceShift& m)
{
  const std::vector<Vec3> path = {m(52, 50, -27), m(60, 36, -27.5), m(62.5, 22, -26),
                                  m(61.5, 8, -22), m(59, -6, -17)};
  for (double offset : {-2.0, 2.0})
  {
    std::vector<Vec3> edge = path;
    for (Vec3& p : edge)
      p.z() += offset;
    s.add(Tube{edge, {3.5, 2.6, 2.3, 2.4, 3}}, 3);
  }
}

void add_maxilla(Sculpture& s, const MidfaceShift& m)
{
  s.add(Ellipsoid{m(27, 52, -38), {17, 20, 18}}, 6);
  s.add(Tube{{m(0, 75, -57), m(12, 72.5, -57), m(21.5, 60, -56), m(26, 45, -56), m(26, 38, -53)},
             {7.5, 8.5, 8, 7.5, 6.5}},
        4);
  s.add(Ellipsoid{m(0, 54, -47), {25, 24.5, 3.8}}, 3);     // palate
  s.add(Capsule{m(0, 70, -47), 4, m(0, 79, -44), 1.4}, 3); // anterior nasal spine
}

void add_deep_walls(Sculpture& s, const MidfaceShift& m)
{
  s.add(Sheet{m(51, 57, 9), m(51, 57, -18), m(23, 17, -14), m(23, 17, 9), 3.2}, 3); // sphenoid wing
  s.add(Sheet{m(12, 68, 4), m(13, 68, -20), m(12, 30, -20), m(12, 30, 4), 1.6}, 2); // ethmoid
  s.add(Sheet{m(14, 60, -22), m(44, 56, -22), m(30, 34, -16), m(14, 34, -16), 1.8}, 2); // floor
  for (double side : {0.0, 8.0}) // pterygoid plates
    s.add(Sheet{m(15, 30, -16), m(14 + side / 2, 18, -16), m(15 + side, 19, -50), m(18, 29, -52),
                1.7},
          2);
}

} // namespace

Sculpture facial_skeleton(const MidfaceShift& midface)
{
  Sculpture s;
  add_brow(s, midface);
  add_nose_bones(s, midface);
  add_cheek_bones(s, midface);
  add_arches(s, midface);
  add_maxilla(s, midface);
  add_deep_walls(s, midface);
  return s;
}

Sculpture skull_base(const MidfaceShift&)
{
  Sculpture s;
  s.add(RoundedBox{{0, 20, -10}, {17, 14, 13}, 6}, 6);        // sphenoid body
  s.add(Capsule{{0, 10, -16}, 10, {0, -16, -34}, 7}, 6);      // clivus
  s.add(Capsule{{18, -6, -22}, 8, {50, -16, -21}, 10}, 6);    // petrous bone
  s.add(Capsule{{54, -27, -22}, 11, {52, -25, -42}, 5.5}, 5); // mastoid process
  s.add(Capsule{{58, 0, -14}, 4.5, {60, -18, -12}, 5}, 5);    // root of the arch
  s.add(Ellipsoid{{14, -26, -43}, {6, 10, 6}}, 4);            // occipital condyle
  s.add(Capsule{{40, 26, -6}, 5, {52, 0, -12}, 6}, 8);        // infratemporal surface
  return s;
}

Sculpture skull_openings(const MidfaceShift& m)
{
  Sculpture s;
  s.cut(Capsule{m(33, 66, -3.5), 17.2, m(18, 30, -1), 6}, 2);
  s.cut(Capsule{m(34, 90, -4), 17.5, m(33, 62, -3.5), 17.2}, 2);
  s.cut(Sheet{m(0, 100, -20), m(0, 28, -20), m(7, 28, -38.5), m(7, 100, -38.5), 4.6}, 1.5);
  s.cut(Capsule{{85, -14, -20}, 3.6, {40, -12, -19}, 3}, 1.5);
  s.cut(Capsule{{0, -40, -80}, 14, {0, -36, -18}, 13}, 3);
  s.cut(Ellipsoid{{0, 14, -2}, {7, 5.8, 7}}, 2);    // pituitary fossa
  s.cut(Ellipsoid{m(28, 73, -30), {2.2, 5, 2}}, 1); // infraorbital foramen
  return s;
}

Sculpture nasal_septum(const MidfaceShift& m)
{
  Sculpture s;
  s.add(Sheet{m(0, 67, -14), m(0, 30, -14), m(0, 30, -46), m(0, 70, -46), 1.4}, 1);
  s.add(Tube{{m(11, 68, -36), m(9, 50, -36), m(10, 32, -37)}, {2, 2.5, 2}}, 1); // lower turbinate
  return s;
}

Sculpture maxillary_sinuses(const MidfaceShift& m)
{
  Sculpture s;
  s.add(Ellipsoid{m(29, 51, -35), {10, 13, 9.5}});
  return s;
}

Sculpture cervical_spine()
{
  Sculpture s;
  s.add(Ring{{0, -34, -59}, {16, 16}, 5}); // atlas
  s.add(Ellipsoid{{20, -27, -58}, {9, 9, 7.5}}, 3);
  s.add(Capsule{{0, -19, -56}, 4.5, {0, -19, -72}, 6}); // dens
  for (int level = 0; level < 6; ++level)
  {
    const double z = -77 - 18.0 * level;
    const double y = -19 + 1.5 * level;
    s.add(RoundedBox{{0, y, z}, {12, 9, 7.6}, 4}, 1);
    s.add(Ring{{0, y - 15, z - 2}, {14, 11}, 4}, 3);
    s.add(RoundedBox{{16.5, y - 11, z}, {7.5, 7, 7.8}, 4}, 3);
    s.add(Capsule{{0, y - 26, z - 3}, 5, {0, y - 34, z - 7}, 4}, 3);
  }
  return s;
}

} // namespace f2b
