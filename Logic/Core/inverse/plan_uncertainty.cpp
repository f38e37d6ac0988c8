#include "Core/inverse/plan_uncertainty.hpp"

#include "Core/error.hpp"
#include "Core/inverse/box_step.hpp"
#include "Core/inverse/skin_sensitivity.hpp"
#include "Core/material/law_variation.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <unordered_map>

namespace f2b
{
namespace
{

using Field = std::vector<Vec3>;

/// Vertices by the cell of a lattice that they lie in.
class Neighbourhood
{
public:
  Neighbourhood(const std::vector<Vec3>& points, const std::vector<double>& weight, double reach)
      : m_points(points), m_reach(reach)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      if (weight[v] > 0)
        m_cells[key(cell(points[v]))].push_back(v);
  }
  /// Calls visit(w, squared distance) for every vertex within reach of v, itself included.
  template <class Visit>
  void around(std::size_t v, const Visit& visit) const
  {
    const std::array<long, 3> here = cell(m_points[v]);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k)
        {
          const auto found = m_cells.find(key({here[0] + i, here[1] + j, here[2] + k}));
          if (found == m_cells.end())
            continue;
          for (const std::size_t w : found->second)
          {
            const double squared = (m_points[w] - m_points[v]).squaredNorm();
            if (squared <= m_reach * m_reach)
              visit(w, squared);
          }
        }
  }

private:
  std::array<long, 3> cell(const Vec3& p) const
  {
    return {std::lround(p.x() / m_reach), std::lround(p.y() / m_reach),
            std::lround(p.z() / m_reach)};
  }
  static long key(const std::array<long, 3>& c)
  {
    constexpr long wide = 1 << 20;
    return (c[0] * wide + c[1]) * wide + c[2];
  }

  const std::vector<Vec3>& m_points;
  double m_reach;
  std::unordered_map<long, std::vector<std::size_t>> m_cells;
};

/// The linearised fit around its solution.
class Propagation
{
public:
  Propagation(const FaceModel& face, const SkinTarget& target, const RigidFitOptions& options,
              const RigidFitResult& plan)
      : m_face(face), m_plan(plan), m_space(movement_space(face, options)),
        m_residual(skin_residual(face, target, options.wish_weight())),
        m_model(face.tissue, face.materials, held_controls(face.tissue, Held::BoneAndFragments)),
        m_solver(m_model, options.equilibrium)
  {
    auto columns = skin_columns(face, m_space, plan.q, plan.x, m_solver, 1e-10);
    Eigen::MatrixXd H;
    Eigen::VectorXd g;
    m_residual.normal_equations(plan.skin_displacement, columns, H, g);
    const Eigen::MatrixXd slopes = m_space.wish_slopes(plan.q);
    H += options.wish_weight() * slopes.transpose() * slopes;
    m_columns = m_residual.seen(plan.skin_displacement, std::move(columns));
    hold_bounds(H);
    m_factor.compute(H);
    // rounding of the equilibrium is far above this share of the largest stiffness
    if (H.size() && m_factor.vectorD().minCoeff() < 1e-10 * H.diagonal().maxCoeff())
      throw Error("target", "it leaves a combination of the fragments' movements free",
                  "widen the target's mask, lock a coordinate or give it a prior",
                  ErrorKind::Numerical);
  }

  /// dq for a change of the skin that the plan predicts.
  Eigen::VectorXd answer(const Field& skin_change) const
  {
    Eigen::VectorXd projected(m_space.size());
    for (Eigen::Index k = 0; k < projected.size(); ++k)
    {
      projected[k] = 0;
      const Field& column = m_columns[static_cast<std::size_t>(k)];
      for (std::size_t v = 0; v < column.size(); ++v)
        projected[k] += m_residual.weight()[v] * column[v].dot(skin_change[v]);
    }
    return solve(-projected);
  }
  /// dq for a change of the tissue: its forces on the unknowns in the plan's state, in columns.
  std::vector<Eigen::VectorXd> answers_to_forces(const Eigen::MatrixXd& forces)
  {
    std::vector<Eigen::VectorXd> answers;
    for (const Field& change : m_solver.yield_to(m_plan.x, -forces))
      answers.push_back(answer(m_face.skin.of_change(change)));
    return answers;
  }
  Eigen::MatrixXd noise_covariance(const std::vector<Vec3>& positions,
                                   const UncertaintySources& sources) const;
  Eigen::VectorXd solve(Eigen::VectorXd right_hand_side) const
  {
    for (const Eigen::Index k : m_plan.at_bounds)
      right_hand_side[k] = 0;
    return m_factor.solve(right_hand_side);
  }
  Eigen::Index size() const { return m_space.size(); }
  std::vector<char> prescribed() const
  {
    return held_controls(m_face.tissue, Held::BoneAndFragments);
  }
  Eigen::VectorXd forces() const { return m_model.forces(m_plan.x); }

private:
  void hold_bounds(Eigen::MatrixXd& H) const
  {
    for (const Eigen::Index k : m_plan.at_bounds)
      hold_coordinate(H, k);
  }

