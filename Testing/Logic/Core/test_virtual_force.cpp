#include "Core/inverse/virtual_force.hpp"
#include "Logic/Core/finite_differences.hpp"
#include "Logic/Core/slab_face.hpp"
#include "expect_error.hpp"

#include <Eigen/Eigenvalues>

#include <omp.h>

namespace f2b
{
namespace
{

using namespace testing;
using test::expect_error;

const VirtualForceLaw every_law_of_eq_8[] = {{0.05, 0, VirtualLoad::Following},
                                             {0.05, 3, VirtualLoad::Following},
                                             {0.05, 0, VirtualLoad::Dead},
                                             {0.05, 3, VirtualLoad::Dead}};

std::string text_of(const VirtualForceLaw& law)
{
  return (law.load == VirtualLoad::Dead ? "dead, L0 = " : "following, L0 = ") +
         std::to_string(law.rest_length_mm);
}

TEST(VirtualForceLaw, IsEquation8TowardsTheTarget)
{
  const Vec3 target(3, 0, 4), u(0, 0, 0);
  for (const VirtualForceLaw& law : every_law_of_eq_8)
    EXPECT_LT((-pull_gradient(law, target, u) - 0.05 * (5 - law.rest_length_mm) * Vec3(0.6, 0, 0.8))
                  .norm(),
              1e-15)
        << text_of(law);
  // nearer than the rest length the skin is pushed away
  EXPECT_GT(pull_gradient({0.05, 6}, target, u).dot(target), 0);
  // following: from where the skin is; dead: from where it was
  const Vec3 moved(3, 0, 2);
  EXPECT_LT((-pull_gradient({0.05}, target, moved) - Vec3(0, 0, 0.1)).norm(), 1e-15);
  EXPECT_EQ(pull_gradient({0.05, 1, VirtualLoad::Dead}, target, moved),
            pull_gradient({0.05, 1, VirtualLoad::Dead}, target, u));
}

TEST(VirtualForceLaw, IsZeroWhereThereIsNoDirection)
{
  const Vec3 target(1, 2, 3);
  for (const double distance : {0.0, 1e-12, 9e-10})
    for (const double rest_length : {0.0, 2.0})
    {
      const VirtualForceLaw law{0.05, rest_length};
      const Vec3 u = target + Vec3(distance, 0, 0);
      EXPECT_LT(pull_gradient(law, target, u).norm(), 1e-10);
      EXPECT_TRUE(pull_hessian(law, target, u, Tangent::Exact).allFinite());
      EXPECT_NEAR(pull_energy(law, target, u), 0.5 * 0.05 * rest_length * rest_length, 1e-9);
      EXPECT_LT(pull_gradient({0.05, rest_length, VirtualLoad::Dead}, target - u, {}).norm(),
                1e-10);
    }
}

TEST(VirtualForceLaw, GradientAndHessianAreDerivatives)
{
  const double h = 1e-5;
  for (const VirtualForceLaw& law : every_law_of_eq_8)
    for (const Vec3& u : {Vec3(0.3, -0.2, 0.1), Vec3(3, 1.5, 4), Vec3(-20, 3, 1), Vec3(2, 1, 6.9)})
    {
      SCOPED_TRACE(text_of(law));
      const Vec3 target(2, 1, 4);
      const Vec3 g = pull_gradient(law, target, u);
      const Mat3 H = pull_hessian(law, target, u, Tangent::Exact);
      for (int c = 0; c < 3; ++c)
      {
        const Vec3 plus = u + h * Vec3::Unit(c), minus = u - h * Vec3::Unit(c);
        EXPECT_NEAR(g[c],
                    (pull_energy(law, target, plus) - pull_energy(law, target, minus)) / (2 * h),
                    1e-9);
        const Vec3 column =
            (pull_gradient(law, target, plus) - pull_gradient(law, target, minus)) / (2 * h);
        EXPECT_LT((H.col(c) - column).norm(), 1e-8);
      }
      const Mat3 positive = pull_hessian(law, target, u, Tangent::Positive);
      EXPECT_GE(Eigen::SelfAdjointEigenSolver<Mat3>(positive).eigenvalues()[0], -1e-15);
    }
}

/// The face is displaced at rest by what is neither zero nor the rest length.
std::vector<SkinSpring> uneven_springs(const Slab& slab)
{
  const std::size_t n = slab.skin.vertices.size();
  std::vector<double> area(n);
  for (std::size_t v = 0; v < n; ++v)
    area[v] = 0.2 + double(v % 5);
  return make_skin_springs(slab.skin, shaken(std::vector<Vec3>(n, Vec3(1, 2, 3)), 2, 9), area);
}

TEST(SkinSprings, ForcesAndStiffnessOfTheModelAreDerivatives)
{
  for (const ElementScheme& scheme : {ElementScheme{}, mixed_elements})
    for (const VirtualForceLaw& law : every_law_of_eq_8)
    {
      SCOPED_TRACE(text_of(law));
      const Slab slab({2, 1, 20, 8, 1.5, 2.0, 0.5}, scheme);
      ElasticModel model(slab.tissue, slab.materials, held_controls(slab.tissue, Held::BoneOnly));
      model.set_springs(uneven_springs(slab), law);
      expect_derivatives(model, shaken(slab.tissue.rest(), 0.2, 5));
    }
}

TEST(SkinSprings, NodalForcesDoTheWorkOfTheTraction)
{
  // eq. 9: sum_a F_a . dq_a = integral of f_e . du, for any variation dq, slopes included
  const Slab slab({3, 1, 30, 8, 1.5, 2.0, 0.5}, mixed_elements);
  const auto rest = slab.tissue.rest();
  const auto x = shaken(rest, 0.2, 5);
  const auto dq = shaken(std::vector<Vec3>(rest.size(), Vec3::Zero()), 1, 6);
  const std::vector<Vec3> u = slab.skin.displacement(x), du = slab.skin.of_change(dq);
  const Vec3 target(1, 2, 6);
  const auto springs = make_skin_springs(slab.skin, std::vector<Vec3>(u.size(), target),
                                         std::vector<double>(u.size(), 0.7));
  ASSERT_EQ(springs.size(), slab.mesh.prisms.size());
  for (const VirtualForceLaw& law : every_law_of_eq_8)
  {
    double expected = 0, work = 0;
    for (std::size_t v = 0; v < u.size(); ++v)
      expected += 0.7 * pull_gradient(law, target, u[v]).dot(du[v]);
    for (const SkinSpring& spring : springs)
    {
      const SkinWeights place = slab.tissue.skin_weights({spring.prism, Vec3(1, 0, 0)});
      SkinSpring::Controls now = SkinSpring::Controls::Zero(), change = now;
      for (int i = 0; i < place.count; ++i)
      {
        const auto control = std::size_t(place.control[std::size_t(i)]);
        now.col(i) = x[control] - rest[control];
        change.col(i) = dq[control];
      }
      work += spring.gradient(law, now).cwiseProduct(change).sum();
    }
    EXPECT_NEAR(work, expected, 1e-12 * std::abs(expected)) << text_of(law);
  }
}

VirtualForceOptions with_stiffness(double K)
{
  VirtualForceOptions options;
  options.stiffness_n_per_mm3 = K;
  return options;
}

VirtualForceResult drag(const Slab& slab, const SkinTarget& target,
                        const VirtualForceOptions& options = {})
{
  return drag_skin(slab.face, target, options, no_progress);
}

TEST(VirtualForce, IsBiasedTowardsTooLittleMovementAsTheDesignSays)
{
  const Slab slab;
  const RigidMotion truth = table_2_motion();
  const VirtualForceResult dragged = drag(slab, slab.target_of(truth), with_stiffness(0.02));
  EXPECT_DOUBLE_EQ(dragged.equilibrium.load_reached, 1);
  EXPECT_EQ(dragged.choice, StiffnessChoice::Given);
  const Vec3 found = dragged.motions[0].translation;
  std::printf("virtual-force finds (%.2f %.2f %.2f) for (2 -5 3)\n", found.x(), found.y(),
              found.z());
  EXPECT_GT(found.dot(truth.translation), 0); // eq. 8 with its direction turned round
  EXPECT_LT(found.norm(), truth.translation.norm());
  EXPECT_GT(dragged.registrations.at(0).surface.rms_mm, 0.05); // the tissue shears
  EXPECT_TRUE(dragged.warnings(with_stiffness(0.02)).empty());
}

TEST(VirtualForce, ChoosesTheStiffnessThatLeavesTheStatedResidual)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  double softer = 0;
  for (const double residual : {0.5, 0.2})
  {
    VirtualForceOptions options;
    options.residual_mm = residual;
    const VirtualForceResult chosen = drag(slab, target, options);
    std::printf("%.1f mm: K_e = %.4f N/mm3 leaves %.4f mm after %d solves, %d Newton iterations\n",
                residual, chosen.stiffness_n_per_mm3, chosen.residual_mm, chosen.solves,
                chosen.equilibrium.newton_iterations);
    EXPECT_EQ(chosen.choice, StiffnessChoice::Met);
    EXPECT_LE(chosen.residual_mm, residual);
    EXPECT_GE(chosen.residual_mm, 0.9 * residual);
    EXPECT_LE(chosen.solves, 10);
    EXPECT_TRUE(chosen.equilibrium.converged());
    EXPECT_GT(chosen.stiffness_n_per_mm3, softer);
    softer = chosen.stiffness_n_per_mm3;
    // the way there leaves no trace
    const VirtualForceResult given = drag(slab, target, with_stiffness(softer));
    EXPECT_NEAR(given.residual_mm, chosen.residual_mm, 1e-7);
    EXPECT_LT((given.motions[0].translation - chosen.motions[0].translation).norm(), 1e-6);
  }
}

TEST(VirtualForce, DeadAndFollowingAgreeForAWeakPullOnly)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  auto moved_by = [&](double K, VirtualLoad load)
  {
    VirtualForceOptions options = with_stiffness(K);
    options.load = load;
    return drag(slab, target, options).motions[0].translation.norm();
  };
  const double weak = moved_by(1e-6, VirtualLoad::Following);
  EXPECT_GT(weak, 0);
  EXPECT_NEAR(moved_by(1e-6, VirtualLoad::Dead), weak, 0.02 * weak);
  EXPECT_GT(moved_by(1e-3, VirtualLoad::Dead), 1.05 * moved_by(1e-3, VirtualLoad::Following));
}

