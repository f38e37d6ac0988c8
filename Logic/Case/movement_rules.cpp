#include "Case/movement_rules.hpp"

#include "Bridge/markups.hpp"
#include "Bridge/transform_file.hpp"
#include "Core/error.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr std::array<const char*, 6> axes = {"pitch", "roll",     "yaw",
                                             "right", "anterior", "superior"};

/// One fragment's rules on their way from the case.
class Reader
{
public:
  Reader(const CaseSession& session, const MixedMesh& mesh, std::size_t fragment)
      : m_session(session), m_mesh(mesh),
        m_rules(session.settings.osteotomies.at(fragment).movement),
        m_where("'/osteotomies/" + std::to_string(fragment) + "/movement'")
  {
  }

  FragmentRules read() const
  {
    FragmentRules rules;
    if (m_rules.is_null())
      return rules;
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      rules.coordinates[axis] = coordinate(axes[axis], axis < 3 ? degree : 1);
    if (m_rules.contains("hinge"))
      rules.hinge = hinge(m_rules["hinge"]);
    if (m_rules.contains("bite"))
      rules.bite = bite(m_rules["bite"]);
    require_one_kind(rules);
    return rules;
  }

private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const
  {
    throw Error(m_where, problem, remedy);
  }

  CoordinateRule coordinate(const char* axis, double unit) const
  {
    CoordinateRule rule;
    const json locked = m_rules.value("locked", json::array());
    rule.is_locked = std::find(locked.begin(), locked.end(), axis) != locked.end();
    const json bounds = m_rules.value("bounds", json::object());
    if (bounds.contains(axis))
    {
      rule.least = unit * bounds[axis][0].get<double>();
      rule.most = unit * bounds[axis][1].get<double>();
    }
    const json priors = m_rules.value("prior", json::object());
    if (priors.contains(axis))
    {
      rule.expected = unit * priors[axis].value("expected", 0.0);
      rule.sd = unit * priors[axis]["sd"].get<double>();
    }
    if (rule.is_locked && (bounds.contains(axis) || priors.contains(axis)))
      refuse(std::string(axis) + " is locked, and has bounds or a prior too",
             "take it out of one of them");
    return rule;
  }

  Landmarks landmarks() const
  {
    if (!m_session.folder.has("landmarks.mrk.json"))
      refuse("it names landmarks, and the case has none", "give '/landmarks', or points");
    return read_landmarks(m_session.folder.file("landmarks.mrk.json"));
  }

  /// A landmark's name or a point.
  Vec3 place(const json& value) const
  {
    if (value.is_array())
      return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
    const Landmarks known = landmarks();
    const auto found = known.find(value.get<std::string>());
    if (found == known.end())
      refuse("there is no landmark '" + value.get<std::string>() + "'",
             "add it to the case's landmark file, or give a point");
    return found->second;
  }

  Hinge hinge(const json& value) const
  {
    const Vec3 a = place(value["axis"][0]), b = place(value["axis"][1]);
    if ((b - a).norm() < 1)
      refuse("the two points of the hinge's axis lie in one place", "give points that are apart");
    Hinge hinge{a, (b - a).normalized(), {}};
    if (value.contains("bounds_deg"))
    {
      hinge.angle.least = degree * value["bounds_deg"][0].get<double>();
      hinge.angle.most = degree * value["bounds_deg"][1].get<double>();
    }
    return hinge;
  }

  int leader(const std::string& name) const
  {
    const auto found = std::find(m_mesh.fragments.begin(), m_mesh.fragments.end(), name);
    if (found == m_mesh.fragments.end())
      refuse("its bite is with '" + name + "', which no cut frees",
             "name a fragment, or leave 'with' out for bone that stays");
    return static_cast<int>(found - m_mesh.fragments.begin());
  }

  /// Points of the bite at rest, and where the splint takes them.
  struct Triplet
  {
    std::vector<Vec3> from, to;
  };
  Triplet triplet(const json& points) const
  {
    const Path from_file = std::filesystem::u8path(points["from"].get<std::string>());
    const Path to_file = std::filesystem::u8path(points["to"].get<std::string>());
    const Landmarks from = read_landmarks(from_file), to = read_landmarks(to_file);
    Triplet result;
    for (const auto& [label, position] : from)
    {
      const auto found = to.find(label);
      if (found == to.end())
        throw Error(to_file.string(), "it has no point '" + label + "'",
                    "give every point of " + from_file.string() + " its counterpart");
      result.from.push_back(position);
      result.to.push_back(found->second);
    }
    require_triangle(result.from, from_file.string());
    return result;
  }

  /// Points on one line would leave a rotation about it free.
  static void require_triangle(const std::vector<Vec3>& points, const std::string& source)
  {
    double widest = 0;
    for (const Vec3& p : points)
      for (const Vec3& q : points)
        widest = std::max(widest, (p - points[0]).cross(q - points[0]).norm());
    if (points.size() < 3 || widest < 10) // mm^2
      throw Error(source, "its points do not span a triangle",
                  "give at least three points of the bite that do not lie on one line");
  }

  RigidMotion splint_transform(const Path& file, const Vec3& reference) const
  {
    const Mat4 matrix = read_transform(file);
    RigidMotion motion;
    motion.rotation = matrix.topLeftCorner<3, 3>();
    if (!(motion.rotation.transpose() * motion.rotation).isIdentity(1e-4) ||
        motion.rotation.determinant() < 0)
      throw Error(file.string(), "it is not a rigid transform",
                  "save the splint as a linear transform without scaling or shear");
    motion.reference_point = reference;
    motion.translation =
        matrix.topLeftCorner<3, 3>() * reference + Vec3(matrix.topRightCorner<3, 1>()) - reference;
    return motion;
  }

  BiteRelation bite(const json& value) const
  {
    BiteRelation bite;
    if (value.contains("with"))
      bite.leader = leader(value["with"].get<std::string>());
    bite.tolerance_mm = value.value("tolerance_mm", 0.0);
    if (value.contains("splint") && value.contains("points"))
      refuse("its bite has both a splint and points", "give one of them");
    if (value.contains("points"))
    {
      const Triplet points = triplet(value["points"]);
      bite.points = points.from;
      bite.splint = register_rigidly(points.from, points.to, points.from.front());
      return bite;
    }
    if (bite.tolerance_mm > 0)
      for (const char* tooth : {"U1", "U6_R", "U6_L"})
        bite.points.push_back(place(tooth));
    if (value.contains("splint"))
      bite.splint = splint_transform(std::filesystem::u8path(value["splint"].get<std::string>()),
                                     Vec3::Zero());
    return bite;
  }

  void require_one_kind(const FragmentRules& rules) const
  {
    const bool has_coordinates =
        m_rules.contains("locked") || m_rules.contains("bounds") || m_rules.contains("prior");
    const bool follows = rules.bite && rules.bite->tolerance_mm <= 0;
    if ((rules.hinge || follows) && has_coordinates)
      refuse("a hinge or an exact bite leaves no coordinates to lock, bound or expect",
             "take out locked, bounds and prior, or give the bite a tolerance_mm");
    if (rules.hinge && rules.bite)
      refuse("it has both a hinge and a bite", "give one of them");
  }

  const CaseSession& m_session;
  const MixedMesh& m_mesh;
  const json& m_rules;
  std::string m_where;
};

} // namespace

std::vector<FragmentRules> movement_rules(const CaseSession& session, const MixedMesh& mesh)
{
  std::vector<FragmentRules> rules;
  for (std::size_t f = 0; f < mesh.fragments.size(); ++f)
    rules.push_back(Reader(session, mesh, f).read());
  return rules;
}

} // namespace f2b