  const FaceModel& m_face;
  const RigidFitResult& m_plan;
  MovementSpace m_space;
  SkinResidual m_residual;
  ElasticModel m_model;
  EquilibriumSolver m_solver;
  std::vector<Field> m_columns;
  Eigen::LDLT<Eigen::MatrixXd> m_factor;
};

/// H^-1 C^T W N W C H^-1 with N the covariance of noise that is alike in all three components.
Eigen::MatrixXd Propagation::noise_covariance(const std::vector<Vec3>& positions,
                                              const UncertaintySources& sources) const
{
  const std::vector<double>& weight = m_residual.weight();
  const double length = sources.skin_correlation_mm;
  const bool white = length < 0.1; // mm: below the distance of neighbouring vertices
  const Neighbourhood near(positions, weight, white ? 1.0 : 3 * length);
  const Eigen::Index n = size();
  std::vector<Eigen::MatrixXd> rows(positions.size());
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    if (weight[v] <= 0)
      continue;
    Eigen::MatrixXd smoothed = Eigen::MatrixXd::Zero(3, n), own(3, n);
    near.around(v,
                [&](std::size_t w, double squared)
                {
                  const double c =
                      white ? (v == w ? 1.0 : 0.0) : std::exp(-0.5 * squared / (length * length));
                  for (Eigen::Index k = 0; c > 0 && k < n; ++k)
                    smoothed.col(k) += c * weight[w] * m_columns[static_cast<std::size_t>(k)][w];
                });
    for (Eigen::Index k = 0; k < n; ++k)
      own.col(k) = weight[v] * m_columns[static_cast<std::size_t>(k)][v];
    rows[v] = own.transpose() * smoothed;
  }
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(n, n);
  for (const Eigen::MatrixXd& row : rows)
    if (row.size())
      spread += row;
  Eigen::MatrixXd half(n, n);
  for (Eigen::Index k = 0; k < n; ++k)
    half.col(k) = solve(spread.col(k));
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index k = 0; k < n; ++k)
    covariance.col(k) = solve(half.transpose().col(k));
  return sources.skin_sd_mm * sources.skin_sd_mm * covariance;
}

/// The mesh with its skin thicker by a share of its thickness, towards the inside.
MixedMesh with_thicker_skin(const MixedMesh& mesh, double share)
{
  std::vector<Vec3> shift(mesh.X.size(), Vec3::Zero());
  std::vector<int> prisms(mesh.X.size(), 0);
  for (const auto& prism : mesh.prisms)
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto top = static_cast<std::size_t>(prism[c]);
      const auto bottom = static_cast<std::size_t>(prism[c + 3]);
      shift[bottom] += share * (mesh.X[bottom] - mesh.X[top]);
      ++prisms[bottom];
    }
  MixedMesh result = mesh;
  for (std::size_t n = 0; n < shift.size(); ++n)
    if (prisms[n] > 0 && mesh.node_boundary[n] == Boundary::Interior)
      result.X[n] += shift[n] / prisms[n];
  return result;
}

/// Mean distance between the faces of the prisms [mm].
double mean_thickness(const MixedMesh& mesh)
{
  double sum = 0;
  for (const auto& prism : mesh.prisms)
    for (std::size_t c = 0; c < 3; ++c)
      sum += (mesh.X[static_cast<std::size_t>(prism[c + 3])] -
              mesh.X[static_cast<std::size_t>(prism[c])])
                 .norm();
  return mesh.prisms.empty() ? 0 : sum / (3 * static_cast<double>(mesh.prisms.size()));
}

