#include "Core/geometry/virtual_skull_parts.hpp"

#include <cmath>

namespace f2b
{
namespace
{

/// One tooth of the right side: where its crown stands and how large it is [mm].
struct Tooth
{
  double r, a;  ///< centre of the crown
  double width; ///< along the arch
  double depth; ///< across the arch
  double root;  ///< length of the root
};

constexpr double crown_height = 9;
constexpr double upper_edge = -72; ///< S of the upper cusps and edges
constexpr double lower_edge = -75; ///< of the lower ones: the bite is open by 3 mm

/// `up` is +1 for upper teeth (roots upwards), -1 for lower ones.
void add_tooth(Sculpture& s, const Tooth& tooth, const Vec3& centre, double up)
{
  // The arch is close to an ellipse around (0, 42): its tangent turns each crown.
  const double across = std::atan2(tooth.r * 1.6, tooth.a - 42) * 57.29578;
  const double edge = up > 0 ? upper_edge : lower_edge;
  const Vec3 crown(centre.x(), centre.y(), edge + up * 0.5 * crown_height);
  const Mat3 axes = turned(0, 0, -across);
  const bool incisor = tooth.depth < 7;
  const double half_depth = 0.5 * tooth.depth - (incisor ? 0.6 : 0);
  s.add(RoundedBox{crown, {0.5 * tooth.width, half_depth, 0.5 * crown_height}, 1.6, axes}, 0.6);
  const double r = 0.36 * std::min(tooth.width, tooth.depth);
  const Vec3 neck = crown + Vec3(0, 0, up * (0.5 * crown_height - 1));
  s.add(Capsule{neck, r, neck + Vec3(0, incisor ? -4 : -2, up * tooth.root), 0.6 * r}, 1);
}

} // namespace

Sculpture upper_teeth(const MidfaceShift& midface)
{
  Sculpture s;
  for (const Tooth& t :
       {Tooth{4.3, 83.2, 8.5, 6.6, 11}, Tooth{11.6, 80.8, 6.6, 6.2, 11},
        Tooth{17.8, 76, 7.6, 7.8, 14}, Tooth{22, 69.6, 7, 8.6, 11}, Tooth{24.8, 62.8, 6.8, 8.8, 11},
        Tooth{27.2, 54, 10.2, 10.2, 9}, Tooth{28.6, 44, 9.6, 10, 9}})
    add_tooth(s, t, midface(t.r, t.a, upper_edge), 1);
  return s;
}

Sculpture lower_teeth()
{
  Sculpture s;
  for (const Tooth& t :
       {Tooth{2.75, 79.6, 5.5, 6.2, 10}, Tooth{8.2, 78.4, 6, 6.2, 11},
        Tooth{14.2, 75.2, 7, 7.4, 13}, Tooth{18.8, 70.3, 7, 7.6, 11}, Tooth{21.8, 63.8, 7, 8, 11},
        Tooth{24.6, 54.8, 11, 10, 9}, Tooth{26.8, 44.2, 10.4, 9.8, 9}})
    add_tooth(s, t, {t.r, t.a, lower_edge}, -1);
  return s;
}

namespace
{

void add_body(Sculpture& s)
{
  const std::vector<Vec3> alveolar = {{0, 74, -88},  {10, 72.5, -88}, {18.5, 67, -88},
                                      {24, 55, -88}, {29, 41, -87},   {40, 28, -84}};
  const std::vector<Vec3> basal = {{0, 72.5, -105}, {13, 71, -105},  {24, 62, -104},
                                   {32, 50, -101},  {39, 35, -96.5}, {44.5, 20, -90}};
  for (std::size_t i = 0; i + 1 < basal.size(); ++i)
    s.add(Sheet{alveolar[i], alveolar[i + 1], basal[i + 1], basal[i], 5.2}, 1);
  s.add(Ellipsoid{{0, 72, -104}, {16, 8.5, 8.5}}, 5); // mental protuberance
  s.add(Ellipsoid{{11, 71, -107}, {8, 6, 5.5}}, 4);   // mental tubercle
}

void add_ramus(Sculpture& s)
{
  s.add(Sheet{{43, 29, -84}, {45, 20, -88}, {47, 10, -86}, {46.5, 20, -56}, 4.2}, 5);
  s.add(Sheet{{44, 27, -80}, {47, 10, -84}, {48.5, 2, -50}, {47, 22, -54}, 3.6}, 4);
  s.add(Ellipsoid{{47, 13, -84}, {5, 10, 10}}, 5);                       // angle
  s.add(Capsule{{47, 20, -56}, 4, {47.5, 21, -43}, 2.4}, 4);             // coronoid process
  s.add(Capsule{{48.5, 4, -52}, 4.5, {49.5, -2, -34}, 3.6}, 4);          // neck
  s.add(Ellipsoid{{50, -3, -29}, {8.5, 4.6, 4.8}, turned(0, 0, 12)}, 3); // condyle
}

} // namespace

Sculpture mandible_bone()
{
  Sculpture s;
  add_body(s);
  add_ramus(s);
  s.cut(Capsule{{28, 64, -97}, 1.6, {34, 68, -96}, 1.6}, 1); // mental foramen
  return s;
}

} // namespace f2b
