#include "Case/live_plan.hpp"

#include "Case/movement_rules.hpp"
#include "Core/error.hpp"
#include "Core/inverse/reachability_words.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{

LivePlan::LivePlan(const CaseSession& session)
    : m_face(session), m_model(m_face.model()), m_mask_mm(session.settings.target.mask_mm)
{
  m_options.rules = movement_rules(session, m_face.mesh);
  m_options.max_iterations = session.settings.max_fit_iterations;
  m_options.equilibrium = equilibrium_options(session.settings);
}

void LivePlan::prepare(const Progress& progress)
{
  m_operator = std::make_unique<LiveOperator>(m_model, m_options, progress);
}

std::vector<char> LivePlan::known_skin() const
{
  std::vector<char> known;
  for (const double area : m_face.skin_area)
    known.push_back(area > 0);
  return known;
}

/// As the verb `target` masks: what is moved by less than the mask may do as it likes.
std::vector<double> LivePlan::weights(const std::vector<Vec3>& displacement) const
{
  std::vector<double> weight(displacement.size(), 1.0);
  for (std::size_t v = 0; v < weight.size(); ++v)
    if (m_mask_mm > 0 && displacement[v].squaredNorm() < m_mask_mm * m_mask_mm)
      weight[v] = 0;
  if (std::none_of(weight.begin(), weight.end(), [](double w) { return w > 0; }))
    throw Error("target", "it moves no skin by as much as its mask",
                "sculpt the face first, or lower the mask");
  return weight;
}

std::vector<double> LivePlan::unreached(const std::vector<Vec3>& wanted,
                                        const std::vector<Vec3>& got) const
{
  std::vector<double> left(wanted.size(), std::nan(""));
  for (std::size_t v = 0; v < wanted.size(); ++v)
    if (m_face.skin_area[v] > 0 &&
        !(m_mask_mm > 0 && wanted[v].squaredNorm() < m_mask_mm * m_mask_mm))
      left[v] = (wanted[v] - got[v]).norm();
  return left;
}

std::vector<std::string> LivePlan::notes_on(const std::vector<int>& held_fragments) const
{
  std::vector<std::string> notes;
  for (const int f : held_fragments)
    notes.push_back(stays_unseen(fragments()[static_cast<std::size_t>(f)]));
  return notes;
}

FollowedPlan LivePlan::preview(const std::vector<Vec3>& displacement)
{
  m_operator->set_weight(weights(displacement));
  LiveOperator::Answer answer = m_operator->update(displacement);
  FollowedPlan plan;
  plan.unreached_mm = unreached(displacement, answer.skin_displacement);
  plan.motions = std::move(answer.motions);
  plan.skin_displacement = std::move(answer.skin_displacement);
  plan.doubt_mm = answer.doubt_mm;
  plan.notes = notes_on(answer.held_fragments);
  return plan;
}

FollowedPlan LivePlan::solve(const std::vector<Vec3>& displacement, const Progress& progress) const
{
  const SkinTarget target{displacement, weights(displacement), {}};
  RigidFitResult fit = fit_fragments(m_model, target, m_options, progress);
  if (fit.termination == RigidFitTermination::EquilibriumLost)
    throw Error("plan", "the tissue cannot follow even a small movement towards this target",
                "ask for less, or release more tissue along the cuts", ErrorKind::Numerical);
  FollowedPlan plan;
  plan.notes = notes_on(fit.held_fragments);
  plan.unreached_mm = unreached(displacement, fit.skin_displacement);
  plan.motions = std::move(fit.motions);
  plan.skin_displacement = std::move(fit.skin_displacement);
  plan.solved = true;
  return plan;
}

FollowedPlan LivePlan::predict(const std::vector<RigidMotion>& motions,
                               const std::vector<Vec3>& displacement,
                               const Progress& progress) const
{
  Prediction moved = predict_face(m_model, motions, m_options.equilibrium, progress);
  require_converged(moved.summary, "prediction", {});
  FollowedPlan plan;
  plan.motions = motions;
  plan.unreached_mm = unreached(displacement, moved.skin_displacement);
  plan.skin_displacement = std::move(moved.skin_displacement);
  plan.solved = true;
  return plan;
}

} // namespace f2b