TEST(VirtualForce, ADeadLoadIsChosenToItsResidualOrSaysHowNearItComes)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  VirtualForceOptions options;
  options.load = VirtualLoad::Dead;
  for (const double residual : {0.9, 0.05})
  {
    options.residual_mm = residual;
    const VirtualForceResult chosen = drag(slab, target, options);
    std::printf("dead, %.2f mm: K_e = %.5f N/mm3 leaves %.3f of %.3f mm after %d solves\n",
                residual, chosen.stiffness_n_per_mm3, chosen.residual_mm,
                chosen.residual_at_rest_mm, chosen.solves);
    EXPECT_LT(chosen.residual_mm, chosen.residual_at_rest_mm);
    EXPECT_EQ(chosen.choice == StiffnessChoice::Met, chosen.residual_mm <= residual);
    EXPECT_EQ(chosen.warnings(options).size(), chosen.choice == StiffnessChoice::Met ? 0u : 1u);
  }
}

TEST(VirtualForce, ARestLengthKeepsTheSkinOffItsTarget)
{
  const Slab slab;
  SkinTarget target = slab.uniform_target({0, 0, 4});
  for (std::size_t v = 0; v < target.weight.size(); ++v)
  {
    const auto& place = slab.skin.vertices[v];
    const Vec3 X = slab.mesh.X[std::size_t(place.control[v % 3])];
    target.weight[v] = std::max(std::abs(X.x()), std::abs(X.y())) < 15;
  }
  VirtualForceOptions options = with_stiffness(1);
  EXPECT_LT(drag(slab, target, options).residual_mm, 0.3);
  options.rest_length_mm = 1.5;
  const VirtualForceResult kept_off = drag(slab, target, options);
  EXPECT_DOUBLE_EQ(kept_off.equilibrium.load_reached, 1);
  EXPECT_NEAR(kept_off.residual_mm, 1.5, 0.3);
}

