#include "Core/mesh/skin_crease.hpp"
#include "Core/solve/equilibrium.hpp"
#include "Logic/Core/ball_mesh.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

/// The smooth face in the solver: patch tests, derivatives, convergence of Newton's method.
namespace f2b
{
namespace
{

using namespace testing;

constexpr ElementScheme every_smooth_scheme[] = {{SkinElement::Smooth, Dilatation::PerPoint},
                                                 {SkinElement::Smooth, Dilatation::Averaged}};

const char* name(const ElementScheme& scheme)
{
  return scheme.dilatation == Dilatation::Averaged ? "averaged dilatation" : "plain";
}

/// Face, slopes and what else is outside move affinely; the inside must follow.
void expect_affine_is_exact(const char* what, const MixedMesh& mesh,
                            const std::vector<char>& outside)
{
  const MaterialSet materials = soft_material();
  Mat3 A;
  A << 1.10, 0.05, 0.02, -0.04, 0.95, 0.03, 0.01, -0.06, 1.05;
  for (const ElementScheme& scheme : every_smooth_scheme)
  {
    const Discretization tissue(mesh, scheme);
    ElasticModel model(tissue, materials, tissue.control_flags(outside));
    ASSERT_GT(model.unknown_count(), 0);
    const std::vector<Vec3> exact = tissue.mapped_rest([&](const Vec3& X) { return Vec3(A * X); },
                                                       [&](const Vec3&) { return A; });
    std::vector<Vec3> x = tissue.rest();
    EquilibriumSolver solver(model, {});
    ASSERT_TRUE(solver.move_to(x, exact).converged());
    double worst = 0, stress = 0;
    for (std::size_t c = 0; c < x.size(); ++c)
      worst = std::max(worst, (x[c] - exact[c]).norm());
    const auto& law = std::get<Yeoh>(materials.of(Tissue::Skin));
    const Mat3 P = law.stress(A);
    visit_points(model.groups(), tissue.rest(), x,
                 [&](Tissue, const Mat3& F, const Vec3&, double)
                 { stress = std::max(stress, (law.stress(F) - P).norm() / P.norm()); });
    std::printf("%s, %s, %ld unknowns: displacement %.1e mm, stress %.1e\n", what, name(scheme),
                model.unknown_count(), worst, stress);
    EXPECT_LT(worst, 1e-10);
    EXPECT_LT(stress, 1e-10);
  }
}

TEST(PatchTest, SmoothFaceOnASphere)
{
  const MixedMesh mesh = make_ball(2, 12, 1.5);
  std::vector<char> outside(mesh.X.size());
  for (std::size_t n = 0; n < outside.size(); ++n)
    outside[n] = mesh.node_boundary[n] == Boundary::Skin;
  expect_affine_is_exact("sphere", mesh, outside);
}

TEST(PatchTest, SmoothFaceOnFlatAndDomedSlabs)
{
  for (const double dome : {0.0, 6.0})
  {
    const MixedMesh mesh = make_slab({4, 2, 40, 12, 1.5, dome, 0.5});
    std::vector<char> outside(mesh.X.size());
    for (std::size_t n = 0; n < outside.size(); ++n)
      outside[n] = mesh.node_boundary[n] == Boundary::Crop || n < 25 || n >= mesh.X.size() - 25;
    expect_affine_is_exact(dome > 0 ? "dome" : "flat slab", mesh, outside);
  }
}

std::vector<Vec3> shaken(std::vector<Vec3> x, double amount, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> step(-amount, amount);
  for (Vec3& p : x)
    p += Vec3(step(generator), step(generator), step(generator));
  return x;
}

TEST(SmoothModel, ForcesAndStiffnessAreDerivativesWithSprings)
{
  const MixedMesh mesh = make_slab({2, 1, 20, 8, 1.5, 2.0, 0.5});
  const MaterialSet materials = soft_material();
  for (const ElementScheme& scheme : every_smooth_scheme)
  {
    const Discretization tissue(mesh, scheme);
    std::vector<char> held(mesh.X.size());
    for (std::size_t n = 0; n < held.size(); ++n)
      held[n] = mesh.node_boundary[n] == Boundary::FixedBone;
    ElasticModel model(tissue, materials, tissue.control_flags(held));
    SkinMap map;
    for (std::size_t p = 0; p < mesh.prisms.size(); ++p)
      map.places.push_back({int(p), Vec3(0.2, 0.5, 0.3)});
    const SkinInterpolation skin(tissue, map);
    model.set_springs(make_skin_springs(skin,
                                        std::vector<Vec3>(map.places.size(), Vec3(1, 2, 3)),
                                        std::vector<double>(map.places.size(), 20)),
                      {0.05});
    const std::vector<Vec3> x = shaken(tissue.rest(), 0.2, 4);
    const Eigen::VectorXd forces = model.linearize(x);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(model.unknown_count(), model.unknown_count());
    const SymmetricMatrix& sparse = model.stiffness();
    for (long c = 0; c < sparse.size; ++c)
      for (long i = sparse.column_start[std::size_t(c)];
           i < sparse.column_start[std::size_t(c) + 1]; ++i)
        K(sparse.row[std::size_t(i)], c) = K(c, sparse.row[std::size_t(i)]) =
            sparse.value[std::size_t(i)];
    const double h = 1e-5;
    double force_error = 0, stiffness_error = 0;
    for (long u = 0; u < model.unknown_count(); ++u)
    {
      std::vector<Vec3> plus = x, minus = x;
      const auto control = std::size_t(model.unknown_controls()[std::size_t(u / 3)]);
      plus[control][u % 3] += h;
      minus[control][u % 3] -= h;
      force_error = std::max(
          force_error, std::abs(forces[u] - (model.energy(plus) - model.energy(minus)) / (2 * h)));
      const Eigen::VectorXd column = (model.forces(plus) - model.forces(minus)) / (2 * h);
      stiffness_error = std::max(stiffness_error, (column - K.col(u)).norm());
    }
    std::printf("%s: force %.1e, stiffness %.1e against central differences\n", name(scheme),
                force_error / forces.norm(), stiffness_error / K.norm());
    EXPECT_LT(force_error, 1e-7 * forces.norm());
    EXPECT_LT(stiffness_error, 1e-7 * K.norm());
  }
}

/// A slab whose fragment moves: the same movement with the linear and the smooth face.
TEST(SmoothModel, NewtonConvergesAndTheFaceStaysSmooth)
{
  const MixedMesh mesh = make_slab({10, 2, 60, 12, 1.5, 6, 0.5});
  const MaterialSet materials = soft_material();
  std::vector<char> held(mesh.X.size());
  for (std::size_t n = 0; n < held.size(); ++n)
    held[n] = mesh.node_boundary[n] == Boundary::FixedBone ||
              mesh.node_boundary[n] == Boundary::Crop ||
              mesh.node_boundary[n] == Boundary::Fragment;
  for (const ElementScheme& scheme : every_smooth_scheme)
  {
    const Discretization tissue(mesh, scheme);
    ElasticModel model(tissue, materials, tissue.control_flags(held));
    std::vector<Vec3> target = tissue.rest();
    for (std::size_t n = 0; n < mesh.X.size(); ++n)
      if (mesh.node_boundary[n] == Boundary::Fragment)
        target[n] += Vec3(1, -2, 4);
    std::vector<Vec3> x = tissue.rest();
    EquilibriumSolver solver(model, {});
    const EquilibriumSummary summary = solver.move_to(x, target);
    ASSERT_TRUE(summary.converged());
    const SkinCrease facets = linear_skin_crease(mesh, x);
    const SkinCrease smooth = smooth_skin_crease(*tissue.smooth_skin(), x);
    std::printf("%s: %zu Newton steps, last %.1e mm; mean crease of the moved face %.3f deg as "
                "facets, %.4f smooth (max %.2f, %.3f)\n",
                name(scheme), summary.steps_mm.size(), summary.steps_mm.back(), facets.mean_deg,
                smooth.mean_deg, facets.max_deg, smooth.max_deg);
    EXPECT_LT(smooth.mean_deg, 0.1 * facets.mean_deg);
  }
}

} // namespace
} // namespace f2b