/// Forces of a changed tissue on the unknowns, the displacements being the plan's.
Eigen::VectorXd forces_of(const Discretization& tissue, const MaterialSet& materials,
                          const FaceModel& face, const RigidFitResult& plan,
                          const std::vector<char>& prescribed)
{
  std::vector<Vec3> x = tissue.rest();
  for (std::size_t c = 0; c < x.size(); ++c)
    x[c] += plan.x[c] - face.tissue.rest()[c];
  return ElasticModel(tissue, materials, prescribed).forces(x);
}

constexpr double small = 0.001; // relative change of a parameter: beyond it, forces bend

/// Forces per standard deviation of every tissue's stiffness, then of Poisson's ratio and of the
/// skin's thickness.
Eigen::MatrixXd forces_of_causes(const FaceModel& face, const RigidFitResult& plan,
                                 const Propagation& fit, const UncertaintySources& sources)
{
  const Eigen::VectorXd before = fit.forces();
  const std::vector<char> prescribed = fit.prescribed();
  Eigen::MatrixXd forces(before.size(), tissue_count + 2);
  for (int t = 0; t < tissue_count; ++t)
  {
    MaterialSet changed = face.materials;
    Law& law = changed.laws[static_cast<std::size_t>(t)];
    law = stiffened(law, 1 + small);
    forces.col(t) = (forces_of(face.tissue, changed, face, plan, prescribed) - before) *
                    (sources.stiffness_log_sd / std::log1p(small));
  }
  MaterialSet squeezed = face.materials;
  const double less = 1e-4; // of Poisson's ratio
  for (Law& law : squeezed.laws)
    law = with_poisson_ratio(law, poisson_ratio(law) - less);
  forces.col(tissue_count) = (forces_of(face.tissue, squeezed, face, plan, prescribed) - before) *
                             (sources.poisson_ratio_sd / less);
  const MixedMesh thicker = with_thicker_skin(face.tissue.mesh(), small);
  const Discretization thicker_tissue(thicker, face.tissue.scheme());
  const double added = small * mean_thickness(face.tissue.mesh());
  forces.col(tissue_count + 1).setZero();
  if (thicker_tissue.control_count() == face.tissue.control_count() && added > 0)
    forces.col(tissue_count + 1) =
        (forces_of(thicker_tissue, face.materials, face, plan, prescribed) - before) *
        (sources.skin_thickness_sd_mm / added);
  return forces;
}

} // namespace

double CoordinateUncertainty::sd() const
{
  double sum = noise * noise + registration * registration + poisson_ratio * poisson_ratio +
               skin_thickness * skin_thickness;
  for (const double s : stiffness)
    sum += s * s;
  return std::sqrt(sum);
}

std::vector<CoordinateUncertainty> plan_uncertainty(const FaceModel& face, const SkinTarget& target,
                                                    const RigidFitOptions& options,
                                                    const RigidFitResult& plan,
                                                    const std::vector<Vec3>& positions,
                                                    const UncertaintySources& sources)
{
  Propagation fit(face, target, options, plan);
  std::vector<CoordinateUncertainty> result(static_cast<std::size_t>(fit.size()));
  const Eigen::MatrixXd noise = fit.noise_covariance(positions, sources);
  for (Eigen::Index k = 0; k < fit.size(); ++k)
    result[static_cast<std::size_t>(k)].noise = std::sqrt(std::max(0.0, noise(k, k)));
  for (int axis = 0; axis < 3; ++axis)
  {
    const Field shift(positions.size(), sources.registration_sd_mm * Vec3::Unit(axis));
    const Eigen::VectorXd dq = fit.answer(shift);
    for (Eigen::Index k = 0; k < dq.size(); ++k)
    {
      double& sd = result[static_cast<std::size_t>(k)].registration;
      sd = std::hypot(sd, dq[k]);
    }
  }
  const auto answers = fit.answers_to_forces(forces_of_causes(face, plan, fit, sources));
  for (std::size_t k = 0; k < result.size(); ++k)
  {
    const auto row = static_cast<Eigen::Index>(k);
    for (std::size_t t = 0; t < tissue_count; ++t)
      result[k].stiffness[t] = std::abs(answers[t][row]);
    result[k].poisson_ratio = std::abs(answers[tissue_count][row]);
    result[k].skin_thickness = std::abs(answers[tissue_count + 1][row]);
  }
  return result;
}

} // namespace f2b
