#include "Core/inverse/face_model.hpp"
#include "Core/solve/equilibrium.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <stdexcept>

namespace f2b
{
namespace
{

using namespace testing;

constexpr double degree = 3.14159265358979323846 / 180;

/// A slab whose block of bone can be moved.
struct Block
{
  explicit Block(ElementScheme scheme = {}, double poisson_ratio = 0.49)
      : mesh(make_slab({8, 2, 80, 14, 1.5, 4, 0.5})), materials(soft_material(poisson_ratio)),
        tissue(mesh, scheme),
        model(tissue, materials, held_controls(tissue, Held::BoneAndFragments))
  {
  }
  std::vector<Vec3> moved(const Vec3& translation, const EulerAngles& angles = {}) const
  {
    return with_fragments_moved(tissue,
                                {RigidMotion{rotation_from(angles), translation, Vec3::Zero()}});
  }
  double unbalanced(const std::vector<Vec3>& x) const { return model.forces(x).norm(); }

  MixedMesh mesh;
  MaterialSet materials;
  Discretization tissue;
  ElasticModel model;
};

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  double distance = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    distance = std::max(distance, (a[i] - b[i]).norm());
  return distance;
}

const Vec3 large_move(3, -5, 4);

TEST(Equilibrium, ResidualsFallQuadratically)
{
  Block block;
  EquilibriumSolver solver(block.model, {});
  std::vector<Vec3> x = block.tissue.rest();
  const EquilibriumSummary summary = solver.move_to(x, block.moved(large_move));
  ASSERT_TRUE(summary.converged());
  const auto& r = summary.residuals_n;
  ASSERT_EQ(r.size(), summary.steps_mm.size());
  ASSERT_GE(r.size(), 3u);
  const double carried = block.model.forces(block.tissue.rest()).norm() + r.front();
  int quadratic = 0;
  for (std::size_t i = 0; i < r.size(); ++i)
  {
    std::printf("iteration %zu: residual %.3e N, step %.3e mm\n", i, r[i], summary.steps_mm[i]);
    // from where the step is small on the scale of an element, until rounding
    if (i > 0 && summary.steps_mm[i - 1] < 0.1 && r[i - 1] > 1e-6 * carried)
    {
      EXPECT_LT(r[i] / carried, 20 * std::pow(r[i - 1] / carried, 2) + 1e-12);
      ++quadratic;
    }
  }
  EXPECT_GE(quadratic, 1);
}

TEST(Equilibrium, TheWayDoesNotMatter)
{
  Block block({SkinElement::Linear, Dilatation::Averaged});
  EquilibriumSolver solver(block.model, {});
  std::vector<Vec3> at_once = block.tissue.rest();
  ASSERT_TRUE(solver.move_to(at_once, block.moved(large_move)).converged());
  std::vector<Vec3> in_turns = block.tissue.rest();
  EquilibriumSolver other(block.model, {});
  for (const Vec3& stop : {Vec3(4, 0, 0), Vec3(4, -2, 6), large_move})
    ASSERT_TRUE(other.move_to(in_turns, block.moved(stop)).converged());
  EXPECT_LT(farthest(at_once, in_turns), 1e-9);
}

TEST(Equilibrium, ResultsDoNotDependOnTheNumberOfThreads)
{
  const int threads = omp_get_max_threads();
  std::vector<std::vector<Vec3>> results;
  for (const int count : {1, 2, 3, 2})
  {
    omp_set_num_threads(count);
    Block block;
    EquilibriumSolver solver(block.model, {});
    results.push_back(block.tissue.rest());
    EXPECT_TRUE(solver.move_to(results.back(), block.moved(large_move)).converged());
  }
  omp_set_num_threads(threads);
  EXPECT_LT(farthest(results[0], results[1]), 1e-12);
  EXPECT_LT(farthest(results[0], results[2]), 1e-12);
  EXPECT_EQ(results[1], results[3]);
}

TEST(Equilibrium, ProgressIsToldAtEveryIterationAndNeverFalls)
{
  Block block;
  EquilibriumSolver solver(block.model, {});
  std::vector<double> told;
  solver.set_progress([&](double share) { told.push_back(share); });
  std::vector<Vec3> x = block.tissue.rest();
  const EquilibriumSummary summary = solver.move_to(x, block.moved(large_move));
  EXPECT_EQ(told.size(), std::size_t(summary.newton_iterations));
  EXPECT_GE(told.front(), 0);
  EXPECT_LE(told.back(), 1);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

TEST(Equilibrium, CancellingAtAnyIterationKeepsTheLastEquilibrium)
{
  Block block;
  std::vector<Vec3> start = block.tissue.rest(), expected;
  EquilibriumSolver solver(block.model, {});
  ASSERT_TRUE(solver.move_to(start, block.moved({1, 0, 0})).converged());
  expected = start;
  const int all = solver.move_to(expected, block.moved(large_move)).newton_iterations;
  for (int last = 0; last < all; ++last)
  {
    int calls = 0;
    solver.set_progress(
        [&](double)
        {
          if (calls++ == last)
            throw std::runtime_error("cancelled");
        });
    std::vector<Vec3> x = start;
    EXPECT_THROW((void)solver.move_to(x, block.moved(large_move)), std::runtime_error);
    EXPECT_EQ(x, start);
  }
  solver.set_progress({});
  std::vector<Vec3> x = start;
  ASSERT_TRUE(solver.move_to(x, block.moved(large_move)).converged());
  EXPECT_LT(farthest(x, expected), 1e-9);
}

TEST(Equilibrium, AHopelessMovementStopsSoonAtAnEquilibrium)
{
  for (const Vec3& through_its_neighbours : {Vec3(300, 0, 0), Vec3(-60, 90, 0)})
  {
    Block block;
    EquilibriumSolver solver(block.model, {});
    std::vector<Vec3> x = block.tissue.rest();
    const EquilibriumSummary summary = solver.move_to(x, block.moved(through_its_neighbours));
    std::printf("stopped at %.1f %% after %d iterations, %d factorisations, smallest det F %.4f\n",
                100 * summary.load_reached, summary.newton_iterations,
                summary.effort.factorizations, summary.smallest_dilatation);
    EXPECT_FALSE(summary.converged());
    EXPECT_GT(summary.load_reached, 0);
    EXPECT_LT(summary.load_reached, 1);
    EXPECT_GT(summary.smallest_dilatation, 0);
    EXPECT_DOUBLE_EQ(summary.smallest_dilatation, block.model.smallest_dilatation(x));
    EXPECT_LE(summary.newton_iterations, 120);
    EXPECT_LT(block.unbalanced(x), 1e-7); // crushed elements are stiff
  }
}

/// The responses of the tissue to a motion of the block, by the solver and by differences.
void expect_responses_are_derivatives(Block& block, EquilibriumSolver& solver,
                                      const std::vector<Vec3>& x, const Vec3& at)
{
  const double h = 1e-3;
  std::vector<std::vector<Vec3>> motions;
  for (int axis = 0; axis < 3; ++axis)
  {
    motions.push_back(block.moved(Vec3::Unit(axis)));
    for (std::size_t i = 0; i < motions.back().size(); ++i)
      motions.back()[i] -= block.tissue.rest()[i];
  }
  const auto responses = solver.respond(x, motions);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Vec3> plus = x, minus = x;
    ASSERT_TRUE(solver.move_to(plus, block.moved(at + h * Vec3::Unit(axis))).converged());
    ASSERT_TRUE(solver.move_to(minus, block.moved(at - h * Vec3::Unit(axis))).converged());
    double error = 0, size = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!block.model.is_prescribed(int(i)))
      {
        const Vec3 difference = (plus[i] - minus[i]) / (2 * h);
        error = std::max(error, (responses[std::size_t(axis)][i] - difference).norm());
        size = std::max(size, difference.norm());
      }
    EXPECT_LT(error, 1e-5 * size);
  }
}

