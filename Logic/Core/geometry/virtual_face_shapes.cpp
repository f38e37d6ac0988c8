#include "Core/geometry/virtual_face_parts.hpp"

namespace f2b
{

Loft facial_mask(const MidfaceShift& m)
{
  std::vector<LoftSection> sections = {
      {40, 50, 80},  {18, 62, 85},  {0, 66, 80},   {-15, 69.5, 78}, {-30, 71, 80},  {-45, 69, 84},
      {-58, 66, 87}, {-70, 62, 86}, {-84, 57, 84}, {-98, 54, 84},   {-110, 50, 80}, {-122, 45, 73}};
  for (LoftSection& section : sections)
    if (section.superior > -65)
      section.front = m(0, section.front, section.superior).y();
  return Loft(sections, 10, 60, 2.15);
}

Sculpture head_and_neck()
{
  Sculpture s;
  s.add(Ellipsoid{{0, -3, 34}, {66, 94, 72}});
  s.add(Ellipsoid{{0, -28, 38}, {76, 66, 64}}, 16);
  s.add(RoundedBox{{0, 26, 34}, {63, 61, 58}, 50}, 16);
  s.add(Ellipsoid{{0, -14, 8}, {70, 74, 50}}, 12);
  s.keep(HalfSpace{{0, 80, -6}, Vec3(0, 0.36, -0.933).normalized()}, 16);
  s.add(Capsule{{0, -24, -30}, 44, {0, -20, -230}, 54}, 24); // neck
  s.add(Capsule{{56, -24, -40}, 10, {14, 20, -180}, 8}, 16); // sternomastoid
  s.add(Capsule{{0, 26, -122}, 12, {0, 24, -136}, 11}, 22);  // larynx
  return s;
}

namespace
{

void add_brow_and_eyes(Sculpture& s, const MidfaceShift& m)
{
  s.add(Tube{{{0, 79.5, 15}, {24, 78, 17}, {43, 66, 13}, {53, 52, 3}}, {8.5, 8, 8, 8}}, 14);
  s.cut(Ellipsoid{m(31, 88, -5), {16, 15, 11.5}, turned(0, 0, -14)}, 12); // eye socket
  s.cut(Ellipsoid{m(15, 86, -3), {5, 9, 8}}, 8);                          // inner corner
  s.add(Ellipsoid{m(33, 60.5, -4), {15.5, 14, 13}}, 4);                   // lids over the eye
  s.cut(
      Tube{{m(18.5, 73, -6.5), m(25, 75.2, -8.8), m(33, 76, -9.8), m(40, 74, -9), m(48, 66.5, -6)},
           {0.8, 1.1, 1.2, 1.1, 0.6}},
      1.6); // slit
  s.cut(Tube{{m(20, 75, 0), m(27, 76.5, 3.6), m(34, 75.5, 4.4), m(42, 71, 3), m(49, 64, -1)},
             {0.8, 1.2, 1.4, 1.2, 0.6}},
        2.5); // fold of the upper lid
}

void add_nose(Sculpture& s, const MidfaceShift& m)
{
  s.add(Tube{{{0, 77, 6}, m(0, 81, 0), m(0, 91, -16), m(0, 102, -31)}, {7, 7, 7, 8.5}}, 8);
  s.add(Capsule{m(7, 74, -4), 6, m(8, 88, -30), 8}, 12);                 // side walls
  s.add(Ellipsoid{m(2.6, 103.5, -33.5), {6.6, 8.8, 7.6}}, 6);            // tip
  s.add(Ellipsoid{m(12.8, 92.5, -38), {6, 11, 7}, turned(0, 0, 14)}, 6); // wing
  s.add(Capsule{m(0, 104, -39), 4, m(0, 92, -43.5), 4.5}, 4);            // columella
  s.cut(Ellipsoid{m(7, 99, -46), {3.4, 6.5, 3.6}, turned(0, 0, 16)}, 2); // nostril
}

void add_lips(Sculpture& s, const MidfaceShift& m)
{
  s.add(Ellipsoid{m(0, 77, -54), {25, 17.5, 14}}, 8); // fullness above the upper teeth
  s.add(Tube{{m(0, 91.6, -66.6),
              m(5, 92, -65.8),
              m(12, 89, -66.9),
              m(18.5, 85, -68.6),
              {24.5, 79, -70.4}},
             {6.2, 6.2, 5.4, 4.2, 2.4}},
        3);
  s.cut(Capsule{m(0, 101, -48), 3.4, m(0, 102.2, -58), 4.6}, 3.5); // philtrum
  s.add(Tube{{{0, 86.6, -76.4}, {9, 85.4, -76}, {17, 82, -74}, {24.5, 79, -70.8}},
             {6.8, 6.4, 5, 2.4}},
        5);
  s.cut(Tube{{m(0, 97, -71.4), m(9, 95.6, -71.2), m(17, 91.2, -71), {25, 82, -70.6}},
             {0.5, 0.5, 0.5, 0.4}},
        1.5); // lip line
  s.cut(Tube{{{0, 97.8, -90}, {12, 94.8, -91}, {22, 89.5, -88}}, {6, 5, 3.5}},
        10); // below the lower lip
}

void add_cheeks_and_chin(Sculpture& s, const MidfaceShift& m)
{
  s.add(Ellipsoid{m(45, 55, -30), {19, 17, 15}}, 14);                             // cheek bone
  s.add(Ellipsoid{m(36, 58, -52), {20, 19, 24}}, 16);                             // cheek
  s.cut(Tube{{m(18, 95, -40), m(25, 90, -53), {33, 85, -68}}, {3, 3.5, 2.5}}, 9); // nasolabial fold
  s.add(Ellipsoid{{41, 50, -74}, {14, 20, 18}}, 16); // beside the mouth
  s.add(Ellipsoid{{50, 16, -74}, {10, 22, 26}}, 16); // chewing muscle
  s.add(Ellipsoid{{0, 75, -106}, {21, 16, 13}}, 10); // chin
  s.add(Ellipsoid{{10, 74, -107}, {12, 14, 11}}, 8);
}

} // namespace

Sculpture facial_features(const MidfaceShift& midface)
{
  Sculpture s;
  add_cheeks_and_chin(s, midface);
  add_brow_and_eyes(s, midface);
  add_nose(s, midface);
  add_lips(s, midface);
  return s;
}

Sculpture ear()
{
  // Columns: along the length of the ear, along its breadth, outwards.
  const Mat3 axes =
      turned(0, 0, 28) * turned(-14, 0, 0) * (Mat3() << 0, 0, 1, 0, 1, 0, 1, 0, 0).finished();
  const Vec3 centre(75, -23, -14);
  auto at = [&](double along, double across, double out)
  { return Vec3(centre + axes * Vec3(along, across, out)); };
  Sculpture s;
  s.add(Ellipsoid{at(2, 0, -1), {29, 16, 4.5}, axes});
  s.add(Ellipsoid{at(-8, 4, -5), {16, 12, 9}, axes}, 4); // root on the head
  s.cut(Ellipsoid{at(5, 1, 6), {21, 11, 6.5}, axes}, 2);
  s.add(Ring{at(3, -1, 1), {27, 15}, 3, axes}, 2);          // helix
  s.add(Ring{at(6, -1.5, 0), {17, 8.5}, 2.6, axes}, 3);     // antihelix
  s.cut(Ellipsoid{at(-6, 3, 4.5), {10.5, 8, 10}, axes}, 2); // concha
  s.add(Ellipsoid{at(-6, 12, 0), {6, 3.2, 5}, axes}, 2.5);  // tragus
  s.add(Ellipsoid{at(-25, 4, -1), {9, 8, 4}, axes}, 4);     // lobe
  return s;
}

Sculpture upper_airway(const MidfaceShift& m)
{
  Sculpture s;
  s.add(Tube{{m(7.5, 101, -50), m(7, 95, -41), m(6, 82, -34)}, {3.2, 3.6, 3.6}}); // nostril
  s.add(Sheet{m(5, 80, -22), m(4.5, 30, -22), m(6.5, 30, -38), m(6.5, 80, -38), 3.4}, 2);
  s.cut(Sheet{m(0, 90, -14), m(0, 30, -14), m(0, 30, -46), m(0, 90, -46), 2.6}, 1); // septum
  s.add(Tube{{m(0, 30, -30), {0, 14, -38}, {0, 4, -60}, {0, 6, -95}, {0, 12, -125}, {0, 8, -190}},
             {6, 7, 6, 6, 6, 7}},
        4); // throat and windpipe
  return s;
}

Sculpture soft_muscles(const MidfaceShift& m)
{
  Sculpture s;
  s.add(Capsule{m(58, 42, -34), 7, {52, 14, -82}, 8});       // masseter
  s.add(Ellipsoid{{50, 24, 8}, {14, 32, 40}});               // temporalis
  s.add(Ring{m(0, 80, -68), {20, 11}, 5, turned(90, 0, 0)}); // orbicularis oris
  s.add(Capsule{m(24, 76, -66), 3, {40, 34, -70}, 4});       // buccinator
  s.add(Ellipsoid{{0, 44, -74}, {20, 30, 18}});              // tongue
  s.add(Ellipsoid{m(32, 56, -4), {12.5, 12.5, 12.5}});       // eye
  s.add(Ellipsoid{{0, 82, 24}, {44, 4, 26}});                // frontalis
  s.add(Capsule{{0, -40, -40}, 46, {0, -28, -190}, 47});     // neck
  return s;
}

} // namespace f2b
