#pragma once

#include "Core/assembly/elastic_model.hpp"
#include "Core/solve/cholesky.hpp"

#include <gtest/gtest.h>

/// A body under nodal loads, with single components held: what benchmark problems need and the
/// planner does not.
namespace f2b::testing
{

class LoadedBody
{
public:
  explicit LoadedBody(ElasticModel& model)
      : m_model(model), m_free(std::size_t(model.unknown_count()), 1),
        m_load(Eigen::VectorXd::Zero(model.unknown_count()))
  {
  }
  /// Holds a component of a node at rest.
  void hold(int node, int component)
  {
    if (const long u = unknown(node); u >= 0)
      m_free[std::size_t(u + component)] = 0;
  }
  /// \param force  dead [N]
  void load(int node, const Vec3& force)
  {
    if (const long u = unknown(node); u >= 0)
      m_load.segment<3>(u) += force;
  }

  /// Newton's method in equal load steps, from x; returns the iterations of the last step, or -1.
  int solve(std::vector<Vec3>& x, int load_steps)
  {
    int iterations = 0;
    for (int step = 1; step <= load_steps && iterations >= 0; ++step)
      iterations = newton(x, double(step) / load_steps);
    return iterations;
  }
  const SymmetricMatrix& reduced_stiffness() { return reduce(m_model.stiffness()); }

private:
  long unknown(int node) const
  {
    const auto& controls = m_model.unknown_controls();
    const auto found = std::find(controls.begin(), controls.end(), node);
    return found != controls.end() ? 3 * (found - controls.begin()) : -1;
  }

  const SymmetricMatrix& reduce(const SymmetricMatrix& full)
  {
    m_number.assign(m_free.size(), -1);
    long count = 0;
    for (std::size_t u = 0; u < m_free.size(); ++u)
      if (m_free[u])
        m_number[u] = count++;
    m_reduced = {count, {0}, {}, {}};
    for (std::size_t c = 0; c < m_free.size(); ++c)
    {
      if (!m_free[c])
        continue;
      for (auto i = std::size_t(full.column_start[c]); i < std::size_t(full.column_start[c + 1]);
           ++i)
        if (const long row = m_number[std::size_t(full.row[i])]; row >= 0)
        {
          m_reduced.row.push_back(row);
          m_reduced.value.push_back(full.value[i]);
        }
      m_reduced.column_start.push_back(long(m_reduced.row.size()));
    }
    return m_reduced;
  }

  std::vector<Vec3> moved(std::vector<Vec3> x, const Eigen::VectorXd& step, double scale) const
  {
    const auto& controls = m_model.unknown_controls();
    for (std::size_t i = 0; i < controls.size(); ++i)
      for (int c = 0; c < 3; ++c)
        if (const long u = m_number[3 * i + std::size_t(c)]; u >= 0)
          x[std::size_t(controls[i])][c] += scale * step[u];
    return x;
  }

  double potential(const std::vector<Vec3>& x, double share) const
  {
    double work = 0;
    const auto& controls = m_model.unknown_controls();
    for (std::size_t i = 0; i < controls.size(); ++i)
      work += m_load.segment<3>(3 * Eigen::Index(i)).dot(x[std::size_t(controls[i])]);
    return m_model.energy(x) - share * work;
  }

  int newton(std::vector<Vec3>& x, double share)
  {
    for (int iteration = 1; iteration < 30; ++iteration)
    {
      const Eigen::VectorXd forces = m_model.linearize(x) - share * m_load;
      const SymmetricMatrix& K = reduce(m_model.stiffness());
      if (!m_analyzed)
        m_cholesky.analyze(K);
      m_analyzed = true;
      if (!m_cholesky.factorize(K))
      {
        (void)m_model.linearize(x, Tangent::Positive);
        if (!m_cholesky.factorize(reduce(m_model.stiffness())))
          return -1;
      }
      Eigen::VectorXd residual(K.size);
      for (std::size_t u = 0; u < m_free.size(); ++u)
        if (m_free[u])
          residual[m_number[u]] = forces[Eigen::Index(u)];
      const Eigen::VectorXd step = -m_cholesky.solve(residual);
      const double now = potential(x, share), slope = residual.dot(step);
      double scale = 1;
      while (!(potential(moved(x, step, scale), share) <=
               now + 1e-4 * scale * slope + 1e-12 * std::abs(now)) &&
             scale > 1e-3)
        scale /= 2;
      x = moved(x, step, scale);
      if (step.lpNorm<Eigen::Infinity>() < 1e-8)
        return iteration;
    }
    return -1;
  }

  ElasticModel& m_model;
  std::vector<char> m_free;
  std::vector<long> m_number;
  Eigen::VectorXd m_load;
  SymmetricMatrix m_reduced;
  Cholesky m_cholesky;
  bool m_analyzed = false;
};

} // namespace f2b::testing
