#include "Core/models/damped_relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

/// Sum of term(i) over all i below a count: blocks of fixed size, then the blocks in order, so that
/// it is the same for every number of threads.
template <class Term>
double ordered_sum(std::size_t count, const Term& term)
{
  constexpr std::size_t block = 1024;
  std::vector<double> parts((count + block - 1) / block, 0.0);
  const long blocks = static_cast<long>(parts.size());
#pragma omp parallel for schedule(static)
  for (long b = 0; b < blocks; ++b)
  {
    const std::size_t first = static_cast<std::size_t>(b) * block;
    double sum = 0;
    for (std::size_t i = first; i < std::min(first + block, count); ++i)
      sum += term(i);
    parts[static_cast<std::size_t>(b)] = sum;
  }
  double total = 0;
  for (const double part : parts)
    total += part;
  return total;
}

template <class Action>
void for_each_vertex(std::size_t count, const Action& action)
{
  const long n = static_cast<long>(count);
#pragma omp parallel for schedule(static)
  for (long i = 0; i < n; ++i)
    action(static_cast<std::size_t>(i));
}

class Relaxation
{
public:
  Relaxation(const MassTensors& tensors, const std::vector<char>& held)
      : m_tensors(tensors), m_held(held), m_mass(tensors.vertex_count())
  {
    for (std::size_t i = 0; i < m_mass.size(); ++i)
      m_mass[i] = tensors.of_vertex(i).trace() / 3;
  }

  double largest_eigenvalue() const;
  RelaxationSummary run(std::vector<Vec3>& u, const RelaxationOptions& options,
                        const Progress& progress) const;

private:
  /// A vertex that no tetrahedron uses has no mass: it stays where it is.
  bool moves(std::size_t i) const { return !m_held[i] && m_mass[i] > 0; }
  double relative_residual(const std::vector<Vec3>& f) const;
  double damping(const std::vector<Vec3>& v, const std::vector<Vec3>& f,
                 const std::vector<Vec3>& f_before, double dt) const;

  const MassTensors& m_tensors;
  const std::vector<char>& m_held;
  std::vector<double> m_mass; ///< [N s^2/mm]
};

double Relaxation::largest_eigenvalue() const
{
  const std::size_t n = m_mass.size();
  std::vector<Vec3> v(n, Vec3::Zero()), f;
  for (std::size_t i = 0; i < n; ++i) // no direction is favoured, nor smoothness
    if (moves(i))
      v[i] = Vec3(std::sin(12.9898 * double(i) + 1), std::sin(78.233 * double(i) + 2),
                  std::sin(37.719 * double(i) + 3));
  double eigenvalue = 0;
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    const double norm =
        std::sqrt(ordered_sum(n, [&](std::size_t i) { return m_mass[i] * v[i].squaredNorm(); }));
    if (!(norm > 0))
      return 0;
    for_each_vertex(n, [&](std::size_t i) { v[i] /= norm; });
    m_tensors.forces(v, f);
    const double before = eigenvalue;
    eigenvalue = ordered_sum(n, [&](std::size_t i) { return v[i].dot(f[i]); });
    for_each_vertex(n, [&](std::size_t i)
                    { v[i] = moves(i) ? Vec3(f[i] / m_mass[i]) : Vec3(Vec3::Zero()); });
    if (std::abs(eigenvalue - before) < 1e-4 * eigenvalue)
      break;
  }
  return 1.1 * eigenvalue;
}

double Relaxation::relative_residual(const std::vector<Vec3>& f) const
{
  auto norm_of = [&](bool moving)
  {
    return std::sqrt(ordered_sum(f.size(), [&](std::size_t i)
                                 { return moves(i) == moving ? f[i].squaredNorm() : 0.0; }));
  };
  const double residual = norm_of(true), reactions = norm_of(false);
  return residual > 0 ? residual / reactions : 0;
}

double Relaxation::damping(const std::vector<Vec3>& v, const std::vector<Vec3>& f,
                           const std::vector<Vec3>& f_before, double dt) const
{
  // the force is linear in u, so K du is its change
  const double stiffness = ordered_sum(v.size(), [&](std::size_t i)
                                       { return moves(i) ? v[i].dot(f[i] - f_before[i]) : 0.0; });
  const double mass = ordered_sum(v.size(), [&](std::size_t i)
                                  { return moves(i) ? m_mass[i] * v[i].squaredNorm() : 0.0; });
  return mass > 0 ? 2 * std::sqrt(std::max(0.0, stiffness / (dt * mass))) : 0;
}

RelaxationSummary Relaxation::run(std::vector<Vec3>& u, const RelaxationOptions& options,
                                  const Progress& progress) const
{
  RelaxationSummary summary;
  summary.largest_eigenvalue = largest_eigenvalue();
  if (!(summary.largest_eigenvalue > 0)) // nothing is free
  {
    summary.converged = true;
    return summary;
  }
  const double dt = summary.time_step = 0.95 * 2 / std::sqrt(summary.largest_eigenvalue);
  std::vector<Vec3> v(u.size(), Vec3::Zero()), f, f_before;
  m_tensors.forces(u, f);
  const double at_first = relative_residual(f);
  double c = 0;
  for (;; ++summary.steps)
  {
    if (summary.steps % 20 == 0)
    {
      summary.residual = relative_residual(f);
      summary.converged = summary.residual <= options.tolerance;
      if (summary.converged || summary.steps >= options.max_steps ||
          !std::isfinite(summary.residual))
        return summary;
      progress("relaxing", std::clamp(std::log(at_first / summary.residual) /
                                          std::log(at_first / options.tolerance),
                                      0.0, 1.0));
    }
    const double keep = (2 - c * dt) / (2 + c * dt), push = 2 * dt / (2 + c * dt);
    for_each_vertex(u.size(),
                    [&](std::size_t i)
                    {
                      if (!moves(i))
                        return;
                      v[i] = keep * v[i] - push / m_mass[i] * f[i];
                      u[i] += dt * v[i];
                    });
    f_before.swap(f);
    m_tensors.forces(u, f);
    c = damping(v, f, f_before, dt);
  }
}

} // namespace

RelaxationSummary relax(const MassTensors& tensors, std::vector<Vec3>& u,
                        const std::vector<char>& held, const RelaxationOptions& options,
                        const Progress& progress)
{
  return Relaxation(tensors, held).run(u, options, progress);
}

} // namespace f2b
