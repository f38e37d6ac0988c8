#include "Core/inverse/skin_sensitivity.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

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

Eigen::VectorXd moved_skin(const std::vector<std::vector<Vec3>>& columns,
                           const std::vector<double>& weight)
{
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t v = 0; v < weight.size(); ++v)
      moved[static_cast<Eigen::Index>(k)] += weight[v] * columns[k][v].squaredNorm();
  return moved;
}

std::vector<int> unseen_fragments(const MovementSpace& space, const Eigen::VectorXd& q,
                                  const Eigen::VectorXd& counting, const Eigen::VectorXd& all)
{
  constexpr double least_share = 0.1, lever_mm = 50;
  const Eigen::MatrixXd wishes = space.wish_slopes(q);
  struct Share
  {
    double counting = 0, all = 0;
    bool wished = false;
  };
  std::vector<Share> shares(space.fragment_count());
  for (Eigen::Index k = 0; k < space.size(); ++k)
  {
    const MovementSpace::Coordinate& c = space.coordinates()[static_cast<std::size_t>(k)];
    const double unit = c.is_angle() ? 1 / (lever_mm * lever_mm) : 1;
    Share& share = shares[static_cast<std::size_t>(c.fragment)];
    share.counting += unit * counting[k];
    share.all += unit * all[k];
    share.wished = share.wished || (wishes.rows() > 0 && !wishes.col(k).isZero(0));
  }
  double largest = 0;
  for (Share& share : shares)
    if (share.all > 0)
      largest = std::max(largest, share.counting /= share.all);
  std::vector<int> unseen;
  for (std::size_t f = 0; f < shares.size(); ++f)
    if (!shares[f].wished && shares[f].all > 0 && shares[f].counting < least_share * largest)
      unseen.push_back(static_cast<int>(f));
  return unseen;
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

namespace
{

double product(const std::vector<double>& weight, const std::vector<Vec3>& a,
               const std::vector<Vec3>& b)
{
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v)
    sum += weight[v] * a[v].dot(b[v]);
  return sum;
}

} // namespace

void SkinResidual::doubt_registration(std::vector<Vec3> positions, double wish_weight)
{
  constexpr double lever_mm = 60; // half a face
  if (!(m_target.registration_sd_mm > 0))
    return;
  Vec3 middle = Vec3::Zero();
  double total = 0;
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    middle += m_weight[v] * positions[v];
    total += m_weight[v];
  }
  if (!(total > 0))
    return;
  middle /= total;
  m_rigid.assign(6, std::vector<Vec3>(positions.size(), Vec3::Zero()));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t v = 0; v < positions.size(); ++v)
    {
      const Vec3 axis = Vec3::Unit(static_cast<Eigen::Index>(k));
      m_rigid[k][v] = axis;
      m_rigid[k + 3][v] = axis.cross(positions[v] - middle);
    }
  const double shift = wish_weight / (m_target.registration_sd_mm * m_target.registration_sd_mm);
  m_prior << Vec3::Constant(shift), Vec3::Constant(shift * lever_mm * lever_mm);
}

SkinResidual::Vec6 SkinResidual::explained(const std::vector<std::vector<Vec3>>& rigid,
                                           const std::vector<Vec3>& field) const
{
  Eigen::Matrix<double, 6, 6> S = m_prior.asDiagonal();
  Vec6 right_hand_side;
  for (Eigen::Index i = 0; i < 6; ++i)
  {
    const auto& ri = rigid[static_cast<std::size_t>(i)];
    right_hand_side[i] = product(m_weight, ri, field);
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const double s = product(m_weight, ri, rigid[static_cast<std::size_t>(j)]);
      S(i, j) += s;
      if (i != j)
        S(j, i) += s;
    }
  }
  return S.ldlt().solve(right_hand_side);
}

std::vector<Vec3> SkinResidual::less_registration(const std::vector<std::vector<Vec3>>& rigid,
                                                  std::vector<Vec3> field) const
{
  if (rigid.empty())
    return field;
  const Vec6 p = explained(rigid, field);
  for (std::size_t v = 0; v < field.size(); ++v)
    for (std::size_t k = 0; k < 6; ++k)
      field[v] -= p[static_cast<Eigen::Index>(k)] * rigid[k][v];
  return field;
}

SkinResidual::Vec6 SkinResidual::registration(const std::vector<Vec3>& displacement) const
{
  if (m_rigid.empty())
    return Vec6::Zero();
  return explained(along_directions(directions(displacement), m_rigid), at(displacement));
}

double SkinResidual::objective(const std::vector<Vec3>& displacement) const
{
  const std::vector<Vec3> off = at(displacement);
  if (m_rigid.empty())
    return 0.5 * product(m_weight, off, off);
  const auto rigid = along_directions(directions(displacement), m_rigid);
  return 0.5 * product(m_weight, off, less_registration(rigid, off));
}

std::vector<std::vector<Vec3>>
SkinResidual::along_directions(const std::vector<Vec3>& direction,
                               std::vector<std::vector<Vec3>> columns) const
{
  for (std::vector<Vec3>& column : columns)
    for (std::size_t v = 0; v < column.size(); ++v)
      if (m_weight[v] <= 0)
        column[v].setZero();
      else if (!direction.empty())
        column[v] = direction[v] * direction[v].dot(column[v]);
  return columns;
}

std::vector<std::vector<Vec3>> SkinResidual::seen(const std::vector<Vec3>& displacement,
                                                  std::vector<std::vector<Vec3>> columns) const
{
  const std::vector<Vec3> direction = directions(displacement);
  columns = along_directions(direction, std::move(columns));
  const auto rigid = along_directions(direction, m_rigid);
  for (std::vector<Vec3>& column : columns)
    column = less_registration(rigid, std::move(column));
  return columns;
}

void SkinResidual::normal_equations(const std::vector<Vec3>& displacement,
                                    const std::vector<std::vector<Vec3>>& columns,
                                    Eigen::MatrixXd& H, Eigen::VectorXd& g) const
{
  const auto whole = along_directions(directions(displacement), columns);
  const auto c = seen(displacement, columns);
  const std::vector<Vec3> off = at(displacement);
  const auto n = static_cast<Eigen::Index>(c.size());
  H = Eigen::MatrixXd::Zero(n, n);
  g = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const auto& ci = c[static_cast<std::size_t>(i)];
    g[i] = product(m_weight, ci, off);
    for (Eigen::Index j = 0; j <= i; ++j)
      H(i, j) = H(j, i) = product(m_weight, ci, whole[static_cast<std::size_t>(j)]);
  }
}

SkinResidual skin_residual(const FaceModel& face, const SkinTarget& target, double wish_weight)
{
  SkinResidual residual(target, fit_weights(face, target));
  std::vector<Vec3> positions(face.skin.vertices.size(), Vec3::Zero());
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    const SkinWeights& w = face.skin.vertices[v];
    for (std::size_t i = 0; i < static_cast<std::size_t>(w.count); ++i)
      positions[v] += w.weight[i] * face.tissue.rest()[static_cast<std::size_t>(w.control[i])];
  }
  residual.doubt_registration(std::move(positions), wish_weight);
  return residual;
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
