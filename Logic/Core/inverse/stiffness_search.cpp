#include "Core/inverse/stiffness_search.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace f2b
{
namespace
{

/// The stiffness at which springs in series would leave `aim`, by one trial and the state at rest.
double in_series(const StiffnessTrial& trial, double at_rest, double aim)
{
  const double tissue = trial.stiffness * trial.residual_mm / (at_rest - trial.residual_mm);
  return tissue * (at_rest / aim - 1);
}

/// The stiffness at which the line through two trials in (log K, log m) reaches `aim`.
double by_secant(const StiffnessTrial& a, const StiffnessTrial& b, double aim)
{
  const double slope =
      std::log(b.residual_mm / a.residual_mm) / std::log(b.stiffness / a.stiffness);
  return b.stiffness * std::exp(std::log(aim / b.residual_mm) / slope);
}

/// Inside [low, high], a share of its logarithmic length away from both ends.
double well_inside(double stiffness, double low, double high)
{
  const double margin = 0.1 * std::log(high / low);
  return std::clamp(stiffness, low * std::exp(margin), high * std::exp(-margin));
}

} // namespace

StiffnessSearch::StiffnessSearch(double at_rest, double wanted, double first)
    : m_wanted(wanted), m_aim(0.95 * wanted), m_first(first), m_trials{{0, at_rest}}
{
  assert(wanted > 0 && at_rest > wanted && first > 0);
}

void StiffnessSearch::tell(const StiffnessTrial& trial)
{
  const auto after = std::upper_bound(m_trials.begin(), m_trials.end(), trial,
                                      [](const StiffnessTrial& a, const StiffnessTrial& b)
                                      { return a.stiffness < b.stiffness; });
  m_trials.insert(after, trial);
}

std::size_t StiffnessSearch::best_index() const
{
  std::size_t best = 0;
  for (std::size_t i = 0; i < m_trials.size(); ++i)
  {
    if (m_trials[i].residual_mm <= m_wanted)
      return i;
    if (m_trials[i].residual_mm < m_trials[best].residual_mm)
      best = i;
  }
  return best;
}

std::optional<double> StiffnessSearch::next() const
{
  if (m_trials.size() == 1)
    return m_first;
  const std::size_t best = best_index();
  if (met())
    return within_bracket(best);
  return best + 1 == m_trials.size() ? stiffer() : nearer_to_least(best);
}

/// The stiffest trial is the best so far, and not good enough.
std::optional<double> StiffnessSearch::stiffer() const
{
  const StiffnessTrial &last = m_trials.back(), &before = m_trials[m_trials.size() - 2];
  if (last.stiffness >= most)
    return std::nullopt;
  const double guess = before.stiffness > 0 ? by_secant(before, last, m_aim)
                                            : in_series(last, m_trials.front().residual_mm, m_aim);
  return std::min(most, std::clamp(guess, 1.5 * last.stiffness, 30 * last.stiffness));
}

/// A trial meets the wanted residual, perhaps by too much.
std::optional<double> StiffnessSearch::within_bracket(std::size_t met) const
{
  const StiffnessTrial &low = m_trials[met - 1], &high = m_trials[met];
  if (high.residual_mm >= 0.9 * m_wanted || high.stiffness < 1.02 * low.stiffness)
    return std::nullopt;
  if (low.stiffness == 0)
  {
    if (high.stiffness <= least)
      return std::nullopt;
    const double guess = high.residual_mm > 0 ? in_series(high, low.residual_mm, m_aim) : 0;
    return std::max(least, std::clamp(guess, high.stiffness / 30, high.stiffness / 1.05));
  }
  if (!std::isfinite(low.residual_mm) || high.residual_mm <= 0)
    return std::sqrt(low.stiffness * high.stiffness);
  return well_inside(by_secant(low, high, m_aim), low.stiffness, high.stiffness);
}

/// Softer and stiffer trials are worse: one in the longer of the two intervals beside the best. No
/// equilibrium is a bound and no valley: then only the stiffer interval is of interest.
std::optional<double> StiffnessSearch::nearer_to_least(std::size_t best) const
{
  constexpr double golden = 0.382;
  const StiffnessTrial& high = m_trials[best + 1];
  if (best == 0)
    return high.stiffness > least ? std::optional(std::max(least, high.stiffness / 8))
                                  : std::nullopt;
  const double here = m_trials[best].stiffness;
  const double above = std::log(high.stiffness / here);
  if (!std::isfinite(high.residual_mm))
    return above > std::log(1.1) ? std::optional(here * std::exp(above / 2)) : std::nullopt;
  const double softer = std::max(m_trials[best - 1].stiffness, here / 8);
  const double below = std::log(here / softer);
  if (above + below < std::log(1.1))
    return std::nullopt;
  return here * std::exp(above > below ? golden * above : -golden * below);
}

} // namespace f2b
