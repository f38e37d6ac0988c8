#pragma once

#include <optional>
#include <vector>

/// How stiff must the springs be that bring the skin near enough to its target?
namespace f2b
{

/// The skin's residual at equilibrium with springs of one stiffness.
struct StiffnessTrial
{
  double stiffness = 0;   ///< K_e [N/mm^3]
  double residual_mm = 0; ///< infinite where no equilibrium was found
};

/// A safeguarded search in log K_e for a residual within [0.9, 0.99] of the wanted one.
///
/// Springs in series with the tissue leave m(K) = m(0) / (1 + K / k): that gives the second trial,
/// secants in (log K, log m) the next ones, each held well inside its bracket. Softer springs bias
/// the fragments' movement more, stiffer ones tear at the tissue: the wanted residual is met, not
/// undercut. Where the residual rises again, as under a dead load that overshoots, or is infinite,
/// its least value is looked for by golden section. The search knows nothing of tissue: it is told
/// residuals and says what to try next.
class StiffnessSearch
{
public:
  static constexpr double least = 1e-7, most = 1e3; ///< that are tried [N/mm^3]

  /// \param at_rest  the residual without force, above the wanted one [mm]
  /// \param wanted   > 0 [mm]
  /// \param first    that is tried first [N/mm^3]
  StiffnessSearch(double at_rest, double wanted, double first);

  /// The stiffness to try next; nothing when the search is over.
  std::optional<double> next() const;
  void tell(const StiffnessTrial& trial);

  /// Whether the best trial leaves no more than the wanted residual.
  bool met() const { return best().residual_mm <= m_wanted; }
  /// The softest trial that meets the wanted residual; without one, that of the least residual,
  /// which may be the one without force.
  const StiffnessTrial& best() const { return m_trials[best_index()]; }

private:
  std::size_t best_index() const;
  std::optional<double> stiffer() const;
  std::optional<double> within_bracket(std::size_t met) const;
  std::optional<double> nearer_to_least(std::size_t best) const;

  double m_wanted, m_aim, m_first;
  std::vector<StiffnessTrial> m_trials; ///< ascending in stiffness, the first without force
};

} // namespace f2b