TEST(Equilibrium, ResponsesAreDerivativesWithOldFactorsToo)
{
  Block block;
  EquilibriumSolver solver(block.model, {});
  std::vector<Vec3> x = block.tissue.rest();
  expect_responses_are_derivatives(block, solver, x, Vec3::Zero());
  for (const Vec3& stop : {Vec3(2, -2, 1), Vec3(2.1, -2, 1), large_move})
  {
    ASSERT_TRUE(solver.move_to(x, block.moved(stop)).converged());
    expect_responses_are_derivatives(block, solver, x, stop);
  }
}

TEST(Equilibrium, TheEffortAddsUp)
{
  Block block({}, 0.45);
  EquilibriumSolver solver(block.model, {});
  std::vector<Vec3> x = block.tissue.rest();
  EquilibriumSummary summary =
      solver.move_to(x, block.moved(large_move, {5 * degree, 2.5 * degree, 0}));
  const SolveEffort first = summary.effort;
  EXPECT_EQ(first.analyses, 1);
  EXPECT_GT(first.factorizations, 0);
  EXPECT_GE(first.back_solves, first.cg_iterations);
  EXPECT_GT(first.flop_rate(), 0);
  EXPECT_GT(first.factor_peak_bytes, 0);
  EXPECT_GE(first.rest(), 0);
  EXPECT_LT(first.rest(), first.total);
  const EquilibriumSummary second = solver.move_to(x, block.moved(large_move * 1.1));
  EXPECT_EQ(second.effort.analyses, 0);
  summary.add(second);
  EXPECT_DOUBLE_EQ(summary.effort.total, first.total + second.effort.total);
  EXPECT_EQ(summary.effort.factorizations, first.factorizations + second.effort.factorizations);
}

/// The plain element at nu = 0.49 loses definiteness on the way to this twist; the minimum is found.
TEST(Equilibrium, AnIndefiniteTangentOnTheWayIsPassed)
{
  Block block;
  (void)block.model.linearize(block.moved({0, 0, -3}));
  Cholesky factor;
  factor.analyze(block.model.stiffness());
  EXPECT_FALSE(factor.factorize(block.model.stiffness()));
  EquilibriumSolver solver(block.model, {});
  std::vector<Vec3> x = block.tissue.rest();
  const EquilibriumSummary summary =
      solver.move_to(x, block.moved({0, 0, -3}, {10 * degree, 0, 15 * degree}));
  EXPECT_TRUE(summary.converged());
  EXPECT_LT(block.unbalanced(x), 1e-8);
  (void)block.model.linearize(x);
  EXPECT_TRUE(factor.factorize(block.model.stiffness()));
}

} // namespace
} // namespace f2b
