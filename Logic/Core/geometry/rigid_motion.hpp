#pragma once

#include "Core/geometry/vectors.hpp"

/// How does a bone fragment move?
namespace f2b
{

/// Angles of R = Rz(yaw) Ry(roll) Rx(pitch), right-handed about +R, +A and +S of the case frame.
struct EulerAngles
{
  double pitch = 0; ///< about +R [rad]
  double roll = 0;  ///< about +A [rad]
  double yaw = 0;   ///< about +S [rad]
};

Mat3 rotation_from(const EulerAngles& angles);
/// Inverse of rotation_from; roll in [-pi/2, pi/2].
EulerAngles euler_angles(const Mat3& rotation);
/// Rotation by |omega| [rad] about omega (Rodrigues).
Mat3 rotation_from_vector(const Vec3& omega);

/// x' = R (x - c) + c + t, in RAS [mm].
struct RigidMotion
{
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero(); ///< of the reference point
  Vec3 reference_point = Vec3::Zero();

  Vec3 apply(const Vec3& x) const
  {
    return rotation * (x - reference_point) + reference_point + translation;
  }
  /// The 4 x 4 matrix that maps rest to moved points.
  Mat4 matrix() const;
  /// This motion followed by a small one, omega [rad] and v [mm] about the moved reference point.
  RigidMotion followed_by(const Vec3& omega, const Vec3& v) const;
};

/// The motion that undoes another one.
RigidMotion inverse(const RigidMotion& motion);

/// The rigid motion that best maps `from` to `to` in the least-squares sense (Kabsch 1976).
/// \param from, to  at least three corresponding points, not on one line [mm]
RigidMotion register_rigidly(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                             const Vec3& reference_point);

} // namespace f2b
