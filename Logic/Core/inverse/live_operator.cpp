#include "Core/inverse/live_operator.hpp"

#include "Core/error.hpp"
#include "Core/inverse/box_step.hpp"
#include "Core/inverse/skin_sensitivity.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

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
Eigen::MatrixXd LiveOperator::normal_matrix(const std::vector<Eigen::Index>& counting,
                                            const std::vector<double>& weight) const
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
  for (const Eigen::Index v : counting)
  {
    rows.middleRows<3>(filled) =
        std::sqrt(weight[static_cast<std::size_t>(v)]) * m_C.middleRows<3>(3 * v);
    filled += 3;
    if (filled == most_rows)
      add_up();
  }
  add_up();
  return sum.selfadjointView<Eigen::Lower>();
}

void LiveOperator::set_weight(const std::vector<double>& weight)
{
  Weighting next;
  next.weight.resize(m_area.size());
  double total = 0, probe_error = 0;
  for (std::size_t v = 0; v < m_area.size(); ++v)
    if ((next.weight[v] = m_area[v] * weight[v]) != 0)
    {
      next.counting.push_back(static_cast<Eigen::Index>(v));
      total += next.weight[v];
      probe_error += next.weight[v] * m_probe_error[static_cast<Eigen::Index>(v)];
    }
  if (next.weight == m_now.weight)
    return;
  next.H = normal_matrix(next.counting, next.weight);
  next.held_fragments = unseen_fragments(m_space, m_q0, next.H.diagonal(), m_moved_skin);
  const Eigen::MatrixXd slopes = m_space.wish_slopes(m_q0);
  next.H += m_options.wish_weight() * slopes.transpose() * slopes;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
    if (is_held(next, k))
      hold_coordinate(next.H, k);
  if (next.H.size() && !(next.H.ldlt().vectorD().minCoeff() > 1e-10 * next.H.diagonal().maxCoeff()))
    throw Error("target", "it leaves a combination of the fragments' movements free",
                "widen the target's mask, lock a coordinate or give it a prior",
                ErrorKind::Numerical);
  const double distance = length_mm(m_probe_q - m_q0);
  const double off_mm = total > 0 ? std::sqrt(probe_error / total) : 0;
  next.curvature =
      distance > 0 ? off_mm / (distance * distance) : std::numeric_limits<double>::infinity();
  m_now = std::move(next); // what is refused leaves the weights as they were
}

bool LiveOperator::is_held(const Weighting& now, Eigen::Index k) const
{
  return std::find(now.held_fragments.begin(), now.held_fragments.end(),
                   m_space.coordinates()[static_cast<std::size_t>(k)].fragment) !=
         now.held_fragments.end();
}

Eigen::VectorXd LiveOperator::skin_at(const Eigen::VectorXd& q) const
{
  return m_u0 + m_C * (q - m_q0);
}

LiveOperator::Answer LiveOperator::update(const std::vector<Vec3>& displacement) const
{
  assert(displacement.size() == m_area.size());
  const Stacked wanted = stacked(displacement);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(m_C.cols());
  for (const Eigen::Index v : m_now.counting)
    g += m_C.middleRows<3>(3 * v).transpose() *
         (m_now.weight[static_cast<std::size_t>(v)] * (m_u0 - wanted).segment<3>(3 * v));
  g += m_options.wish_weight() * m_space.wish_slopes(m_q0).transpose() * m_space.wishes(m_q0);
  Eigen::VectorXd least = m_space.least() - m_q0, most = m_space.most() - m_q0;
  for (Eigen::Index k = 0; k < m_space.size(); ++k)
    if (is_held(m_now, k))
      g[k] = least[k] = most[k] = 0;
  Answer answer;
  answer.held_fragments = m_now.held_fragments;
  answer.q = m_q0 + box_step(m_now.H, g, least, most);
  answer.motions = m_space.motions(answer.q);
  answer.skin_displacement.resize(displacement.size());
  Eigen::Map<Eigen::VectorXd>(answer.skin_displacement.front().data(), m_u0.size()) =
      skin_at(answer.q);
  const double distance = length_mm(answer.q - m_q0);
  answer.doubt_mm = distance > 0 ? m_now.curvature * distance * distance : 0;
  return answer;
}

} // namespace f2b
