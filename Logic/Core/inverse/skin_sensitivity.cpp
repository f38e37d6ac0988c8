#include "Core/inverse/skin_sensitivity.hpp"

namespace f2b
{

std::vector<std::vector<Vec3>> fragment_velocities(const Discretization& tissue,
                                                   const MovementSpace& space,
                                                   const Eigen::VectorXd& q,
                                                   const std::vector<Vec3>& x)
{
  const MixedMesh& mesh = tissue.mesh();
  const std::vector<RigidMotion> motions = space.motions(q);
  std::vector<std::vector<Vec3>> velocities;
  for (Eigen::Index k = 0; k < space.size(); ++k)
  {
    const std::vector<Twist> twists = space.twists(q, k);
    std::vector<Vec3> velocity(x.size(), Vec3::Zero());
    for (std::size_t n = 0; n < mesh.X.size(); ++n)
    {
      if (mesh.node_boundary[n] != Boundary::Fragment)
        continue;
      const auto f = static_cast<std::size_t>(mesh.node_fragment[n]);
      const Vec3 reference = motions[f].reference_point + motions[f].translation;
      velocity[n] = twists[f].v + twists[f].omega.cross(x[n] - reference);
    }
    velocities.push_back(std::move(velocity));
  }
  return velocities;
}

std::vector<double> fit_weights(const FaceModel& face, const SkinTarget& target)
{
  std::vector<double> weight(face.skin_area.size());
  for (std::size_t v = 0; v < weight.size(); ++v)
    weight[v] = face.skin.vertices[v].prism < 0 ? 0 : face.skin_area[v] * target.weight[v];
  return weight;
}

SkinResidual::SkinResidual(const SkinTarget& target, std::vector<double> weight)
    : m_target(target), m_weight(std::move(weight))
{
}

std::vector<Vec3> SkinResidual::at(const std::vector<Vec3>& displacement) const
{
  std::vector<Vec3> off(displacement.size(), Vec3::Zero());
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < off.size(); ++v)
    if (m_weight[v] > 0)
      off[v] =
          displacement[v] - (m_target.nearest ? m_target.nearest(v, displacement[v]).displacement
                                              : m_target.displacement[v]);
  return off;
}

std::vector<Vec3> SkinResidual::directions(const std::vector<Vec3>& displacement) const
{
  constexpr double touching_mm = 1e-6; // nearer, the way to the surface has no direction
  std::vector<Vec3> direction;
  if (!m_target.nearest)
    return direction;
  direction.assign(displacement.size(), Vec3::Zero());
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < direction.size(); ++v)
    if (m_weight[v] > 0)
    {
      const NearestTarget foot = m_target.nearest(v, displacement[v]);
      const Vec3 way = displacement[v] - foot.displacement;
      direction[v] = way.norm() > touching_mm ? Vec3(way.normalized()) : foot.normal;
    }
  return direction;
}

double SkinResidual::objective(const std::vector<Vec3>& displacement) const
{
  const std::vector<Vec3> off = at(displacement);
  double sum = 0;
  for (std::size_t v = 0; v < off.size(); ++v)
    sum += 0.5 * m_weight[v] * off[v].squaredNorm();
  return sum;
}

std::vector<std::vector<Vec3>> SkinResidual::seen(const std::vector<Vec3>& displacement,
                                                  std::vector<std::vector<Vec3>> columns) const
{
  const std::vector<Vec3> direction = directions(displacement);
  for (std::vector<Vec3>& column : columns)
    for (std::size_t v = 0; v < column.size(); ++v)
      if (m_weight[v] <= 0)
        column[v].setZero();
      else if (!direction.empty())
        column[v] = direction[v] * direction[v].dot(column[v]);
  return columns;
}

void SkinResidual::normal_equations(const std::vector<Vec3>& displacement,
                                    const std::vector<std::vector<Vec3>>& columns,
                                    Eigen::MatrixXd& H, Eigen::VectorXd& g) const
{
  const std::vector<std::vector<Vec3>> c = seen(displacement, columns);
  const std::vector<Vec3> off = at(displacement);
  const auto n = static_cast<Eigen::Index>(c.size());
  H = Eigen::MatrixXd::Zero(n, n);
  g = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const auto& ci = c[static_cast<std::size_t>(i)];
    for (std::size_t v = 0; v < off.size(); ++v)
      g[i] += m_weight[v] * ci[v].dot(off[v]);
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const auto& cj = c[static_cast<std::size_t>(j)];
      for (std::size_t v = 0; v < off.size(); ++v)
        H(i, j) += m_weight[v] * ci[v].dot(cj[v]);
      H(j, i) = H(i, j);
    }
  }
}

std::vector<std::vector<Vec3>> skin_columns(const FaceModel& face, const MovementSpace& space,
                                            const Eigen::VectorXd& q, const std::vector<Vec3>& x,
                                            EquilibriumSolver& solver, double tolerance)
{
  const auto responses =
      solver.respond(x, fragment_velocities(face.tissue, space, q, x), tolerance);
  std::vector<std::vector<Vec3>> columns;
  for (const auto& response : responses)
    columns.push_back(face.skin.of_change(response));
  return columns;
}

} // namespace f2b
