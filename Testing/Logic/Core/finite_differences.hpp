#pragma once

#include "Core/assembly/elastic_model.hpp"

#include <gtest/gtest.h>

#include <random>

/// Are a model's forces and stiffness the derivatives of its energy?
namespace f2b::testing
{

/// Every component moved by up to `amount`.
inline std::vector<Vec3> shaken(std::vector<Vec3> x, double amount, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> step(-amount, amount);
  for (Vec3& p : x)
    p += Vec3(step(generator), step(generator), step(generator));
  return x;
}

/// x with `scale` times a vector of the unknowns added.
inline std::vector<Vec3> moved(const ElasticModel& model, std::vector<Vec3> x,
                               const Eigen::VectorXd& direction, double scale)
{
  const auto& controls = model.unknown_controls();
  for (std::size_t i = 0; i < controls.size(); ++i)
    x[std::size_t(controls[i])] += scale * direction.segment<3>(3 * Eigen::Index(i));
  return x;
}

/// Product of a matrix that is given by its lower triangle.
inline Eigen::VectorXd product(const SymmetricMatrix& matrix, const Eigen::VectorXd& v)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(matrix.size);
  for (long c = 0; c < matrix.size; ++c)
    for (long i = matrix.column_start[std::size_t(c)]; i < matrix.column_start[std::size_t(c) + 1];
         ++i)
    {
      const long r = matrix.row[std::size_t(i)];
      result[r] += matrix.value[std::size_t(i)] * v[c];
      if (r != c)
        result[c] += matrix.value[std::size_t(i)] * v[r];
    }
  return result;
}

/// Along random directions of all unknowns, by central differences.
inline void expect_derivatives(ElasticModel& model, const std::vector<Vec3>& x,
                               double tolerance = 1e-7)
{
  const Eigen::VectorXd forces = model.linearize(x);
  EXPECT_LT((forces - model.forces(x)).norm(), 1e-13 * forces.norm());
  std::mt19937 generator(11);
  std::normal_distribution<double> component;
  const double h = 1e-5;
  for (int i = 0; i < 4; ++i)
  {
    const Eigen::VectorXd d =
        Eigen::VectorXd::NullaryExpr(model.unknown_count(), [&] { return component(generator); });
    const std::vector<Vec3> plus = moved(model, x, d, h), minus = moved(model, x, d, -h);
    EXPECT_NEAR(forces.dot(d), (model.energy(plus) - model.energy(minus)) / (2 * h),
                tolerance * forces.norm() * d.norm());
    const Eigen::VectorXd slope = (model.forces(plus) - model.forces(minus)) / (2 * h);
    EXPECT_LT((product(model.stiffness(), d) - slope).norm(), tolerance * slope.norm());
  }
}

} // namespace f2b::testing
