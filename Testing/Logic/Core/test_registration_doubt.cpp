#include "Core/inverse/plan_uncertainty.hpp"
#include "Core/inverse/skin_sensitivity.hpp"
#include "Logic/Core/slab_face.hpp"

namespace f2b
{
namespace
{

using namespace testing;

/// A target that its registration shifted by this.
SkinTarget shifted(SkinTarget target, const Vec3& shift)
{
  for (Vec3& d : target.displacement)
    d += shift;
  target.registration_sd_mm = 5; // weak beside this small skin
  return target;
}

TEST(RegistrationDoubt, AShiftOfTheWholeTargetIsToldFromTheBonesMovement)
{
  const Slab slab;
  const Vec3 shift(0.3, -0.2, 0.25);
  const SkinTarget target = slab.target_of(table_2_motion());
  const SkinTarget doubted = shifted(target, shift);
  SkinTarget believed = doubted;
  believed.registration_sd_mm = 0;
  const RigidFitResult wise = fit_fragments(slab.face, doubted, {}, no_progress);
  const RigidFitResult trusting = fit_fragments(slab.face, believed, {}, no_progress);
  auto off = [](const RigidFitResult& plan)
  { return (plan.motions[0].translation - table_2_motion().translation).norm(); };
  std::printf("off by %.4f mm, %.4f mm where the target is believed\n", off(wise), off(trusting));
  EXPECT_EQ(wise.termination, RigidFitTermination::Converged);
  EXPECT_LT(off(wise), 0.3 * off(trusting));
  // face = target + registration: the target lies too far by the shift
  EXPECT_LT((wise.target_registration.head<3>() + shift).norm(), 0.15);
  EXPECT_EQ(trusting.target_registration.norm(), 0);
}

TEST(RegistrationDoubt, ATargetInPlaceIsPlannedAsBefore)
{
  const Slab slab;
  const SkinTarget target = shifted(slab.target_of(table_2_motion()), Vec3::Zero());
  const RigidFitResult plan = fit_fragments(slab.face, target, {}, no_progress);
  EXPECT_LT((plan.motions[0].translation - table_2_motion().translation).norm(), 1e-5);
  EXPECT_LT(plan.target_registration.norm(), 1e-6);
}

TEST(RegistrationDoubt, TheGradientIsThatOfTheReducedObjective)
{
  const Slab slab;
  const SkinTarget target = shifted(slab.target_of(table_2_motion()), {0.4, 0.1, -0.3});
  const SkinResidual residual = skin_residual(slab.face, target, RigidFitOptions{}.wish_weight());
  std::vector<Vec3> u(target.displacement.size()), way(u.size());
  for (std::size_t v = 0; v < u.size(); ++v)
  {
    u[v] = 0.7 * target.displacement[v];
    way[v] = Vec3(std::sin(double(v)), std::cos(2.0 * double(v)), 1);
  }
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  residual.normal_equations(u, {way}, H, g);
  auto objective = [&](double share)
  {
    std::vector<Vec3> at = u;
    for (std::size_t v = 0; v < at.size(); ++v)
      at[v] += share * way[v];
    return residual.objective(at);
  };
  const double h = 1e-3; // the objective is a quadratic
  EXPECT_NEAR(g[0] / ((objective(h) - objective(-h)) / (2 * h)), 1, 1e-8);
  EXPECT_NEAR(H(0, 0) / ((objective(h) - 2 * objective(0) + objective(-h)) / (h * h)), 1, 1e-4);
}

TEST(RegistrationDoubt, LeavesLittleOfItInTheIntervals)
{
  const Slab slab;
  SkinTarget target = slab.target_of(table_2_motion());
  const RigidFitResult plan = fit_fragments(slab.face, target, {}, no_progress);
  const auto believed = plan_uncertainty(slab.face, target, {}, plan, slab.positions(), {});
  target.registration_sd_mm = 5; // weak beside this small skin
  const auto doubted = plan_uncertainty(slab.face, target, {}, plan, slab.positions(), {});
  for (std::size_t k = 3; k < 6; ++k)
    EXPECT_LT(doubted[k].registration, 0.3 * believed[k].registration);
}

} // namespace
} // namespace f2b
