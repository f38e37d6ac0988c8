#include "Core/inverse/live_operator.hpp"

#include "Core/error.hpp"
#include "Core/inverse/box_step.hpp"
#include "Core/inverse/skin_sensitivity.hpp"

#include <Eigen/Cholesky>

#include <cmath>

namespace f2b
{
namespace
{

using Stacked = Eigen::Map<const Eigen::VectorXd>;

/// Vectors one below the other.
Stacked stacked(const std::vector<Vec3>& field)
{
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {field.empty() ? nullptr : field.front().data(),
          3 * static_cast<Eigen::Index>(field.size())};
}

RigidFitResult rest_plan(const FaceModel& face, const RigidFitOptions& options)
{
  const MovementSpace space = movement_space(face, options);
  RigidFitResult plan;
  plan.q = space.start();
  plan.x = face.tissue.rest();
  plan.skin_displacement.assign(face.skin.vertices.size(), Vec3::Zero());
  const std::vector<RigidMotion> motions = space.motions(plan.q);
  if (with_fragments_moved(face.tissue, motions) == plan.x)
    return plan;
  Prediction moved = predict_face(face, motions, options.equilibrium, no_progress);
  if (!moved.summary.converged())
    throw Error("plan", "the tissue cannot follow the movement that the bounds ask for",
                "let the bounds include smaller movements", ErrorKind::Numerical);
  plan.x = std::move(moved.x);
  plan.skin_displacement = std::move(moved.skin_displacement);
  return plan;
}

} // namespace

LiveOperator::LiveOperator(const FaceModel& face, const RigidFitOptions& options,
                           const Progress& progress)
    : LiveOperator(face, options, rest_plan(face, options), progress)
{
}

LiveOperator::LiveOperator(const FaceModel& face, const RigidFitOptions& options,
                           const RigidFitResult& plan, const Progress& progress)
    : m_face(face), m_options(options), m_space(movement_space(face, options)), m_q0(plan.q),
      m_x(plan.x), m_u0(stacked(plan.skin_displacement))
{
  linearize(progress);
  set_weight(std::vector<double>(face.skin_area.size(), 1.0));
}

/// Distance between two plans as bone moves: an angle counts as 50 mm of lever.
double LiveOperator::length_mm(const Eigen::VectorXd& change) const
{
  constexpr double lever_mm = 50;
  double sum = 0;
  for (Eigen::Index k = 0; k < change.size(); ++k)
  {
    const bool is_angle = m_space.coordinates()[static_cast<std::size_t>(k)].is_angle();
    const double part = is_angle ? lever_mm * change[k] : change[k];
    sum += part * part;
  }
  return std::sqrt(sum);
}

void LiveOperator::linearize(const Progress& progress)
{
  constexpr double shortest_mm = 2, probe_mm = 3;
  progress("preparing the live preview", 0);
  ElasticModel model(m_face.tissue, m_face.materials,
                     held_controls(m_face.tissue, Held::BoneAndFragments));
  EquilibriumOptions rough = m_options.equilibrium;
  rough.step_tolerance_mm = std::max(rough.step_tolerance_mm, 1e-5); // a doubt needs two digits
  EquilibriumSolver solver(model, rough);
  const auto columns = skin_columns(m_face, m_space, m_q0, m_x, solver, 1e-8);
  m_C.resize(m_u0.size(), m_space.size());
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
    m_C.col(k) = stacked(columns[static_cast<std::size_t>(k)]);

  progress("preparing the live preview", 0.5);
  m_probe_q = m_space.start();
  m_probe_u = Eigen::VectorXd::Zero(m_u0.size());
  if (length_mm(m_probe_q - m_q0) > shortest_mm &&
      with_fragments_moved(m_face.tissue, m_space.motions(m_probe_q)) == m_face.tissue.rest())
    return;
  m_probe_q = m_q0;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
  {
    const MovementSpace::Coordinate& c = m_space.coordinates()[static_cast<std::size_t>(k)];
    const double step = c.is_angle() ? probe_mm / 50 : probe_mm / std::sqrt(3.0);
    m_probe_q[k] += m_q0[k] + step <= c.rule.most ? step : -step;
  }
  m_probe_q = m_probe_q.cwiseMax(m_space.least()).cwiseMin(m_space.most());
  std::vector<Vec3> x = m_x;
  const EquilibriumSummary solve =
      solver.move_to(x, with_fragments_moved(m_face.tissue, m_space.motions(m_probe_q)));
  if (!solve.converged()) // nothing is known about how far the linearisation holds
    m_probe_q = m_q0;
  m_probe_u = stacked(m_face.skin.displacement(x));
}

double LiveOperator::off_mm(const Eigen::VectorXd& skin) const
{
  const double area = m_weight.sum() / 3;
  return area > 0 ? std::sqrt(skin.cwiseAbs2().dot(m_weight) / area) : 0;
}

void LiveOperator::set_weight(const std::vector<double>& weight)
{
  const std::vector<double> area = fit_weights(m_face, {{}, weight, {}});
  m_weight.resize(m_u0.size());
  for (std::size_t v = 0; v < area.size(); ++v)
    m_weight.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(area[v]);
  m_H = m_C.transpose() * m_weight.asDiagonal() * m_C;
  const Eigen::MatrixXd slopes = m_space.wish_slopes(m_q0);
  m_H += m_options.skin_sd_mm * m_options.skin_sd_mm * m_options.patch_area_mm2 *
         slopes.transpose() * slopes;
  if (m_H.size() && !(m_H.ldlt().vectorD().minCoeff() > 1e-10 * m_H.diagonal().maxCoeff()))
    throw Error("target", "it leaves a combination of the fragments' movements free",
                "widen the target's mask, lock a coordinate or give it a prior",
                ErrorKind::Numerical);
  const double distance = length_mm(m_probe_q - m_q0);
  m_curvature = distance > 0 ? off_mm(m_probe_u - skin_at(m_probe_q)) / (distance * distance)
                             : std::numeric_limits<double>::infinity();
}

Eigen::VectorXd LiveOperator::skin_at(const Eigen::VectorXd& q) const
{
  return m_u0 + m_C * (q - m_q0);
}

LiveOperator::Answer LiveOperator::update(const std::vector<Vec3>& displacement) const
{
  Eigen::VectorXd g = m_C.transpose() * m_weight.cwiseProduct(m_u0 - stacked(displacement));
  g += m_options.skin_sd_mm * m_options.skin_sd_mm * m_options.patch_area_mm2 *
       m_space.wish_slopes(m_q0).transpose() * m_space.wishes(m_q0);
  Answer answer;
  answer.q = m_q0 + box_step(m_H, g, m_space.least() - m_q0, m_space.most() - m_q0);
  answer.motions = m_space.motions(answer.q);
  const Eigen::VectorXd skin = skin_at(answer.q);
  answer.skin_displacement.resize(displacement.size());
  for (std::size_t v = 0; v < displacement.size(); ++v)
    answer.skin_displacement[v] = skin.segment<3>(3 * static_cast<Eigen::Index>(v));
  const double distance = length_mm(answer.q - m_q0);
  answer.doubt_mm = distance > 0 ? m_curvature * distance * distance : 0;
  return answer;
}

} // namespace f2b
