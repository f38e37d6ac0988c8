#include "Core/solve/equilibrium.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

namespace f2b
{
namespace
{

using namespace testing;

std::vector<Vec3> shaken(std::vector<Vec3> x, double amount, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> step(-amount, amount);
  for (Vec3& p : x)
    p += Vec3(step(generator), step(generator), step(generator));
  return x;
}

std::vector<SkinSpring> test_springs(const Discretization& tissue)
{
  const SkinInterpolation skin(tissue, corner_map(tissue.mesh()));
  const std::size_t n = skin.vertices.size();
  return make_skin_springs(tissue, skin, std::vector<Vec3>(n, Vec3(1, 2, 3)),
                           std::vector<double>(n, 0.7));
}

TEST(ElasticModel, ForcesAndStiffnessAreDerivatives)
{
  const MixedMesh mesh = make_slab({2, 1, 20, 8, 1.5, 2.0, 0.5});
  const Discretization tissue(mesh);
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
  model.set_springs(test_springs(tissue), 0.05);
  const std::vector<Vec3> x = shaken(mesh.X, 0.2, 4);
  const Eigen::VectorXd forces = model.linearize(x);
  EXPECT_LT((forces - model.forces(x)).norm(), 1e-14 * forces.norm());

  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(model.unknown_count(), model.unknown_count());
  const SymmetricMatrix& sparse = model.stiffness();
  for (long c = 0; c < sparse.size; ++c)
    for (long i = sparse.column_start[std::size_t(c)]; i < sparse.column_start[std::size_t(c) + 1];
         ++i)
      K(sparse.row[std::size_t(i)], c) = K(c, sparse.row[std::size_t(i)]) =
          sparse.value[std::size_t(i)];

  const double h = 1e-5;
  for (long u = 0; u < model.unknown_count(); ++u)
  {
    std::vector<Vec3> plus = x, minus = x;
    const auto node = std::size_t(model.unknown_controls()[std::size_t(u / 3)]);
    plus[node][u % 3] += h;
    minus[node][u % 3] -= h;
    EXPECT_NEAR(forces[u], (model.energy(plus) - model.energy(minus)) / (2 * h),
                1e-7 * forces.norm());
    const Eigen::VectorXd column = (model.forces(plus) - model.forces(minus)) / (2 * h);
    EXPECT_LT((column - K.col(u)).norm(), 1e-7 * K.norm());
  }
}

TEST(ElasticModel, CouplingIsTheForceOfMovingPrescribedNodes)
{
  const MixedMesh mesh = make_slab({4, 1, 40, 8, 1.5, 0, 0.6});
  const Discretization tissue(mesh);
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneAndFragments));
  const std::vector<Vec3> x = shaken(mesh.X, 0.2, 5);
  (void)model.linearize(x);
  const std::vector<Vec3> motion = shaken(std::vector<Vec3>(x.size(), Vec3::Zero()), 1, 6);
  std::vector<Vec3> plus = x, minus = x;
  const double h = 1e-5;
  for (std::size_t n = 0; n < x.size(); ++n)
    if (model.is_prescribed(int(n)))
    {
      plus[n] += h * motion[n];
      minus[n] -= h * motion[n];
    }
  const Eigen::VectorXd difference = (model.forces(plus) - model.forces(minus)) / (2 * h);
  EXPECT_LT((model.coupling(motion) - difference).norm(), 1e-7 * difference.norm());
}

/// Moves every node on the outside by an affine map; the inside must follow it exactly.
void expect_affine_is_exact(const SlabOptions& options)
{
  const MixedMesh mesh = make_slab(options);
  const Discretization tissue(mesh);
  const MaterialSet materials = soft_material();
  std::vector<char> outside(mesh.X.size());
  const int n = options.cells + 1;
  for (std::size_t i = 0; i < outside.size(); ++i)
    outside[i] = mesh.node_boundary[i] == Boundary::Crop || i < std::size_t(n * n) ||
                 i >= mesh.X.size() - std::size_t(n * n);
  ElasticModel model(tissue, materials, outside);
  ASSERT_GT(model.unknown_count(), 0);
  Mat3 A;
  A << 1.10, 0.05, 0.02, -0.04, 0.95, 0.03, 0.01, -0.06, 1.05;
  std::vector<Vec3> target = mesh.X;
  for (Vec3& p : target)
    p = A * p + Vec3(1, -2, 3);
  std::vector<Vec3> x = mesh.X;
  EquilibriumSolver solver(model, {});
  ASSERT_TRUE(solver.move_to(x, target).converged());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    worst = std::max(worst, (x[i] - target[i]).norm());
  EXPECT_LT(worst, 1e-10);
}

TEST(PatchTest, AffineFieldIsExactOnFlatSkin)
{
  expect_affine_is_exact({4, 2, 40, 12, 1.5, 0, 0.5});
}

TEST(PatchTest, AffineFieldIsExactOnCurvedSkin)
{
  expect_affine_is_exact({4, 2, 40, 12, 1.5, 6, 0.5});
}

TEST(Equilibrium, NewtonConvergesQuadratically)
{
  const MixedMesh mesh = make_slab({});
  const Discretization tissue(mesh);
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneAndFragments));
  EquilibriumSolver solver(model, {});
  std::vector<Vec3> x = mesh.X;
  RigidMotion motion;
  motion.translation = {1, -2, 3};
  const EquilibriumSummary summary = solver.move_to(x, with_fragments_moved(tissue, {motion}));
  ASSERT_TRUE(summary.converged());
  const auto& steps = summary.steps_mm;
  ASSERT_GE(steps.size(), 4u);
  for (const double step : steps)
    std::printf("newton step %.3e mm\n", step);
  const double last = steps[steps.size() - 1], before = steps[steps.size() - 2];
  EXPECT_LT(last, 1e-8);
  EXPECT_LT(last, 10 * before * before + 1e-12);
}

TEST(Equilibrium, AHugeMovementStopsWithTheLastAcceptedState)
{
  const MixedMesh mesh = make_slab({});
  const Discretization tissue(mesh);
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneAndFragments));
  EquilibriumOptions options;
  options.smallest_load_step = 1.0 / 16;
  EquilibriumSolver solver(model, options);
  std::vector<Vec3> x = mesh.X;
  RigidMotion motion;
  motion.translation = {300, 0, 0}; // through its neighbours
  const EquilibriumSummary summary = solver.move_to(x, with_fragments_moved(tissue, {motion}));
  EXPECT_FALSE(summary.converged());
  EXPECT_LT(summary.load_reached, 1);
  EXPECT_TRUE(std::isfinite(model.energy(x)));
}

TEST(ElasticModel, ResultsDoNotDependOnTheNumberOfThreads)
{
  const MixedMesh mesh = make_slab({});
  const Discretization tissue(mesh);
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
  const std::vector<Vec3> x = shaken(mesh.X, 0.1, 7);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Eigen::VectorXd one = model.linearize(x);
  const double energy_one = model.energy(x);
  const std::vector<double> stiffness_one = model.stiffness().value;
  omp_set_num_threads(3);
  EXPECT_EQ(one, model.linearize(x));
  EXPECT_EQ(energy_one, model.energy(x));
  EXPECT_EQ(stiffness_one, model.stiffness().value);
  omp_set_num_threads(threads);
}

} // namespace
} // namespace f2b
