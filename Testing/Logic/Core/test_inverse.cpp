#include "Core/error.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Logic/Core/slab_face.hpp"

#include <random>

namespace f2b
{
namespace
{

using namespace testing;

TEST(RigidFit, RecoversAMovementFromTheFaceItGives)
{
  const Slab slab;
  const RigidMotion truth = table_2_motion();
  const RigidFitResult fit = fit_fragments(slab.face, slab.target_of(truth), {}, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  EXPECT_LT((fit.motions[0].translation - truth.translation).norm(), 1e-5);
  EXPECT_LT(angle_between(fit.motions[0].rotation, truth.rotation), 1e-6);
  for (std::size_t i = 1; i < fit.iterations.size(); ++i)
    EXPECT_LE(fit.iterations[i].objective, fit.iterations[i - 1].objective);
}

TEST(RigidFit, IsCloseUnderSkinNoise)
{
  const Slab slab;
  const RigidMotion truth = table_2_motion();
  SkinTarget target = slab.target_of(truth);
  std::mt19937 generator(8);
  std::normal_distribution<double> noise(0, 0.5);
  for (Vec3& d : target.displacement)
    d += Vec3(noise(generator), noise(generator), noise(generator));
  const RigidFitResult fit = fit_fragments(slab.face, target, {}, no_progress);
  const double error = (fit.motions[0].translation - truth.translation).norm();
  std::printf("translation error under 0.5 mm noise: %.3f mm\n", error);
  EXPECT_LT(error, 0.2);
}

TEST(RigidFit, TheRestFaceAsTargetGivesNoMovement)
{
  const Slab slab;
  const std::size_t n = slab.skin.vertices.size();
  const RigidFitResult fit = fit_fragments(
      slab.face, {std::vector<Vec3>(n, Vec3::Zero()), std::vector<double>(n, 1.0), {}}, {},
      no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  EXPECT_LT(fit.motions[0].translation.norm(), 1e-9);
}

TEST(RigidFit, AMaskWithoutSkinIsRefused)
{
  const Slab slab;
  const std::size_t n = slab.skin.vertices.size();
  EXPECT_THROW(fit_fragments(slab.face,
                             {std::vector<Vec3>(n, Vec3(0, 0, 1)), std::vector<double>(n, 0.0), {}},
                             {}, no_progress),
               Error);
}

TEST(RigidMotion, EulerAnglesRoundTripAndMatrixAgreesWithApply)
{
  const EulerAngles angles{0.1, -0.2, 0.3};
  const EulerAngles back = euler_angles(rotation_from(angles));
  EXPECT_NEAR(back.pitch, angles.pitch, 1e-14);
  EXPECT_NEAR(back.roll, angles.roll, 1e-14);
  EXPECT_NEAR(back.yaw, angles.yaw, 1e-14);
  RigidMotion m{rotation_from(angles), {1, 2, 3}, {4, 5, 6}};
  const Vec3 p(7, -8, 9);
  EXPECT_LT(((m.matrix() * p.homogeneous()).head<3>() - m.apply(p)).norm(), 1e-13);
}

TEST(RigidMotion, RegistrationFindsTheMotionAndNeverAMirror)
{
  const RigidMotion truth{rotation_from({0.4, 0.1, -0.3}), {3, -1, 2}, {1, 1, 1}};
  std::vector<Vec3> from = {{0, 0, 0}, {10, 0, 0}, {0, 7, 0}, {2, 3, 0}}, to;
  for (const Vec3& p : from)
    to.push_back(truth.apply(p));
  const RigidMotion found = register_rigidly(from, to, truth.reference_point);
  EXPECT_LT((found.rotation - truth.rotation).norm(), 1e-12);
  EXPECT_LT((found.translation - truth.translation).norm(), 1e-12);
  EXPECT_NEAR(found.rotation.determinant(), 1, 1e-12);
}

TEST(SkinError, WeighsByAreaAndSignsByTheNormal)
{
  const std::vector<double> d = {-1.0, 3.0, 0.5, 100.0};
  const SkinError e = skin_error(d, {2, 1, 1, 0});
  EXPECT_DOUBLE_EQ(e.mean, (2 * 1.0 + 3.0 + 0.5) / 4);
  EXPECT_DOUBLE_EQ(e.signed_mean, (-2 * 1.0 + 3.0 + 0.5) / 4);
  EXPECT_DOUBLE_EQ(e.max, 3);
  EXPECT_DOUBLE_EQ(e.median, 1);
  EXPECT_DOUBLE_EQ(e.under_1mm, 0.25);
  EXPECT_DOUBLE_EQ(e.under_2mm, 0.75);
  EXPECT_NEAR(e.sd * e.sd, e.variance, 1e-15);
  const auto s =
      signed_distances({{0, 0, -1}, {0, 0, 2}}, {{0, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}});
  EXPECT_DOUBLE_EQ(s[0], -1);
  EXPECT_DOUBLE_EQ(s[1], 2);
}

} // namespace
} // namespace f2b
