#include "Core/geometry/cephalometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace f2b
{
namespace
{

using Vec2 = Eigen::Vector2d;
constexpr double degrees = 180 / 3.14159265358979323846;

double cross(const Vec2& a, const Vec2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// From direction a to direction b, counter-clockwise seen from the patient's left (forwards is
/// right, up is up), in (-180, 180] [deg].
double turn(const Vec2& a, const Vec2& b)
{
  return degrees * std::atan2(cross(a, b), a.dot(b));
}

/// The angle at `corner` between two points, in [0, 180] [deg].
double angle(const Vec2& a, const Vec2& corner, const Vec2& b)
{
  return std::abs(turn(a - corner, b - corner));
}

/// How far p lies in front of the line from `top` down to `bottom` [mm].
double in_front(const Vec2& p, const Vec2& top, const Vec2& bottom)
{
  return cross((bottom - top).normalized(), p - top);
}

/// Landmarks on the mid-sagittal plane: forwards, upwards [mm].
class LateralView
{
public:
  LateralView(const Landmarks& landmarks, const MidSagittalPlane& plane)
      : m_landmarks(landmarks), m_origin(plane.point)
  {
    const Vec3 right = plane.normal.normalized();
    // any forward direction will do: no measure depends on it but its sign
    Vec3 forward = direction("PNS", "ANS");
    for (const char* pair : {"Po", "Zy", "Go", "Co"})
      if (forward.isZero() && middle(pair) && middle("Or"))
        forward = *middle("Or") - *middle(pair);
    if (forward.isZero())
      forward = Vec3::UnitY();
    m_forward = (forward - right * right.dot(forward)).normalized();
    m_up = right.cross(m_forward);
  }

  std::optional<Vec2> operator()(const std::string& name) const
  {
    const std::optional<Vec3> p = middle(name);
    if (!p)
      return std::nullopt;
    return Vec2(m_forward.dot(*p - m_origin), m_up.dot(*p - m_origin));
  }

private:
  std::optional<Vec3> one(const std::string& name) const
  {
    const auto found = m_landmarks.find(name);
    return found == m_landmarks.end() ? std::nullopt : std::optional<Vec3>(found->second);
  }
  /// Of a pair, or the point itself.
  std::optional<Vec3> middle(const std::string& name) const
  {
    const auto right = one(name + "_R"), left = one(name + "_L");
    return right && left ? Vec3(0.5 * (*right + *left)) : one(name);
  }
  Vec3 direction(const std::string& from, const std::string& to) const
  {
    const auto a = one(from), b = one(to);
    return a && b ? Vec3(*b - *a) : Vec3(Vec3::Zero());
  }

  const Landmarks& m_landmarks;
  Vec3 m_origin, m_forward = Vec3::UnitY(), m_up = Vec3::UnitZ();
};

using Points = std::vector<Vec2>;

struct Measure
{
  const char* name;
  const char* unit;
  std::vector<const char*> landmarks;
  double (*value)(const Points&);
  const char* definition;
};

double jaw_difference(const Points& p) // N A B
{
  return turn(p[2] - p[0], p[1] - p[0]);
}

/// Of a line that falls forwards against one that runs forwards: positive where it is steeper.
double steepness(const Points& p) // back and front of the one, back and front of the other
{
  return turn(p[3] - p[2], p[1] - p[0]);
}

double bend(const Points& p) // upper, middle, lower
{
  return turn(p[2] - p[1], p[1] - p[0]) > 0 ? 180 - angle(p[0], p[1], p[2])
                                            : angle(p[0], p[1], p[2]) - 180;
}

double corner(const Points& p)
{
  return angle(p[0], p[1], p[2]);
}

double distance(const Points& p)
{
  return (p[1] - p[0]).norm();
}

double before_line(const Points& p) // point, top, bottom
{
  return in_front(p[0], p[1], p[2]);
}

double facial_angle(const Points& p) // Po Or N Pg
{
  return angle(p[1], p[0], p[0] + p[2] - p[3]);
}

double wits(const Points& p) // A B U6 U1
{
  return (p[0] - p[1]).dot((p[3] - p[2]).normalized());
}

const std::vector<Measure>& measures()
{
  static const std::vector<Measure> all = {
      {"SNA", "deg", {"S", "N", "A"}, corner, "angle S-N-A"},
      {"SNB", "deg", {"S", "N", "B"}, corner, "angle S-N-B"},
      {"ANB", "deg", {"N", "A", "B"}, jaw_difference, "angle A-N-B; positive: A in front of N-B"},
      {"SNPg", "deg", {"S", "N", "Pg"}, corner, "angle S-N-Pg"},
      {"Wits", "mm", {"A", "B", "U6", "U1"}, wits, "A in front of B along U6-U1"},
      {"facial angle",
       "deg",
       {"Po", "Or", "N", "Pg"},
       facial_angle,
       "Pg-N against the Frankfort horizontal, more with a more forward chin"},
      {"convexity",
       "deg",
       {"N", "A", "Pg"},
       bend,
       "N-A against A-Pg; positive: A in front of N-Pg"},
      {"SN-MP",
       "deg",
       {"S", "N", "Go", "Me"},
       [](const Points& p) {
         return -steepness({p[2], p[3], p[0], p[1]});
       },
       "mandibular plane Go-Me against S-N; positive: falls forwards"},
      {"FH-MP",
       "deg",
       {"Po", "Or", "Go", "Me"},
       [](const Points& p) {
         return -steepness({p[2], p[3], p[0], p[1]});
       },
       "mandibular plane Go-Me against the Frankfort horizontal; positive: falls forwards"},
      {"FH-PP",
       "deg",
       {"Po", "Or", "PNS", "ANS"},
       [](const Points& p) {
         return -steepness({p[2], p[3], p[0], p[1]});
       },
       "palatal plane PNS-ANS against the Frankfort horizontal; positive: falls forwards"},
      {"gonial angle", "deg", {"Co", "Go", "Me"}, corner, "angle Co-Go-Me"},
      {"N-ANS", "mm", {"N", "ANS"}, distance, "upper facial height"},
      {"ANS-Me", "mm", {"ANS", "Me"}, distance, "lower facial height"},
      {"Co-A", "mm", {"Co", "A"}, distance, "length of the mid-face"},
      {"Co-Gn", "mm", {"Co", "Gn"}, distance, "length of the mandible"},
      {"facial convexity, skin",
       "deg",
       {"N'", "sn", "Pg'"},
       bend,
       "N'-sn against sn-Pg'; positive: sn in front"},
      {"nasolabial angle", "deg", {"cm", "sn", "ls"}, corner, "angle columella-sn-ls"},
      {"E line to ls", "mm", {"ls", "prn", "Pg'"}, before_line, "positive: in front of prn-Pg'"},
      {"E line to li", "mm", {"li", "prn", "Pg'"}, before_line, "positive: in front of prn-Pg'"},
      {"sn-Me'", "mm", {"sn", "Me'"}, distance, "lower facial height, skin"},
  };
  return all;
}

std::optional<Points> points_of(const LateralView& view, const Measure& measure)
{
  Points points;
  for (const char* name : measure.landmarks)
  {
    const std::optional<Vec2> p = view(name);
    if (!p || !p->allFinite())
      return std::nullopt;
    for (const Vec2& other : points)
      if ((other - *p).norm() < 1e-6)
        return std::nullopt;
    points.push_back(*p);
  }
  return points;
}

/// Without these there is no mid-sagittal plane.
constexpr const char* plane_landmarks[] = {"N", "Or_R", "Or_L"};

/// The given landmarks that a measure's point lacks: a pair's halves, or the point itself.
std::vector<std::string> lacking(const std::string& name, const Landmarks& landmarks)
{
  if (landmarks.count(name) > 0)
    return {};
  const std::string right = name + "_R", left = name + "_L";
  const auto& known = landmark_definitions();
  const bool is_pair = std::any_of(known.begin(), known.end(),
                                   [&](const LandmarkDefinition& d) { return right == d.name; });
  std::vector<std::string> missing;
  for (const std::string& one : is_pair ? std::vector{right, left} : std::vector{name})
    if (landmarks.count(one) == 0)
      missing.push_back(one);
  return missing;
}

} // namespace

std::vector<CephalometricMeasure> cephalometry(const Landmarks& landmarks,
                                               const MidSagittalPlane& mid_sagittal)
{
  const LateralView view(landmarks, mid_sagittal);
  std::vector<CephalometricMeasure> result;
  for (const Measure& measure : measures())
    if (const std::optional<Points> points = points_of(view, measure))
      result.push_back({measure.name, measure.unit, measure.value(*points), measure.definition});
  return result;
}

std::vector<CephalometricMeasure> cephalometry(const Landmarks& landmarks)
{
  for (const char* name : plane_landmarks)
    if (landmarks.count(name) == 0)
      return {};
  return cephalometry(landmarks, mid_sagittal_plane(landmarks));
}

LeftOutMeasures left_out_measures(const Landmarks& landmarks)
{
  LeftOutMeasures left_out;
  std::set<std::string> missing;
  for (const char* name : plane_landmarks)
    if (landmarks.count(name) == 0)
      missing.insert(name);
  const bool has_plane = missing.empty();
  for (const Measure& measure : measures())
  {
    bool lacks = !has_plane;
    for (const char* name : measure.landmarks)
      for (const std::string& one : lacking(name, landmarks))
      {
        missing.insert(one);
        lacks = true;
      }
    if (lacks)
      left_out.measures.emplace_back(measure.name);
  }
  for (const LandmarkDefinition& d : landmark_definitions())
    if (missing.count(d.name) > 0)
      left_out.landmarks.emplace_back(d.name);
  return left_out;
}

const std::vector<LandmarkDefinition>& landmark_definitions()
{
  static const std::vector<LandmarkDefinition> all = {
      {"N", "nasion: front of the nasofrontal suture, in the middle", false},
      {"S", "sella: middle of the pituitary fossa", false},
      {"Po_R", "porion: top of the right bony ear canal", false},
      {"Po_L", "porion, left", false},
      {"Or_R", "orbitale: lowest point of the right orbital rim", false},
      {"Or_L", "orbitale, left", false},
      {"Zy_R", "zygion: outermost point of the right zygomatic arch", false},
      {"Zy_L", "zygion, left", false},
      {"ANS", "tip of the anterior nasal spine", false},
      {"PNS", "back end of the hard palate, in the middle", false},
      {"A", "deepest point of the front of the maxilla between ANS and the teeth", false},
      {"B", "deepest point of the front of the mandible between the teeth and the chin", false},
      {"U1", "edge of the upper central incisors, in the middle", false},
      {"L1", "edge of the lower central incisors, in the middle", false},
      {"U6_R", "front outer cusp of the right upper first molar", false},
      {"U6_L", "the same, left", false},
      {"Pg", "pogonion: foremost point of the bony chin", false},
      {"Gn", "gnathion: between pogonion and menton on the chin's outline", false},
      {"Me", "menton: lowest point of the bony chin", false},
      {"Go_R", "gonion: corner of the right jaw", false},
      {"Go_L", "gonion, left", false},
      {"Co_R", "condylion: top of the right condyle", false},
      {"Co_L", "condylion, left", false},
      {"N'", "nasion on the skin", true},
      {"prn", "pronasale: tip of the nose", true},
      {"cm", "columella: its foremost point", true},
      {"sn", "subnasale: where the nose meets the upper lip", true},
      {"ls", "labrale superius: edge of the upper lip's red, in the middle", true},
      {"li", "labrale inferius: edge of the lower lip's red", true},
      {"Pg'", "pogonion on the skin", true},
      {"Me'", "menton on the skin", true},
      {"ch_R", "cheilion: right corner of the mouth", true},
      {"ch_L", "cheilion, left", true},
      {"Or'_R", "orbitale on the skin, right", true},
      {"Or'_L", "the same, left", true},
  };
  return all;
}

} // namespace f2b
