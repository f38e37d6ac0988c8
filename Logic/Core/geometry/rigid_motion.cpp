#include "Core/geometry/rigid_motion.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace f2b
{

Mat3 rotation_from(const EulerAngles& angles)
{
  return (Eigen::AngleAxisd(angles.yaw, Vec3::UnitZ()) *
          Eigen::AngleAxisd(angles.roll, Vec3::UnitY()) *
          Eigen::AngleAxisd(angles.pitch, Vec3::UnitX()))
      .toRotationMatrix();
}

EulerAngles euler_angles(const Mat3& R)
{
  EulerAngles angles;
  angles.roll = std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
  angles.pitch = std::atan2(R(2, 1), R(2, 2));
  angles.yaw = std::atan2(R(1, 0), R(0, 0));
  return angles;
}

Mat3 rotation_from_vector(const Vec3& omega)
{
  const double angle = omega.norm();
  if (angle == 0)
    return Mat3::Identity();
  return Eigen::AngleAxisd(angle, omega / angle).toRotationMatrix();
}

Mat4 RigidMotion::matrix() const
{
  Mat4 m = Mat4::Identity();
  m.topLeftCorner<3, 3>() = rotation;
  m.topRightCorner<3, 1>() = reference_point + translation - rotation * reference_point;
  return m;
}

RigidMotion RigidMotion::followed_by(const Vec3& omega, const Vec3& v) const
{
  RigidMotion result = *this;
  // renormalised, so that many small steps stay a rotation
  result.rotation =
      Eigen::Quaterniond(rotation_from_vector(omega) * rotation).normalized().toRotationMatrix();
  result.translation += v;
  return result;
}

RigidMotion inverse(const RigidMotion& motion)
{
  RigidMotion back;
  back.rotation = motion.rotation.transpose();
  back.reference_point = motion.reference_point + motion.translation;
  back.translation = -motion.translation;
  return back;
}

RigidMotion register_rigidly(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                             const Vec3& reference_point)
{
  assert(from.size() == to.size() && from.size() >= 3);
  Vec3 mean_from = Vec3::Zero(), mean_to = Vec3::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    mean_from += from[i] / static_cast<double>(from.size());
    mean_to += to[i] / static_cast<double>(to.size());
  }
  Mat3 covariance = Mat3::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    covariance += (from[i] - mean_from) * (to[i] - mean_to).transpose();
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 flip = Mat3::Identity();
  flip(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
  RigidMotion motion;
  motion.reference_point = reference_point;
  motion.rotation = svd.matrixV() * flip * svd.matrixU().transpose();
  motion.translation = mean_to + motion.rotation * (reference_point - mean_from) - reference_point;
  return motion;
}

} // namespace f2b
