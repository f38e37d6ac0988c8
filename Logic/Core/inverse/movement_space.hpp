#pragma once

#include "Core/geometry/rigid_motion.hpp"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <string>

/// Which movements of the fragments may a plan use?
namespace f2b
{

/// What is asked of one coordinate of a movement, in its own unit: rad or mm.
struct CoordinateRule
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  bool is_locked = false; ///< it stays at `expected`
  double least = -unlimited, most = unlimited;
  double expected = 0;
  double sd = unlimited; ///< how far from `expected` it is likely to be; a prior if finite
};

/// A fragment that only turns about an axis, as the mandible about its condyles.
struct Hinge
{
  Vec3 point, direction; ///< [mm, RAS]; the direction is a unit vector
  CoordinateRule angle;  ///< right-handed about the direction
};

/// The planned bite of a fragment with another one, or with bone that stays.
struct BiteRelation
{
  static constexpr int bone_that_stays = -1;

  int leader = bone_that_stays; ///< a fragment
  /// Where the bite takes this fragment while the leader is at rest: the splint's transform. At
  /// rest, the two are locked together as they are.
  RigidMotion splint;
  double tolerance_mm = 0;  ///< likely distance of the points from the planned bite; 0: exact
  std::vector<Vec3> points; ///< at rest, that the tolerance is about: at least three [mm]
};

/// How one fragment may move.
struct FragmentRules
{
  /// Pitch, roll, yaw [rad], right, anterior, superior [mm], as movements are reported.
  std::array<CoordinateRule, 6> coordinates;
  std::optional<Hinge> hinge;       ///< in place of the coordinates
  std::optional<BiteRelation> bite; ///< exact: in place of the coordinates
};

/// A small rigid motion: turns by omega [rad] about a point that itself moves by v [mm].
struct Twist
{
  Vec3 omega = Vec3::Zero(), v = Vec3::Zero();
};

/// All movements of the fragments of a case, by independent coordinates q.
///
/// Each fragment that is neither hinged nor held exactly to another has six of them, less those
/// that are locked: the Euler angles and the translation of its reference point. Those of one
/// fragment follow each other.
class MovementSpace
{
public:
  /// Beyond these a movement is no plan, and a bound where the rules give none.
  static constexpr double largest_angle = 60 * 3.14159265358979323846 / 180, largest_shift_mm = 60;

  /// One coordinate of q.
  struct Coordinate
  {
    int fragment = 0;
    int axis = 0; ///< into FragmentRules::coordinates; 6: the hinge's angle
    CoordinateRule rule;

    bool is_angle() const { return axis < 3 || axis == 6; }
    /// Such as "pitch" or "right".
    const char* name() const;
  };

  /// \param names             of the fragments, for messages
  /// \param reference_points  one per fragment [mm]
  /// \param rules             one per fragment; empty: all are free
  /// Throws Error for bounds without room, a bite without its points, and for fragments that lead
  /// each other in a circle.
  MovementSpace(std::vector<std::string> names, std::vector<Vec3> reference_points,
                std::vector<FragmentRules> rules = {});

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_coordinates.size()); }
  std::size_t fragment_count() const { return m_names.size(); }
  const std::vector<Coordinate>& coordinates() const { return m_coordinates; }
  const std::vector<std::string>& names() const { return m_names; }
  Eigen::VectorXd least() const;
  Eigen::VectorXd most() const;

  /// No movement, or as near to it as the bounds allow.
  Eigen::VectorXd start() const;
  /// One motion per fragment, about its reference point.
  std::vector<RigidMotion> motions(const Eigen::VectorXd& q) const;
  /// Of every fragment per unit of coordinate k, about its moved reference point.
  std::vector<Twist> twists(const Eigen::VectorXd& q, Eigen::Index k) const;

  /// What priors and bites with a tolerance ask, in units of their standard deviations: the
  /// negative logarithm of their density is half the squared length.
  Eigen::VectorXd wishes(const Eigen::VectorXd& q) const;
  /// Derivative of `wishes`.
  Eigen::MatrixXd wish_slopes(const Eigen::VectorXd& q) const;

private:
  struct Member
  {
    std::array<int, 7> coordinate; ///< index into q by axis, -1: none
  };
  bool follows(std::size_t fragment) const;
  void order_leaders();
  void number_coordinates(std::size_t fragment);
  void require_bounds(const Coordinate& coordinate) const;
  double value(const Eigen::VectorXd& q, std::size_t fragment, int axis) const;
  RigidMotion own_motion(const Eigen::VectorXd& q, std::size_t fragment) const;
  Twist own_twist(const Eigen::VectorXd& q, const Coordinate& coordinate) const;
  RigidMotion led_motion(const std::vector<RigidMotion>& motions, std::size_t fragment) const;
  Twist led_twist(const std::vector<RigidMotion>& motions, const std::vector<Twist>& twists,
                  std::size_t fragment) const;

  std::vector<std::string> m_names;
  std::vector<Vec3> m_reference_points;
  std::vector<FragmentRules> m_rules;
  std::vector<std::size_t> m_order; ///< of fragments, leaders before those they lead
  std::vector<Coordinate> m_coordinates;
  std::vector<Member> m_members; ///< per fragment
};

} // namespace f2b