TEST(VirtualForce, TheRestFaceAsTargetGivesNoMovement)
{
  const Slab slab;
  for (const VirtualLoad load : {VirtualLoad::Following, VirtualLoad::Dead})
    for (const double rest_length : {0.0, 2.0})
      for (const bool given : {false, true})
      {
        VirtualForceOptions options;
        if (given)
          options.stiffness_n_per_mm3 = 0.02;
        options.load = load;
        options.rest_length_mm = rest_length;
        options.residual_mm = 3;
        const VirtualForceResult still = drag(slab, slab.uniform_target(Vec3::Zero()), options);
        EXPECT_LT(still.motions[0].translation.norm(), 1e-12);
        EXPECT_LT((still.motions[0].rotation - Mat3::Identity()).norm(), 1e-12);
        EXPECT_LT(still.residual_mm, 1e-12);
        EXPECT_TRUE(still.warnings(options).empty());
        EXPECT_EQ(still.choice, given ? StiffnessChoice::Given : StiffnessChoice::NoneNeeded);
      }
}

TEST(VirtualForce, ATargetWithinTheResidualIsSaidToNeedNoForce)
{
  const Slab slab;
  const VirtualForceResult still = drag(slab, slab.uniform_target({0.1, 0.2, 0.2}));
  EXPECT_EQ(still.choice, StiffnessChoice::NoneNeeded);
  EXPECT_NEAR(still.residual_at_rest_mm, 0.3, 1e-12);
  ASSERT_EQ(still.warnings({}).size(), 1u);
  EXPECT_NE(still.warnings({})[0].find("0.3 mm"), std::string::npos) << still.warnings({})[0];
}

