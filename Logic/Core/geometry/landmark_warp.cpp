#include "Core/geometry/landmark_warp.hpp"

#include "Core/error.hpp"

#include <Eigen/Cholesky>

#include <cmath>

namespace f2b
{
namespace
{

double wendland(double distance, double radius)
{
  const double r = distance / radius;
  if (r >= 1)
    return 0;
  const double s = (1 - r) * (1 - r);
  return s * s * (4 * r + 1);
}

} // namespace

LandmarkWarp::LandmarkWarp(std::vector<Vec3> from, const std::vector<Vec3>& to, double radius_mm)
    : m_from(std::move(from)), m_radius_mm(radius_mm)
{
  if (m_from.empty() || m_from.size() != to.size())
    throw Error("target warp",
                std::to_string(m_from.size()) + " from points and " + std::to_string(to.size()) +
                    " to points",
                "give as many to points as from points, at least one");
  if (!(radius_mm > 0) || !std::isfinite(radius_mm))
    throw Error("target warp", "radius_mm is " + std::to_string(radius_mm),
                "give a positive, finite radius");
  const auto n = static_cast<Eigen::Index>(m_from.size());
  Eigen::MatrixXd kernel(n, n), moves(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Vec3& p = m_from[static_cast<std::size_t>(i)];
    moves.row(i) = (to[static_cast<std::size_t>(i)] - p).transpose();
    if (!moves.row(i).allFinite() || !p.allFinite())
      throw Error("target warp",
                  "point " + std::to_string(i + 1) + " has a coordinate that is not finite",
                  "correct it in the markups file");
    for (Eigen::Index j = 0; j < n; ++j)
      kernel(i, j) = wendland((p - m_from[static_cast<std::size_t>(j)]).norm(), radius_mm);
    for (Eigen::Index j = 0; j < i; ++j)
      if ((p - m_from[static_cast<std::size_t>(j)]).norm() < nearest_mm)
        throw Error("target warp",
                    "from points " + std::to_string(j + 1) + " and " + std::to_string(i + 1) +
                        " lie within 0.1 mm of each other",
                    "remove one of them");
  }
  m_coefficients = kernel.ldlt().solve(moves);
}

Vec3 LandmarkWarp::displacement(const Vec3& point) const
{
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < m_from.size(); ++i)
    sum += wendland((point - m_from[i]).norm(), m_radius_mm) *
           m_coefficients.row(static_cast<Eigen::Index>(i)).transpose();
  return sum;
}

} // namespace f2b
