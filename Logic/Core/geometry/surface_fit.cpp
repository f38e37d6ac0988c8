#include "Core/geometry/surface_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// One point against the surface that it should lie on.
struct Match
{
  double distance = 0;
  Vec3 slope = Vec3::Zero(); ///< of the distance
  double likeness = 0;       ///< cosine between the normals, 0 if they point apart
};

class Fitting
{
public:
  Fitting(const std::vector<SurfaceSample>& points, const ScalarGrid& distance)
      : m_points(points), m_distance(distance),
        m_last(
            distance.position(distance.size.x() - 1, distance.size.y() - 1, distance.size.z() - 1))
  {
  }

  void descend(RigidMotion& motion, double scale, int iterations) const;
  SurfaceFit judged(const RigidMotion& motion, double scale) const;

private:
  struct Quadratic
  {
    double cost = 0;
    Mat6 hessian = Mat6::Zero();
    Vec6 gradient = Vec6::Zero();
  };

  Match match(const SurfaceSample& point, const RigidMotion& motion) const;
  double cost(const RigidMotion& motion, double scale) const;
  Quadratic quadratic(const RigidMotion& motion, double scale) const;
  static double rho(const Match& m, double scale)
  {
    return 1 - m.likeness * scale * scale / (m.distance * m.distance + scale * scale);
  }

  const std::vector<SurfaceSample>& m_points;
  const ScalarGrid& m_distance;
  const Vec3 m_last;
};

Match Fitting::match(const SurfaceSample& point, const RigidMotion& motion) const
{
  Match m;
  const Vec3 p = motion.apply(point.point);
  if (!((p.array() >= m_distance.origin.array()).all() && (p.array() <= m_last.array()).all()))
    return m;
  m.distance = m_distance.value(p);
  m.slope = m_distance.gradient(p);
  const double length = m.slope.norm();
  if (length > 1e-6)
    m.likeness = std::max(0.0, m.slope.dot(motion.rotation * point.normal) / length);
  return m;
}

double Fitting::cost(const RigidMotion& motion, double scale) const
{
  double sum = 0;
  for (const SurfaceSample& point : m_points)
    sum += rho(match(point, motion), scale);
  return sum / static_cast<double>(m_points.size());
}

Fitting::Quadratic Fitting::quadratic(const RigidMotion& motion, double scale) const
{
  Quadratic q;
  const Vec3 center = motion.reference_point + motion.translation;
  const double s2 = scale * scale;
  for (const SurfaceSample& point : m_points)
  {
    const Match m = match(point, motion);
    q.cost += rho(m, scale);
    if (m.likeness == 0)
      continue;
    Vec6 row;
    row << (motion.apply(point.point) - center).cross(m.slope), m.slope;
    const double below = m.distance * m.distance + s2;
    const double weight = m.likeness * s2 * s2 / (below * below);
    q.hessian.noalias() += weight * row * row.transpose();
    q.gradient += weight * m.distance * row;
  }
  q.cost /= static_cast<double>(m_points.size());
  return q;
}

/// Levenberg-Marquardt at one scale.
void Fitting::descend(RigidMotion& motion, double scale, int iterations) const
{
  constexpr double small_step_mm = 1e-4;
  double damping = 1e-4;
  for (int i = 0; i < iterations; ++i)
  {
    const Quadratic q = quadratic(motion, scale);
    bool lower = false;
    double step_mm = 0;
    for (; !lower && damping < 1e4; damping *= lower ? 0.1 : 10)
    {
      Mat6 damped = q.hessian;
      damped.diagonal() += damping * q.hessian.diagonal() + Vec6::Constant(1e-12);
      const Vec6 step = -damped.ldlt().solve(q.gradient);
      const RigidMotion moved = motion.followed_by(step.head<3>(), step.tail<3>());
      lower = step.allFinite() && cost(moved, scale) < q.cost;
      if (!lower)
        continue;
      motion = moved;
      step_mm = step.tail<3>().norm() + 100 * step.head<3>().norm();
    }
    if (!lower || step_mm < small_step_mm)
      return;
  }
}

SurfaceFit Fitting::judged(const RigidMotion& motion, double scale) const
{
  SurfaceFit fit;
  fit.motion = motion;
  fit.cost = cost(motion, scale);
  const Vec3 center = motion.reference_point + motion.translation;
  double squares = 0, radius2 = 0, inliers = 0;
  Mat6 hold = Mat6::Zero();
  for (const SurfaceSample& point : m_points)
  {
    const Match m = match(point, motion);
    if (m.likeness < 0.5 || std::abs(m.distance) > 3 * scale)
      continue;
    const Vec3 arm = motion.apply(point.point) - center;
    Vec6 row;
    row << arm.cross(m.slope.normalized()), m.slope.normalized();
    hold += row * row.transpose();
    squares += m.distance * m.distance;
    radius2 += arm.squaredNorm();
    ++inliers;
  }
  if (inliers == 0)
    return fit;
  fit.inlier_share = inliers / static_cast<double>(m_points.size());
  fit.rms_mm = std::sqrt(squares / inliers);
  Vec6 unit = Vec6::Ones();
  unit.head<3>().setConstant(1 / std::sqrt(std::max(radius2 / inliers, 1e-12)));
  const Mat6 scaled = unit.asDiagonal() * (hold / inliers) * unit.asDiagonal();
  fit.least_hold = Eigen::SelfAdjointEigenSolver<Mat6>(scaled).eigenvalues()[0];
  return fit;
}

} // namespace

SurfaceFit fit_surface(const std::vector<SurfaceSample>& points, const ScalarGrid& distance,
                       const RigidMotion& start, const SurfaceFitOptions& options)
{
  if (points.empty())
    return {start, 1, 0, 0, 0};
  const Fitting fitting(points, distance);
  RigidMotion motion = start;
  double scale = options.first_scale_mm;
  for (; scale > options.last_scale_mm; scale = std::max(0.5 * scale, options.last_scale_mm))
    fitting.descend(motion, scale, options.iterations_per_scale);
  fitting.descend(motion, options.last_scale_mm, 3 * options.iterations_per_scale);
  return fitting.judged(motion, options.last_scale_mm);
}

std::vector<SurfaceFit> fit_surface_from(const std::vector<RigidMotion>& starts,
                                         const std::vector<SurfaceSample>& points,
                                         const ScalarGrid& distance,
                                         const SurfaceFitOptions& options)
{
  std::vector<SurfaceFit> fits(starts.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t s = 0; s < starts.size(); ++s)
    fits[s] = fit_surface(points, distance, starts[s], options);
  std::stable_sort(fits.begin(), fits.end(),
                   [](const SurfaceFit& a, const SurfaceFit& b) { return a.cost < b.cost; });
  return fits;
}

double largest_difference(const RigidMotion& a, const RigidMotion& b,
                          const std::vector<SurfaceSample>& points)
{
  double largest = 0;
  for (const SurfaceSample& p : points)
    largest = std::max(largest, (a.apply(p.point) - b.apply(p.point)).norm());
  return largest;
}

double angle_between(const RigidMotion& a, const RigidMotion& b)
{
  return Eigen::AngleAxisd(Mat3(a.rotation * b.rotation.transpose())).angle();
}

} // namespace f2b