TEST(VirtualForce, ATargetFarAwayIsRefusedOrSaidToBeUnreached)
{
  const Slab slab;
  const SkinTarget target = slab.uniform_target({0, 60, 80});
  for (const VirtualForceOptions& options : {VirtualForceOptions{}, with_stiffness(0.02)})
    try
    {
      const VirtualForceResult found = drag(slab, target, options);
      std::printf("100 mm: K_e = %.4g leaves %.1f mm after %d solves\n", found.stiffness_n_per_mm3,
                  found.residual_mm, found.solves);
      EXPECT_TRUE(std::isfinite(found.motions[0].translation.norm()));
      EXPECT_GT(found.residual_mm, 10);
      EXPECT_EQ(found.choice,
                options.stiffness_n_per_mm3 ? StiffnessChoice::Given : StiffnessChoice::NotMet);
      ASSERT_EQ(found.warnings(options).size(), 1u);
      std::printf("%s\n", found.warnings(options)[0].c_str());
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.kind(), ErrorKind::Numerical);
      EXPECT_NE(std::string(error.what()).find("100 mm away"), std::string::npos) << error.what();
    }
}

TEST(VirtualForce, SaysWhatItCannotWorkWith)
{
  const Slab slab;
  expect_error(
      [&] {
        drag(slab, slab.uniform_target({0, 0, 5}, 0));
      },
      {"target: no weighted part of it lies on the meshed face"});
  expect_error(
      [&] {
        drag(slab, slab.uniform_target({0, 0, 5}), with_stiffness(0));
      },
      {"virtual-force: stiffness: it is 0"});
  VirtualForceOptions options;
  options.residual_mm = -1;
  expect_error(
      [&] {
        drag(slab, slab.uniform_target({0, 0, 5}), options);
      },
      {"virtual-force: residual: it is -1"});
  options.residual_mm = 0.5;
  options.rest_length_mm = 0.5;
  expect_error(
      [&] {
        drag(slab, slab.uniform_target({0, 0, 5}), options);
      },
      {"virtual-force: residual: it is 0.5", "more than the rest length"});
  MixedMesh bare = slab.mesh;
  for (auto& boundary : bare.node_boundary)
    boundary = boundary == Boundary::Fragment ? Boundary::Free : boundary;
  const Slab loose(bare);
  expect_error(
      [&] {
        drag(loose, loose.uniform_target({0, 0, 5}));
      },
      {"'block'", "three soft-tissue contact nodes"});
}

