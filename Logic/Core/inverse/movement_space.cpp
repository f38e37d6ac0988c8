#include "Core/inverse/movement_space.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

constexpr int hinge_axis = 6;
constexpr double degree = 3.14159265358979323846 / 180;
constexpr std::array<const char*, 7> axis_names = {"pitch",    "roll",     "yaw",  "right",
                                                   "anterior", "superior", "hinge"};

std::string shown(const MovementSpace::Coordinate& coordinate, double value)
{
  char text[40];
  if (coordinate.is_angle())
    std::snprintf(text, sizeof text, "%.4g degrees", value / degree);
  else
    std::snprintf(text, sizeof text, "%.4g mm", value);
  return text;
}

/// How the Euler angles turn a fragment that they have turned already.
Vec3 angle_axis(const EulerAngles& angles, int axis)
{
  switch (axis)
  {
  case 0:
    return rotation_from({0, angles.roll, angles.yaw}) * Vec3::UnitX();
  case 1:
    return rotation_from({0, 0, angles.yaw}) * Vec3::UnitY();
  default:
    return Vec3::UnitZ();
  }
}

Vec3 velocity(const Twist& twist, const Vec3& from_reference)
{
  return twist.v + twist.omega.cross(from_reference);
}

} // namespace

const char* MovementSpace::Coordinate::name() const
{
  return axis_names[static_cast<std::size_t>(axis)];
}

MovementSpace::MovementSpace(std::vector<std::string> names, std::vector<Vec3> reference_points,
                             std::vector<FragmentRules> rules)
    : m_names(std::move(names)), m_reference_points(std::move(reference_points)),
      m_rules(std::move(rules))
{
  if (m_rules.empty())
    m_rules.resize(m_names.size());
  order_leaders();
  m_members.resize(m_names.size());
  for (std::size_t f = 0; f < m_names.size(); ++f)
    number_coordinates(f);
}

/// Whether a fragment has no coordinate of its own.
bool MovementSpace::follows(std::size_t fragment) const
{
  const auto& bite = m_rules[fragment].bite;
  return bite && bite->tolerance_mm <= 0;
}

void MovementSpace::order_leaders()
{
  std::vector<char> done(m_names.size(), 0);
  for (std::size_t round = 0; round < m_names.size(); ++round)
    for (std::size_t f = 0; f < m_names.size(); ++f)
    {
      const auto& bite = m_rules[f].bite;
      const int leader = bite ? bite->leader : BiteRelation::bone_that_stays;
      if (leader >= static_cast<int>(m_names.size()) || leader == static_cast<int>(f))
        throw Error("fragment '" + m_names[f] + "'", "its bite is with itself or with no fragment",
                    "name another fragment, or none for bone that stays");
      if (bite && bite->tolerance_mm > 0 && bite->points.size() < 3)
        throw Error("fragment '" + m_names[f] + "'",
                    "its bite has a tolerance but fewer than three points",
                    "give at least three points of the bite");
      if (done[f] || (leader >= 0 && !done[static_cast<std::size_t>(leader)]))
        continue;
      done[f] = 1;
      m_order.push_back(f);
    }
  for (std::size_t f = 0; f < m_names.size(); ++f)
    if (!done[f])
      throw Error("fragment '" + m_names[f] + "'", "fragments hold each other in a circle",
                  "let one of them move freely");
}

void MovementSpace::require_bounds(const Coordinate& c) const
{
  if (c.rule.least <= c.rule.most)
    return;
  throw Error("fragment '" + m_names[static_cast<std::size_t>(c.fragment)] + "'",
              "its bounds leave no room: " + std::string(c.name()) + " from " +
                  shown(c, c.rule.least) + " to " + shown(c, c.rule.most),
              "give a lower bound below the upper one, within 60 mm and 60 degrees");
}

