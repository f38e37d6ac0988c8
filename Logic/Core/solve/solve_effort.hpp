#pragma once

#include <chrono>

/// What did solving cost, and where did the time go?
namespace f2b
{

struct SolveEffort
{
  int linearizations = 0;
  int analyses = 0;       ///< orderings and symbolic factorisations
  int factorizations = 0; ///< numeric, whether they succeeded or not
  int back_solves = 0;    ///< with a factor, each for one or several right-hand sides
  int cg_iterations = 0;
  int energy_evaluations = 0;

  // seconds
  double assembly = 0;
  double energy = 0; ///< energies and volume ratios of trial states
  double analysis = 0;
  double factorization = 0;
  double back_solving = 0;
  double products = 0; ///< of conjugate gradients
  double total = 0;

  double factorization_flops = 0; ///< of all numeric factorisations
  double factor_peak_bytes = 0;   ///< the most that the factorisation held at one time

  /// What is in none of the named parts [s].
  double rest() const
  {
    return total - assembly - energy - analysis - factorization - back_solving - products;
  }
  /// Of the numeric factorisations [1/s]; 0 if there were none.
  double flop_rate() const { return factorization > 0 ? factorization_flops / factorization : 0; }
  void add(const SolveEffort& other);
};

/// Adds the time that it lives to a sum [s].
class TimedPart
{
public:
  explicit TimedPart(double& seconds) : m_seconds(seconds) {}
  ~TimedPart()
  {
    m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
  }
  TimedPart(const TimedPart&) = delete;
  TimedPart& operator=(const TimedPart&) = delete;

private:
  double& m_seconds;
  std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace f2b
