#include "Core/geometry/osteotomy_templates.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace f2b
{
namespace
{

/// Landmarks with the patient's own axes.
class Face
{
public:
  Face(const std::string& template_name, const Landmarks& landmarks)
      : m_template(template_name), m_landmarks(landmarks),
        right((at("Or_R") - at("Or_L")).normalized())
  {
  }
  bool has(const std::string& name) const { return m_landmarks.count(name) > 0; }
  const Vec3& at(const std::string& name) const
  {
    const auto found = m_landmarks.find(name);
    if (found == m_landmarks.end())
      throw Error("template '" + m_template + "'", "the landmark '" + name + "' is not there",
                  "add it to the case's landmark file");
    return found->second;
  }

  Vec3 outwards(const std::string& side) const { return side == "R" ? right : Vec3(-right); }

private:
  std::string m_template;
  const Landmarks& m_landmarks;

public:
  Vec3 right;
};

/// Component of v at right angles to a unit axis, normalised.
Vec3 across(const Vec3& v, const Vec3& axis)
{
  return (v - axis * axis.dot(v)).normalized();
}

/// A plane as wide as the skull, from one edge to the other, both parallel to the patient's right.
BoundedPlane plane_between(const std::string& name, const Vec3& right, const Vec3& from,
                           const Vec3& to, double width_mm)
{
  BoundedPlane plane;
  plane.name = name;
  plane.u = right;
  plane.v = across(to - from, right);
  plane.center = 0.5 * (from + to);
  plane.half_u = 0.5 * width_mm;
  plane.half_v = 0.5 * std::abs(plane.v.dot(to - from));
  return plane;
}

/// As wide as the tooth-bearing maxilla, and no wider: the ramus and the coronoid process beside it
/// stay whole.
double maxilla_width(const Face& face)
{
  return (face.at("U6_R") - face.at("U6_L")).norm() + 30;
}

/// Forwards along the palate, at right angles to the patient's right.
Vec3 palate_forward(const Face& face)
{
  return across(face.at("ANS") - face.at("PNS"), face.right);
}

/// Between the tooth rows, the same for every template, so that both jaws can be cut together.
struct Bite
{
  Vec3 front; ///< in front of the incisors: in the middle of an open bite's gap; where the teeth
              ///< meet or overlap, just below the upper ones
  Vec3 along; ///< forwards along the upper teeth's edges
};

Bite bite_of(const Face& face, const Vec3& forward)
{
  const Vec3 up = face.right.cross(forward);
  const Vec3 molars = 0.5 * (face.at("U6_R") + face.at("U6_L"));
  const double gap = face.has("L1") ? (face.at("U1") - face.at("L1")).dot(up) : 0;
  return {face.at("U1") - std::clamp(0.5 * gap, 0.5, 3.0) * up + 12 * forward,
          across(face.at("U1") - molars, face.right)};
}

/// The planes behind and below the maxilla that Le Fort I and III share.
/// \param back_top  where the upper cut ends behind
/// \param back_width_mm  of the plane behind
void part_maxilla_from_below(const Face& face, const Vec3& forward, const Vec3& back_top,
                             double back_width_mm, Osteotomy& osteotomy)
{
  const Vec3 up = face.right.cross(forward);
  const Bite bite = bite_of(face, forward);
  const double depth = (bite.front - back_top).dot(forward) / bite.along.dot(forward) + 3;
  const Vec3 bite_back = bite.front - depth * bite.along;
  osteotomy.planes.push_back(plane_between(osteotomy.fragment + " posterior", face.right,
                                           back_top + 3 * up, bite_back - 4 * up, back_width_mm));
  osteotomy.planes.push_back(plane_between(osteotomy.fragment + " occlusal", face.right, bite.front,
                                           bite_back, maxilla_width(face)));
}

Osteotomy le_fort_1(const Face& face)
{
  Osteotomy osteotomy;
  const Vec3 forward = palate_forward(face);
  const Vec3 up = face.right.cross(forward);
  const Vec3 front = face.at("ANS") + 20 * forward + 5 * up;
  const Vec3 back = face.at("PNS") - 4 * forward + 5 * up;
  osteotomy.fragment = "maxilla";
  osteotomy.planes.push_back(
      plane_between("maxilla upper", face.right, front, back - 3 * forward, 130));
  part_maxilla_from_below(face, forward, back, maxilla_width(face), osteotomy);
  osteotomy.fragment_point = face.at("ANS") - 5 * forward - 3 * up;
  return osteotomy;
}

/// The line from inside the orbit over its lower rim to under the zygoma's buttress, and out.
/// \param rim  where it crosses the rim
std::vector<Vec3> down_the_cheek(const Face& face, const std::string& side, const Vec3& rim)
{
  const Vec3 up = face.right.cross(palate_forward(face));
  const Vec3 outwards = face.outwards(side);
  const Vec3 buttress = face.at("U6_" + side) + 12 * outwards + 14 * up;
  return {rim + 8 * up, rim, buttress, buttress + 14 * outwards - 8 * up};
}

/// A line seen from in front, sawn straight backwards; all its points as far in front as the first
/// landmark of `from`.
SweptCurve sawn_backwards(const std::string& name, const Vec3& forward, std::vector<Vec3> points,
                          const Vec3& from, const Vec3& to)
{
  for (Vec3& p : points)
    p += forward * forward.dot(from - p);
  SweptCurve curve;
  curve.name = name;
  curve.points = std::move(points);
  curve.direction = -forward;
  curve.depth_mm = forward.dot(from - to);
  curve.lead_mm = 30;
  return curve;
}

/// The pyramid: root of the nose, medial walls of the orbits, lower rims, buttresses.
Osteotomy le_fort_2(const Face& face)
{
  Osteotomy osteotomy;
  const Vec3 forward = palate_forward(face);
  const Vec3 up = face.right.cross(forward);
  const Vec3 back = face.at("PNS") - 4 * forward + 18 * up;
  const Vec3 down_the_orbit = across(back - face.at("N"), face.right);
  const Vec3 front = face.at("N") - up - 25 * down_the_orbit;
  osteotomy.fragment = "nose and maxilla";
  osteotomy.planes.push_back(plane_between("nose and maxilla upper", face.right, front,
                                           back + 3 * down_the_orbit,
                                           (face.at("Or_R") - face.at("Or_L")).norm() + 4));
  for (const char* side : {"R", "L"})
  {
    const Vec3 rim = face.at(std::string("Or_") + side) - 2 * face.outwards(side);
    osteotomy.curves.push_back(sawn_backwards(
        std::string("nose and maxilla cheek ") + side, forward, down_the_cheek(face, side, rim),
        face.at(std::string("Or_") + side), back - 3 * forward));
  }
  part_maxilla_from_below(face, forward, back, maxilla_width(face) + 10, osteotomy);
  osteotomy.fragment_point = face.at("ANS") - 5 * forward - 3 * up;
  return osteotomy;
}

/// The lateral rim of the orbit, its floor, the buttress, and the arch behind them.
Osteotomy zygoma(const Face& face, const std::string& side)
{
  Osteotomy osteotomy;
  const Vec3 forward = palate_forward(face);
  const Vec3 up = face.right.cross(forward);
  const Vec3 outwards = face.outwards(side);
  const Vec3 &rim = face.at("Or_" + side), &arch = face.at("Zy_" + side);
  // the frontozygomatic suture is a little below the height of the nasion
  const Vec3 suture = rim + 0.7 * up.dot(face.at("N") - rim) * up + 2 * outwards;
  const Vec3 behind = rim + 0.6 * forward.dot(arch - rim) * forward;
  osteotomy.fragment = side == "R" ? "zygoma right" : "zygoma left";
  std::vector<Vec3> line = {suture + (outwards.dot(arch - suture) + 15) * outwards, suture};
  const std::vector<Vec3> cheek = down_the_cheek(face, side, rim);
  line.insert(line.end(), cheek.begin() + 1, cheek.end());
  osteotomy.curves.push_back(
      sawn_backwards(osteotomy.fragment + " rim", forward, line, rim, behind - 2 * forward));
  BoundedPlane back;
  back.name = osteotomy.fragment + " arch";
  back.u = outwards;
  back.v = up;
  const double width = outwards.dot(arch - rim) + 20, top = up.dot(suture - rim) + 2, bottom = -45;
  back.center = behind + (0.5 * width - 4) * outwards + 0.5 * (top + bottom) * up;
  back.half_u = 0.5 * width;
  back.half_v = 0.5 * (top - bottom);
  osteotomy.planes.push_back(back);
  osteotomy.fragment_point = rim + 0.35 * (arch - rim);
  return osteotomy;
}

Osteotomy le_fort_3(const Face& face)
{
  Osteotomy osteotomy;
  const Vec3 forward = palate_forward(face);
  const Vec3 up = face.right.cross(forward);
  const Vec3 back = face.at("PNS") - 4 * forward + 18 * up;
  const Vec3 down_the_orbit = across(back - face.at("N"), face.right);
  const Vec3 front = face.at("N") - up - 25 * down_the_orbit;
  osteotomy.fragment = "mid-face";
  osteotomy.planes.push_back(
      plane_between("mid-face upper", face.right, front, back + 3 * down_the_orbit, 160));
  part_maxilla_from_below(face, forward, back, 150, osteotomy); // through both zygomatic arches
  osteotomy.fragment_point = face.at("ANS") - 5 * forward - 3 * up;
  return osteotomy;
}

Osteotomy genioplasty(const Face& face)
{
  Osteotomy osteotomy;
  const Vec3 below_b = 0.5 * (face.at("B") + face.at("Pg"));
  const Vec3 gonion = 0.5 * (face.at("Go_R") + face.at("Go_L"));
  const Vec3 border = face.at("Me") + 0.45 * (gonion - face.at("Me"));
  const Vec3 backward = across(border - below_b, face.right);
  osteotomy.fragment = "chin";
  osteotomy.planes.push_back(
      plane_between("chin", face.right, below_b - 20 * backward, border + 12 * backward, 100));
  osteotomy.fragment_point = face.at("Pg");
  return osteotomy;
}

/// The vertical plane across one side of the mandible, behind its molars: from under the lower
/// border to above the bite.
BoundedPlane behind_molars(const Face& face, const std::string& side, const Bite& bite)
{
  const Vec3 up = face.right.cross(bite.along);
  const Vec3& menton = face.at("Me");
  const Vec3 body = face.at("Go_" + side) - menton;
  // the lower second molar ends about 15 mm behind the upper first one's middle
  const Vec3 behind = face.at("U6_" + side) - 15 * bite.along;
  const double share =
      std::clamp((behind - menton).dot(bite.along) / body.dot(bite.along), 0.55, 0.85);
  const Vec3 border = menton + share * body;
  const double top = (bite.front - border).dot(up) + 4, bottom = -15;
  BoundedPlane plane;
  plane.name = "mandible behind molars " + side;
  plane.u = up;
  plane.v = across(body, up).cross(up);
  // the body bulges outwards from the line between menton and gonion
  const Vec3 outwards = face.outwards(side);
  plane.center =
      border + 0.5 * (top + bottom) * up + (plane.v.dot(outwards) > 0 ? 8 : -8) * plane.v;
  plane.half_u = 0.5 * (top - bottom);
  plane.half_v = 26;
  return plane;
}

/// The sagittal split's overlapping halves are one plane a side: what moves is the same bone.
Osteotomy bsso(const Face& face)
{
  Osteotomy osteotomy;
  const Bite bite = bite_of(face, palate_forward(face));
  osteotomy.fragment = "mandible";
  for (const char* side : {"R", "L"})
    osteotomy.planes.push_back(behind_molars(face, side, bite));
  // Teeth that touch in the CT join the jaws. It ends at the planes behind the molars: the rami stay
  // whole, so that they may be fragments too.
  double depth = 0;
  for (const BoundedPlane& plane : osteotomy.planes)
    depth = std::max(depth, (bite.front - plane.center).dot(bite.along) + 6);
  const double width = (face.at("Go_R") - face.at("Go_L")).norm() + 30;
  osteotomy.planes.push_back(plane_between("mandible occlusal", face.right, bite.front,
                                           bite.front - depth * bite.along, width));
  osteotomy.planes.back().may_miss = true;
  // above any cut of the chin
  osteotomy.fragment_point = face.at("B") + 4 * face.right.cross(bite.along) - 3 * bite.along;
  return osteotomy;
}

/// The segment behind a sagittal split: the ramus with its condyle, freed from the joint's socket.
Osteotomy ramus(const Face& face, const std::string& side)
{
  Osteotomy osteotomy;
  const Vec3 forward = palate_forward(face);
  const Vec3 up = face.right.cross(forward);
  const Vec3 outwards = face.outwards(side);
  osteotomy.fragment = side == "R" ? "ramus right" : "ramus left";
  const Bite bite = bite_of(face, forward);
  osteotomy.planes.push_back(behind_molars(face, side, bite));
  osteotomy.planes.back().name = osteotomy.fragment + " front";
  // a last molar may meet its fellow behind that plane; the ramus beside it stays whole
  const Vec3& molar = face.at("U6_" + side);
  BoundedPlane occlusal;
  occlusal.name = osteotomy.fragment + " occlusal";
  occlusal.center = bite.front + (molar - bite.front).dot(outwards) * outwards +
                    ((molar - bite.front).dot(bite.along) - 24) * bite.along;
  occlusal.u = bite.along;
  occlusal.v = outwards;
  occlusal.half_u = 12;
  occlusal.half_v = 9;
  occlusal.may_miss = true;
  osteotomy.planes.push_back(occlusal);
  // A CT's voxels bridge the joint's space, above the condyle, behind it and at both its poles: over
  // it from before to behind and down its back, sawn from the side, and down beside each pole. Co is
  // behind the condyle's middle.
  constexpr double radius = 9, outer = 9, inner = 12;
  const Vec3 middle = face.at("Co_" + side) - (radius - 1) * up + 3 * forward;
  SweptCurve joint;
  joint.name = osteotomy.fragment + " joint";
  const auto add = [&](double along, double above)
  { joint.points.push_back(middle + along * forward + above * up + outer * outwards); };
  for (int degrees = -20; degrees <= 180; degrees += 10)
  {
    const double a = degrees * 3.14159265358979323846 / 180;
    add(radius * std::cos(a), radius * std::sin(a));
  }
  for (const double below : {5, 10})
    add(-radius, -below);
  joint.direction = -outwards;
  joint.depth_mm = outer + inner + 1;
  joint.lead_mm = 1;
  osteotomy.curves.push_back(joint);
  for (const bool at_outer : {true, false})
  {
    BoundedPlane pole;
    pole.name = osteotomy.fragment + (at_outer ? " joint outside" : " joint inside");
    pole.center = middle + (at_outer ? outer : -inner) * outwards;
    pole.u = forward;
    pole.v = up;
    pole.half_u = pole.half_v = radius + 1;
    pole.may_miss = true;
    osteotomy.planes.push_back(pole);
  }
  osteotomy.fragment_point = face.at("Go_" + side) + 12 * up + 4 * forward - 3 * outwards;
  return osteotomy;
}

const std::map<std::string, std::function<Osteotomy(const Face&)>>& templates()
{
  static const std::map<std::string, std::function<Osteotomy(const Face&)>> known = {
      {"le-fort-1", le_fort_1},
      {"le-fort-2", le_fort_2},
      {"le-fort-3", le_fort_3},
      {"genioplasty", genioplasty},
      {"bsso", bsso},
      {"bsso-right", [](const Face& face) { return ramus(face, "R"); }},
      {"bsso-left", [](const Face& face) { return ramus(face, "L"); }},
      {"zygoma-right", [](const Face& face) { return zygoma(face, "R"); }},
      {"zygoma-left", [](const Face& face) { return zygoma(face, "L"); }}};
  return known;
}

void require_known(const std::string& name)
{
  if (templates().count(name))
    return;
  std::string known;
  for (const auto& entry : templates())
    known += (known.empty() ? "" : ", ") + entry.first;
  throw Error("osteotomy template '" + name + "'", "it is not known", "use one of " + known);
}

} // namespace

std::vector<std::string> osteotomy_template_names()
{
  std::vector<std::string> names;
  for (const auto& entry : templates())
    names.push_back(entry.first);
  return names;
}

std::vector<std::string> landmarks_of_template(const std::string& name)
{
  require_known(name);
  if (name == "genioplasty")
    return {"Or_R", "Or_L", "B", "Pg", "Me", "Go_R", "Go_L"};
  if (name == "zygoma-right")
    return {"N", "Or_R", "Or_L", "ANS", "PNS", "U6_R", "Zy_R"};
  if (name == "zygoma-left")
    return {"N", "Or_R", "Or_L", "ANS", "PNS", "U6_L", "Zy_L"};
  std::vector<std::string> needed = {"Or_R", "Or_L", "ANS", "PNS", "U1", "U6_R", "U6_L"};
  auto add = [&](std::initializer_list<const char*> more)
  { needed.insert(needed.end(), more.begin(), more.end()); };
  if (name == "le-fort-2" || name == "le-fort-3")
    add({"N"});
  else if (name == "bsso")
    add({"B", "Me", "Go_R", "Go_L"});
  else if (name == "bsso-right")
    add({"Me", "Go_R", "Co_R"});
  else if (name == "bsso-left")
    add({"Me", "Go_L", "Co_L"});
  return needed;
}

Osteotomy osteotomy_from_template(const std::string& name, const std::string& fragment,
                                  const Landmarks& landmarks, double kerf_mm)
{
  require_known(name);
  Osteotomy osteotomy = templates().at(name)(Face(name, landmarks));
  osteotomy.kerf_mm = kerf_mm;
  if (!fragment.empty())
    osteotomy.fragment = fragment;
  return osteotomy;
}

} // namespace f2b
