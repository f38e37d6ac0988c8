#include "Core/inverse/live_operator.hpp"

#include "Core/error.hpp"
#include "Core/inverse/box_step.hpp"
#include "Core/inverse/skin_sensitivity.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
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
      m_x(plan.x), m_u0(stacked(plan.skin_displacement)),
      m_area(fit_weights(face, {{}, std::vector<double>(face.skin_area.size(), 1.0), {}}))
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
  m_moved_skin = moved_skin(columns, m_area);

  progress("preparing the live preview", 0.5);
  const auto keep_error = [&](const Eigen::VectorXd& at_probe)
  {
    const Eigen::VectorXd error = at_probe - skin_at(m_probe_q);
    m_probe_error = error.reshaped(3, error.size() / 3).colwise().squaredNorm().transpose();
  };
  m_probe_q = m_space.start();
  if (length_mm(m_probe_q - m_q0) > shortest_mm &&
      with_fragments_moved(m_face.tissue, m_space.motions(m_probe_q)) == m_face.tissue.rest())
    return keep_error(Eigen::VectorXd::Zero(m_u0.size()));
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
  keep_error(stacked(m_face.skin.displacement(x)));
}

/// The normal equations, from the vertices that count: a stroke moves a few of many.
Eigen::MatrixXd LiveOperator::normal_matrix() const
{
  constexpr Eigen::Index most_rows = 768; // what the nearest cache holds
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(m_C.cols(), m_C.cols());
  decltype(m_C) rows(most_rows, m_C.cols());
  Eigen::Index filled = 0;
  const auto add_up = [&]
  {
    sum.selfadjointView<Eigen::Lower>().rankUpdate(rows.topRows(filled).transpose());
    filled = 0;
  };
  for (const Eigen::Index v : m_counting)
  {
    rows.middleRows<3>(filled) =
        std::sqrt(m_weight[static_cast<std::size_t>(v)]) * m_C.middleRows<3>(3 * v);
    filled += 3;
    if (filled == most_rows)
      add_up();
  }
  add_up();
  return sum.selfadjointView<Eigen::Lower>();
}

void LiveOperator::set_weight(const std::vector<double>& weight)
{
  std::vector<double> counting(m_area.size());
  for (std::size_t v = 0; v < m_area.size(); ++v)
    counting[v] = m_area[v] * weight[v];
  if (counting == m_weight)
    return;
  m_weight = std::move(counting);
  m_counting.clear();
  double total = 0, probe_error = 0;
  for (std::size_t v = 0; v < m_weight.size(); ++v)
    if (m_weight[v] != 0)
    {
      m_counting.push_back(static_cast<Eigen::Index>(v));
      total += m_weight[v];
      probe_error += m_weight[v] * m_probe_error[static_cast<Eigen::Index>(v)];
    }
  m_H = normal_matrix();
  m_held_fragments = unseen_fragments(m_space, m_q0, m_H.diagonal(), m_moved_skin);
  const Eigen::MatrixXd slopes = m_space.wish_slopes(m_q0);
  m_H += m_options.skin_sd_mm * m_options.skin_sd_mm * m_options.patch_area_mm2 *
         slopes.transpose() * slopes;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
    if (is_held(k))
    {
      m_H.row(k).setZero();
      m_H.col(k).setZero();
      m_H(k, k) = 1;
    }
  if (m_H.size() && !(m_H.ldlt().vectorD().minCoeff() > 1e-10 * m_H.diagonal().maxCoeff()))
  {
    m_weight.clear(); // the same weights are refused again
    throw Error("target", "it leaves a combination of the fragments' movements free",
                "widen the target's mask, lock a coordinate or give it a prior",
                ErrorKind::Numerical);
  }
  const double distance = length_mm(m_probe_q - m_q0);
  const double off_mm = total > 0 ? std::sqrt(probe_error / total) : 0;
  m_curvature =
      distance > 0 ? off_mm / (distance * distance) : std::numeric_limits<double>::infinity();
}

bool LiveOperator::is_held(Eigen::Index k) const
{
  return std::find(m_held_fragments.begin(), m_held_fragments.end(),
                   m_space.coordinates()[static_cast<std::size_t>(k)].fragment) !=
         m_held_fragments.end();
}

Eigen::VectorXd LiveOperator::skin_at(const Eigen::VectorXd& q) const
{
  return m_u0 + m_C * (q - m_q0);
}

LiveOperator::Answer LiveOperator::update(const std::vector<Vec3>& displacement) const
{
  const Stacked wanted = stacked(displacement);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(m_C.cols());
  for (const Eigen::Index v : m_counting)
    g += m_C.middleRows<3>(3 * v).transpose() *
         (m_weight[static_cast<std::size_t>(v)] * (m_u0 - wanted).segment<3>(3 * v));
  g += m_options.skin_sd_mm * m_options.skin_sd_mm * m_options.patch_area_mm2 *
       m_space.wish_slopes(m_q0).transpose() * m_space.wishes(m_q0);
  Eigen::VectorXd least = m_space.least() - m_q0, most = m_space.most() - m_q0;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
    if (is_held(k))
      g[k] = least[k] = most[k] = 0;
  Answer answer;
  answer.held_fragments = m_held_fragments;
  answer.q = m_q0 + box_step(m_H, g, least, most);
  answer.motions = m_space.motions(answer.q);
  answer.skin_displacement.resize(displacement.size());
  Eigen::Map<Eigen::VectorXd>(answer.skin_displacement.front().data(), m_u0.size()) =
      skin_at(answer.q);
  const double distance = length_mm(answer.q - m_q0);
  answer.doubt_mm = distance > 0 ? m_curvature * distance * distance : 0;
  return answer;
}

} // namespace f2b
