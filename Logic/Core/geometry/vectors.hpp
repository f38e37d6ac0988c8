#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <vector>

/// Small fixed-size types that the whole of Core shares.
namespace f2b
{

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Triangle = std::array<int, 3>;

/// A triangulated surface: corner positions [mm, RAS] and outward-facing (counter-clockwise) faces.
struct TriangleMesh
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

} // namespace f2b
