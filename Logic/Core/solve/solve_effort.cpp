#include "Core/solve/solve_effort.hpp"

#include <algorithm>

namespace f2b
{

void SolveEffort::add(const SolveEffort& other)
{
  linearizations += other.linearizations;
  analyses += other.analyses;
  factorizations += other.factorizations;
  back_solves += other.back_solves;
  cg_iterations += other.cg_iterations;
  energy_evaluations += other.energy_evaluations;
  assembly += other.assembly;
  energy += other.energy;
  analysis += other.analysis;
  factorization += other.factorization;
  back_solving += other.back_solving;
  products += other.products;
  total += other.total;
  factorization_flops += other.factorization_flops;
  factor_peak_bytes = std::max(factor_peak_bytes, other.factor_peak_bytes);
}

} // namespace f2b
