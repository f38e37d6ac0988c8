#include "Core/geometry/osteotomy_templates.hpp"

#include "Core/error.hpp"

#include <algorithm>
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

/// The planes behind and below the maxilla that Le Fort I and III share.
/// \param back_top  where the upper cut ends behind
/// \param back_width_mm  of the plane behind
void part_maxilla_from_below(const Face& face, const Vec3& forward, const Vec3& back_top,
                             double back_width_mm, Osteotomy& osteotomy)
{
  const Vec3 up = face.right.cross(forward);
  const Vec3 molars = 0.5 * (face.at("U6_R") + face.at("U6_L"));
  // the middle of an open bite's gap; where the teeth meet or overlap, just below the upper ones
  const double gap = face.has("L1") ? (face.at("U1") - face.at("L1")).dot(up) : 0;
  const Vec3 bite_front = face.at("U1") - std::clamp(0.5 * gap, 0.5, 3.0) * up + 12 * forward;
  const Vec3 along_bite = across(face.at("U1") - molars, face.right);
  const double depth = (bite_front - back_top).dot(forward) / along_bite.dot(forward) + 3;
  const Vec3 bite_back = bite_front - depth * along_bite;
  osteotomy.planes.push_back(plane_between(osteotomy.fragment + " posterior", face.right,
                                           back_top + 3 * up, bite_back - 4 * up, back_width_mm));
  osteotomy.planes.push_back(plane_between(osteotomy.fragment + " occlusal", face.right, bite_front,
                                           bite_back, maxilla_width(face)));
}

Osteotomy le_fort_1(const Face& face)
{
  Osteotomy osteotomy;
  const Vec3 forward = across(face.at("ANS") - face.at("PNS"), face.right);
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

Osteotomy le_fort_3(const Face& face)
{
  Osteotomy osteotomy;
  const Vec3 forward = across(face.at("ANS") - face.at("PNS"), face.right);
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

const std::map<std::string, std::function<Osteotomy(const Face&)>>& templates()
{
  static const std::map<std::string, std::function<Osteotomy(const Face&)>> known = {
      {"le-fort-1", le_fort_1}, {"le-fort-3", le_fort_3}, {"genioplasty", genioplasty}};
  return known;
}

} // namespace

std::vector<std::string> osteotomy_template_names()
{
  std::vector<std::string> names;
  for (const auto& entry : templates())
    names.push_back(entry.first);
  return names;
}

Osteotomy osteotomy_from_template(const std::string& name, const std::string& fragment,
                                  const Landmarks& landmarks, double kerf_mm)
{
  const auto found = templates().find(name);
  if (found == templates().end())
  {
    std::string known;
    for (const auto& entry : templates())
      known += (known.empty() ? "" : ", ") + entry.first;
    throw Error("osteotomy template '" + name + "'", "it is not known", "use one of " + known);
  }
  Osteotomy osteotomy = found->second(Face(name, landmarks));
  osteotomy.kerf_mm = kerf_mm;
  if (!fragment.empty())
    osteotomy.fragment = fragment;
  return osteotomy;
}

} // namespace f2b
