#include "Core/solve/equilibrium.hpp"
#include "Logic/Core/finite_differences.hpp"
#include "Logic/Core/material_samples.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <omp.h>

namespace f2b
{
namespace
{

using namespace testing;

std::vector<SkinSpring> test_springs(const Discretization& tissue)
{
  const SkinInterpolation skin(tissue, corner_map(tissue.mesh()));
  const std::size_t n = skin.vertices.size();
  return make_skin_springs(skin, std::vector<Vec3>(n, Vec3(1, 2, 3)),
                           std::vector<double>(n, 0.7));
}

/// Every kind of element with every kind of dilatation.
class EveryElement : public ::testing::TestWithParam<ElementScheme>
{
};

std::string scheme_name(const ::testing::TestParamInfo<ElementScheme>& info)
{
  return std::string(info.param.skin == SkinElement::Smooth ? "Smooth" : "Linear") +
         (info.param.dilatation == Dilatation::Averaged ? "Averaged" : "PerPoint");
}

INSTANTIATE_TEST_SUITE_P(All, EveryElement,
                         ::testing::Values(ElementScheme{SkinElement::Linear, Dilatation::PerPoint},
                                           ElementScheme{SkinElement::Linear, Dilatation::Averaged},
                                           ElementScheme{SkinElement::Smooth, Dilatation::PerPoint},
                                           ElementScheme{SkinElement::Smooth,
                                                         Dilatation::Averaged}),
                         scheme_name);

TEST_P(EveryElement, ForcesAndStiffnessAreDerivatives)
{
  const MixedMesh mesh = make_slab({2, 2, 20, 12, 1.5, 2.0, 0.5});
  const Discretization tissue(mesh, GetParam());
  for (const NamedLaw& law : every_law())
  {
    SCOPED_TRACE(law.name);
    MaterialSet materials;
    materials.laws.fill(law.law);
    ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
    expect_derivatives(model, shaken(tissue.rest(), 0.2, 4));
    model.set_springs(test_springs(tissue), {0.05});
    expect_derivatives(model, shaken(tissue.rest(), 0.2, 5));
  }
}

TEST_P(EveryElement, CouplingIsTheForceOfMovingPrescribedNodes)
{
  const MixedMesh mesh = make_slab({4, 1, 40, 8, 1.5, 0, 0.6});
  const Discretization tissue(mesh, GetParam());
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneAndFragments));
  const std::vector<Vec3> x = shaken(tissue.rest(), 0.2, 5);
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

TEST_P(EveryElement, AnInvertedElementHasInfiniteEnergy)
{
  const MixedMesh mesh = make_slab({2, 2, 20, 12, 1.5, 2.0, 0.5});
  const Discretization tissue(mesh, GetParam());
  const MaterialSet materials = soft_material();
  const ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
  std::vector<Vec3> x = tissue.rest();
  EXPECT_NEAR(model.energy(x), 0, 1e-12);
  EXPECT_NEAR(model.smallest_dilatation(x), 1, 1e-12);
  std::swap(x[std::size_t(mesh.tets[20][1])], x[std::size_t(mesh.tets[20][2])]);
  EXPECT_LT(model.smallest_dilatation(x), 0);
  EXPECT_TRUE(std::isinf(model.energy(x)));
  x = tissue.rest();
  for (const int corner : {0, 1, 2}) // the face of one prism below its foot
    x[std::size_t(mesh.prisms[3][std::size_t(corner)])].z() -= 3;
  EXPECT_LT(model.smallest_dilatation(x), 0);
  EXPECT_TRUE(std::isinf(model.energy(x)));
}

TEST_P(EveryElement, ThePositiveTangentIsPositiveAndExactAtRest)
{
  const MixedMesh mesh = make_slab({4, 2, 40, 12, 1.5, 2.0, 0.5});
  const Discretization tissue(mesh, GetParam());
  // Table 1's skin, which loses its stability beyond small strain
  MaterialSet materials;
  materials.laws.fill(
      MooneyRivlin{{skin_c10, skin_c01}, {VolumetricLaw::Kind::Barrier, bulk_from(skin_mu, 0.49)}});
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
  (void)model.linearize(tissue.rest());
  const std::vector<double> exact = model.stiffness().value;
  (void)model.linearize(tissue.rest(), Tangent::Positive);
  const auto n = Eigen::Index(exact.size());
  const Eigen::Map<const Eigen::VectorXd> at_rest(exact.data(), n);
  const Eigen::Map<const Eigen::VectorXd> positive(model.stiffness().value.data(), n);
  EXPECT_LT((positive - at_rest).norm(), 1e-9 * at_rest.norm());

  Cholesky cholesky;
  cholesky.analyze(model.stiffness());
  const Mat3 squeeze = Vec3(0.6, 1, 1.6).asDiagonal();
  const std::vector<Vec3> x =
      shaken(tissue.mapped_rest([&](const Vec3& X) { return Vec3(squeeze * X); },
                                [&](const Vec3&) { return squeeze; }),
             0.2, 8);
  ASSERT_GT(model.smallest_dilatation(x), 0);
  (void)model.linearize(x);
  EXPECT_FALSE(cholesky.factorize(model.stiffness())) << "not a state that needs it";
  (void)model.linearize(x, Tangent::Positive);
  EXPECT_TRUE(cholesky.factorize(model.stiffness()));
}

TEST_P(EveryElement, PointsFillTheMesh)
{
  const MixedMesh mesh = make_slab({3, 2, 30, 12, 1.5, 0, 0.5});
  const Discretization tissue(mesh, GetParam());
  const MaterialSet materials = soft_material();
  const ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
  Mat3 A;
  A << 1.10, 0.05, 0.02, -0.04, 0.95, 0.03, 0.01, -0.06, 1.05;
  const std::vector<Vec3> x = tissue.mapped_rest([&](const Vec3& X) { return Vec3(A * X); },
                                                 [&](const Vec3&) { return A; });
  std::array<double, tissue_count> volume{};
  double worst = 0;
  visit_points(model.groups(), tissue.rest(), x,
               [&](Tissue kind, const Mat3& F, const Vec3& place, double share)
               {
                 volume[std::size_t(kind)] += share;
                 worst = std::max(worst, (F - A).norm());
                 EXPECT_EQ(kind == Tissue::Skin, place.z() > 12);
               });
  EXPECT_LT(worst, 1e-13);
  EXPECT_NEAR(volume[0], 30 * 30 * 1.5, 1e-9);
  EXPECT_NEAR(volume[1] + volume[2], 30 * 30 * 12, 1e-9);
}

/// Moves every node on the outside by an affine map; the inside must follow it exactly.
void expect_affine_is_exact(const SlabOptions& options, ElementScheme scheme)
{
  const MixedMesh mesh = make_slab(options);
  const Discretization tissue(mesh, scheme);
  const MaterialSet materials = soft_material();
  std::vector<char> outside(mesh.X.size());
  const int n = options.cells + 1;
  for (std::size_t i = 0; i < outside.size(); ++i)
    outside[i] = mesh.node_boundary[i] == Boundary::Crop || i < std::size_t(n * n) ||
                 i >= mesh.X.size() - std::size_t(n * n);
  ElasticModel model(tissue, materials, tissue.control_flags(outside));
  ASSERT_GT(model.unknown_count(), 0);
  Mat3 A;
  A << 1.10, 0.05, 0.02, -0.04, 0.95, 0.03, 0.01, -0.06, 1.05;
  const std::vector<Vec3> target = tissue.mapped_rest(
      [&](const Vec3& X) { return Vec3(A * X + Vec3(1, -2, 3)); }, [&](const Vec3&) { return A; });
  std::vector<Vec3> x = tissue.rest();
  EquilibriumSolver solver(model, {});
  ASSERT_TRUE(solver.move_to(x, target).converged());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    worst = std::max(worst, (x[i] - target[i]).norm());
  EXPECT_LT(worst, 1e-10);
  double strain = 0; // one F everywhere is one stress per tissue
  visit_points(model.groups(), tissue.rest(), x,
               [&](Tissue, const Mat3& F, const Vec3&, double)
               { strain = std::max(strain, (F - A).norm()); });
  EXPECT_LT(strain, 1e-10);
}

TEST_P(EveryElement, AffineFieldIsExactOnFlatSkin)
{
  expect_affine_is_exact({4, 2, 40, 12, 1.5, 0, 0.5}, GetParam());
}

TEST_P(EveryElement, AffineFieldIsExactOnCurvedSkin)
{
  expect_affine_is_exact({4, 2, 40, 12, 1.5, 6, 0.5}, GetParam());
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
  // what is left is below the tolerance of 1e-8 mm
  EXPECT_LT(model.forces(x).norm(), 1e-7 * summary.residuals_n.front());
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

TEST_P(EveryElement, ResultsDoNotDependOnTheNumberOfThreads)
{
  const MixedMesh mesh = make_slab({});
  const Discretization tissue(mesh, GetParam());
  const MaterialSet materials = soft_material();
  ElasticModel model(tissue, materials, held_controls(tissue, Held::BoneOnly));
  const std::vector<Vec3> x = shaken(tissue.rest(), 0.1, 7);
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