MixedMesh two_blocks(bool swapped)
{
  MixedMesh mesh = make_slab({12, 2, 80, 12, 1.5, 0, 0.6});
  mesh.fragments = swapped ? std::vector<std::string>{"right", "left"}
                           : std::vector<std::string>{"left", "right"};
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment)
    {
      if (std::abs(mesh.X[n].x()) < 7) // released between them
        mesh.node_boundary[n] = Boundary::Free;
      mesh.node_fragment[n] =
          mesh.node_boundary[n] == Boundary::Free ? -1 : int((mesh.X[n].x() > 0) != swapped);
    }
  return mesh;
}

TEST(VirtualForce, TellsTwoFragmentsApartWhateverTheirOrder)
{
  const Slab slab(two_blocks(false)), swapped(two_blocks(true));
  RigidMotion left, right;
  left.translation = {0, 3, 1};
  right.translation = {0, -3, 1};
  const SkinTarget target = slab.target_of({left, right});
  VirtualForceOptions options;
  options.residual_mm = 0.2;
  const VirtualForceResult found = drag(slab, target, options);
  const VirtualForceResult other = drag(swapped, target, options);
  EXPECT_GT(found.motions.at(0).translation.y(), 0.1);
  EXPECT_LT(found.motions.at(1).translation.y(), -0.1);
  EXPECT_LT((found.motions[0].translation - other.motions.at(1).translation).norm(), 1e-6);
  EXPECT_LT((found.motions[1].translation - other.motions.at(0).translation).norm(), 1e-6);
}

TEST(VirtualForce, LandmarksChangeTheRegistrationAndNotTheTissue)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  VirtualForceOptions options = with_stiffness(0.02);
  const VirtualForceResult by_surface = drag(slab, target, options);
  options.landmarks = {{"a", {-10, -10, 0}}, {"b", {10, -10, 0}}, {"c", {0, 10, 0}}};
  const VirtualForceResult by_landmarks = drag(slab, target, options);
  EXPECT_EQ(by_surface.x, by_landmarks.x);
  EXPECT_EQ(by_surface.motions[0].translation,
            by_landmarks.registrations[0].surface.motion.translation);
  EXPECT_EQ(by_landmarks.motions[0].translation,
            by_landmarks.registrations[0].landmarks->motion.translation);
  // the middle of Gamma_n is dragged farther than its rim
  EXPECT_GT((by_landmarks.motions[0].translation - by_surface.motions[0].translation).norm(), 0.01);
}

TEST(VirtualForce, IsTheSameForAnyNumberOfThreads)
{
  const Slab slab({6, 1, 60, 10, 1.5, 2, 0.7}, mixed_elements);
  const SkinTarget target = slab.uniform_target({1, 0, 3});
  const int threads = omp_get_max_threads();
  std::vector<VirtualForceResult> results;
  for (const int count : {1, 3})
  {
    omp_set_num_threads(count);
    VirtualForceOptions options;
    options.residual_mm = 1;
    options.rest_length_mm = 0.5;
    results.push_back(drag(slab, target, options));
  }
  omp_set_num_threads(threads);
  EXPECT_EQ(results[0].stiffness_n_per_mm3, results[1].stiffness_n_per_mm3);
  EXPECT_EQ(results[0].motions[0].translation, results[1].motions[0].translation);
}

} // namespace
} // namespace f2b