void MovementSpace::number_coordinates(std::size_t fragment)
{
  Member& member = m_members[fragment];
  member.coordinate.fill(-1);
  if (follows(fragment))
    return;
  const FragmentRules& rules = m_rules[fragment];
  const int first = rules.hinge ? hinge_axis : 0, last = rules.hinge ? hinge_axis : 5;
  for (int axis = first; axis <= last; ++axis)
  {
    Coordinate c{static_cast<int>(fragment), axis,
                 rules.hinge ? rules.hinge->angle
                             : rules.coordinates[static_cast<std::size_t>(axis)]};
    if (c.rule.is_locked)
      continue;
    const double limit = c.is_angle() ? largest_angle : largest_shift_mm;
    c.rule.least = std::max(c.rule.least, -limit);
    c.rule.most = std::min(c.rule.most, limit);
    require_bounds(c);
    member.coordinate[static_cast<std::size_t>(axis)] = static_cast<int>(m_coordinates.size());
    m_coordinates.push_back(c);
  }
}

Eigen::VectorXd MovementSpace::least() const
{
  Eigen::VectorXd bound(size());
  for (Eigen::Index k = 0; k < size(); ++k)
    bound[k] = m_coordinates[static_cast<std::size_t>(k)].rule.least;
  return bound;
}

Eigen::VectorXd MovementSpace::most() const
{
  Eigen::VectorXd bound(size());
  for (Eigen::Index k = 0; k < size(); ++k)
    bound[k] = m_coordinates[static_cast<std::size_t>(k)].rule.most;
  return bound;
}

Eigen::VectorXd MovementSpace::start() const
{
  return Eigen::VectorXd::Zero(size()).cwiseMax(least()).cwiseMin(most());
}

/// A coordinate of a fragment, whether it is one of q or locked.
double MovementSpace::value(const Eigen::VectorXd& q, std::size_t fragment, int axis) const
{
  const int k = m_members[fragment].coordinate[static_cast<std::size_t>(axis)];
  if (k >= 0)
    return q[k];
  const FragmentRules& rules = m_rules[fragment];
  const CoordinateRule& rule =
      axis == hinge_axis ? rules.hinge->angle : rules.coordinates[static_cast<std::size_t>(axis)];
  return rule.expected;
}

RigidMotion MovementSpace::own_motion(const Eigen::VectorXd& q, std::size_t fragment) const
{
  RigidMotion motion;
  motion.reference_point = m_reference_points[fragment];
  if (const auto& hinge = m_rules[fragment].hinge)
  {
    motion.rotation = rotation_from_vector(value(q, fragment, hinge_axis) * hinge->direction);
    const Vec3 from_axis = motion.reference_point - hinge->point;
    motion.translation = motion.rotation * from_axis - from_axis;
    return motion;
  }
  motion.rotation =
      rotation_from({value(q, fragment, 0), value(q, fragment, 1), value(q, fragment, 2)});
  motion.translation = {value(q, fragment, 3), value(q, fragment, 4), value(q, fragment, 5)};
  return motion;
}

/// The leader's motion after the splint's.
RigidMotion MovementSpace::led_motion(const std::vector<RigidMotion>& motions,
                                      std::size_t fragment) const
{
  const BiteRelation& bite = *m_rules[fragment].bite;
  RigidMotion motion = bite.splint;
  motion.reference_point = m_reference_points[fragment];
  Vec3 reference = bite.splint.apply(motion.reference_point);
  if (bite.leader >= 0)
  {
    const RigidMotion& leader = motions[static_cast<std::size_t>(bite.leader)];
    motion.rotation = leader.rotation * bite.splint.rotation;
    reference = leader.apply(reference);
  }
  motion.translation = reference - motion.reference_point;
  return motion;
}

std::vector<RigidMotion> MovementSpace::motions(const Eigen::VectorXd& q) const
{
  std::vector<RigidMotion> motions(m_names.size());
  for (const std::size_t f : m_order)
    motions[f] = follows(f) ? led_motion(motions, f) : own_motion(q, f);
  return motions;
}

Twist MovementSpace::own_twist(const Eigen::VectorXd& q, const Coordinate& c) const
{
  const auto fragment = static_cast<std::size_t>(c.fragment);
  Twist twist;
  if (c.axis == hinge_axis)
  {
    const Hinge& hinge = *m_rules[fragment].hinge;
    const RigidMotion motion = own_motion(q, fragment);
    twist.omega = hinge.direction;
    twist.v = hinge.direction.cross(motion.reference_point + motion.translation - hinge.point);
  }
  else if (c.axis < 3)
    twist.omega =
        angle_axis({value(q, fragment, 0), value(q, fragment, 1), value(q, fragment, 2)}, c.axis);
  else
    twist.v = Vec3::Unit(c.axis - 3);
  return twist;
}

Twist MovementSpace::led_twist(const std::vector<RigidMotion>& motions,
                               const std::vector<Twist>& twists, std::size_t fragment) const
{
  const int leader = m_rules[fragment].bite->leader;
  if (leader < 0)
    return {};
  const auto l = static_cast<std::size_t>(leader);
  const RigidMotion here = led_motion(motions, fragment);
  const Vec3 from_leader =
      here.reference_point + here.translation - motions[l].reference_point - motions[l].translation;
  return {twists[l].omega, velocity(twists[l], from_leader)};
}

std::vector<Twist> MovementSpace::twists(const Eigen::VectorXd& q, Eigen::Index k) const
{
  const std::vector<RigidMotion> moved = motions(q);
  const Coordinate& coordinate = m_coordinates[static_cast<std::size_t>(k)];
  std::vector<Twist> twists(m_names.size());
  for (const std::size_t f : m_order)
    if (follows(f))
      twists[f] = led_twist(moved, twists, f);
    else if (coordinate.fragment == static_cast<int>(f))
      twists[f] = own_twist(q, coordinate);
  return twists;
}

Eigen::VectorXd MovementSpace::wishes(const Eigen::VectorXd& q) const
{
  std::vector<double> rows;
  for (Eigen::Index k = 0; k < size(); ++k)
  {
    const CoordinateRule& rule = m_coordinates[static_cast<std::size_t>(k)].rule;
    if (std::isfinite(rule.sd))
      rows.push_back((q[k] - rule.expected) / rule.sd);
  }
  const std::vector<RigidMotion> moved = motions(q);
  for (std::size_t f = 0; f < m_names.size(); ++f)
  {
    const auto& bite = m_rules[f].bite;
    if (!bite || follows(f))
      continue;
    const RigidMotion led = led_motion(moved, f);
    for (const Vec3& p : bite->points)
    {
      const Vec3 off = (moved[f].apply(p) - led.apply(p)) / bite->tolerance_mm;
      rows.insert(rows.end(), off.data(), off.data() + 3);
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

Eigen::MatrixXd MovementSpace::wish_slopes(const Eigen::VectorXd& q) const
{
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(wishes(q).size(), size());
  const std::vector<RigidMotion> moved = motions(q);
  for (Eigen::Index k = 0; k < size(); ++k)
  {
    const std::vector<Twist> turning = twists(q, k);
    Eigen::Index row = 0;
    for (Eigen::Index j = 0; j < size(); ++j)
    {
      const CoordinateRule& rule = m_coordinates[static_cast<std::size_t>(j)].rule;
      if (!std::isfinite(rule.sd))
        continue;
      if (j == k)
        slopes(row, k) = 1 / rule.sd;
      ++row;
    }
    for (std::size_t f = 0; f < m_names.size(); ++f)
    {
      const auto& bite = m_rules[f].bite;
      if (!bite || follows(f))
        continue;
      const RigidMotion led = led_motion(moved, f);
      const Twist led_turning = led_twist(moved, turning, f);
      for (const Vec3& p : bite->points)
      {
        const Vec3 here = moved[f].apply(p) - moved[f].reference_point - moved[f].translation;
        const Vec3 there = led.apply(p) - led.reference_point - led.translation;
        slopes.block<3, 1>(row, k) =
            (velocity(turning[f], here) - velocity(led_turning, there)) / bite->tolerance_mm;
        row += 3;
      }
    }
  }
  return slopes;
}

} // namespace f2b
