#include "Core/error.hpp"
#include "Core/inverse/live_operator.hpp"
#include "Core/inverse/plan_uncertainty.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Core/inverse/skin_sensitivity.hpp"
#include "Logic/Core/slab_face.hpp"

#include <algorithm>
#include <random>

namespace f2b
{
namespace
{

using namespace testing;

constexpr SlabOptions two_blocks{8, 2, 80, 14, 1.5, 4, 0.6, 2};

RigidMotion about(const Vec3& reference, const Vec3& translation, const EulerAngles& angles)
{
  return {rotation_from(angles), translation, reference};
}

std::vector<RigidMotion> two_motions(const Slab& slab)
{
  const auto& c = slab.face.reference_points;
  return {about(c[0], {1, -2, 3}, {2 * degree, 1 * degree, 0}),
          about(c[1], {-1, 1, 2}, {0, -3 * degree, 2 * degree})};
}

void expect_descent(const RigidFitResult& fit)
{
  for (std::size_t i = 1; i < fit.iterations.size(); ++i)
    EXPECT_LE(fit.iterations[i].objective, fit.iterations[i - 1].objective);
}

TEST(ConstrainedFit, TwoFragmentsAreFoundInAnyOrder)
{
  const Slab slab(two_blocks);
  const auto truth = two_motions(slab);
  const SkinTarget target = slab.target_of(truth);
  const RigidFitResult fit = fit_fragments(slab.face, target, {}, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  expect_descent(fit);
  MixedMesh swapped = slab.mesh;
  std::swap(swapped.fragments[0], swapped.fragments[1]);
  for (int& f : swapped.node_fragment)
    f = f < 0 ? f : 1 - f;
  const Discretization tissue(swapped);
  const FaceModel face{tissue,
                       slab.materials,
                       slab.skin,
                       slab.face.skin_area,
                       {slab.face.reference_points[1], slab.face.reference_points[0]}};
  const RigidFitResult other = fit_fragments(face, target, {}, no_progress);
  for (std::size_t f = 0; f < 2; ++f)
  {
    EXPECT_LT((fit.motions[f].translation - truth[f].translation).norm(), 1e-5);
    EXPECT_LT(angle_between(fit.motions[f].rotation, truth[f].rotation), 1e-6);
    EXPECT_LT((fit.motions[f].translation - other.motions[1 - f].translation).norm(), 1e-5);
    EXPECT_LT(angle_between(fit.motions[f].rotation, other.motions[1 - f].rotation), 1e-6);
  }
}

/// What the left block does, asked for far from the right one, and not quite what it can do.
SkinTarget target_of_the_left(const Slab& slab)
{
  const auto truth = two_motions(slab);
  SkinTarget target =
      slab.target_of({truth[0], about(slab.face.reference_points[1], Vec3::Zero(), {})});
  const std::vector<Vec3> positions = slab.positions();
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    target.displacement[v].z() += 0.3 * std::sin(0.2 * positions[v].y());
    target.weight[v] = positions[v].x() < -12 ? 1 : 0;
  }
  return target;
}

TEST(ConstrainedFit, AFragmentThatTheTargetSaysNothingOfStays)
{
  const Slab slab(two_blocks);
  const SkinTarget target = target_of_the_left(slab);
  const RigidFitResult fit = fit_fragments(slab.face, target, {}, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  EXPECT_EQ(fit.held_fragments, std::vector<int>{1});
  EXPECT_EQ(fit.motions[1].matrix(), Mat4(Mat4::Identity()));
  EXPECT_LT((fit.motions[0].translation - two_motions(slab)[0].translation).norm(), 0.5);
  EXPECT_EQ(std::count_if(fit.at_bounds.begin(), fit.at_bounds.end(),
                          [](Eigen::Index k) { return k >= 6; }),
            6);
  const auto sure = plan_uncertainty(slab.face, target, {}, fit, slab.positions(), {});
  EXPECT_GT(sure[4].half_90(), 0);
  EXPECT_EQ(sure[10].half_90(), 0); // not planned
  RigidFitOptions options;
  options.rules.resize(2);
  options.rules[1].coordinates[4].sd = 1; // whoever gives it a prior wants it planned
  EXPECT_TRUE(fit_fragments(slab.face, target, options, no_progress).held_fragments.empty());
}

TEST(ConstrainedFit, TheLiveOperatorHoldsWhatTheFitHolds)
{
  const Slab slab(two_blocks);
  const SkinTarget target = target_of_the_left(slab);
  LiveOperator live(slab.face, {}, no_progress);
  EXPECT_TRUE(live.update(target.displacement).held_fragments.empty()); // all skin counts as yet
  live.set_weight(target.weight);
  const LiveOperator::Answer answer = live.update(target.displacement);
  EXPECT_EQ(answer.held_fragments, std::vector<int>{1});
  EXPECT_EQ(answer.motions[1].matrix(), Mat4(Mat4::Identity()));
  const RigidFitResult fit = fit_fragments(slab.face, target, {}, no_progress);
  EXPECT_LT((answer.motions[0].translation - fit.motions[0].translation).norm(), 0.5);
}

TEST(ConstrainedFit, LockedTogetherFragmentsMoveAsOne)
{
  const Slab slab(two_blocks);
  const auto& c = slab.face.reference_points;
  const RigidMotion whole = about(c[0], {1, -2, 3}, {2 * degree, 1 * degree, 3 * degree});
  RigidMotion led = whole;
  led.reference_point = c[1];
  led.translation = whole.apply(c[1]) - c[1];
  RigidFitOptions options;
  options.rules.resize(2);
  options.rules[1].bite = BiteRelation{0, {}, 0, {}};
  const RigidFitResult fit =
      fit_fragments(slab.face, slab.target_of({whole, led}), options, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  ASSERT_EQ(fit.q.size(), 6);
  EXPECT_LT((fit.motions[0].translation - whole.translation).norm(), 1e-5);
  EXPECT_LT((fit.motions[1].translation - led.translation).norm(), 1e-5);
  EXPECT_LT(angle_between(fit.motions[1].rotation, led.rotation), 1e-6);
}

TEST(ConstrainedFit, AHingedFragmentFindsItsAngle)
{
  const Slab slab;
  RigidFitOptions options;
  options.rules.resize(1);
  options.rules[0].hinge = Hinge{{0, -60, 0}, Vec3::UnitX(), {}};
  const MovementSpace space = movement_space(slab.face, options);
  const Eigen::VectorXd truth = Eigen::VectorXd::Constant(1, 4 * degree);
  const RigidFitResult fit =
      fit_fragments(slab.face, slab.target_of(space.motions(truth)), options, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  ASSERT_EQ(fit.q.size(), 1);
  EXPECT_NEAR(fit.q[0], truth[0], 1e-7);
}

TEST(ConstrainedFit, ABoundHoldsAndTheRestIsTheBestWithinIt)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  RigidFitOptions options;
  options.rules.resize(1);
  options.rules[0].coordinates[4].least = -3; // the truth is -5
  options.rules[0].coordinates[0].is_locked = true;
  const RigidFitResult fit = fit_fragments(slab.face, target, options, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  expect_descent(fit);
  EXPECT_EQ(fit.motions[0].translation.y(), -3);
  EXPECT_NEAR(euler_angles(fit.motions[0].rotation).pitch, 0, 1e-14);
  ASSERT_EQ(fit.at_bounds, std::vector<Eigen::Index>{3}); // roll, yaw, right, anterior, superior
  // no movement nearby within the bounds is better
  const SkinResidual residual(target, fit_weights(slab.face, target));
  const MovementSpace space = movement_space(slab.face, options);
  const double best = residual.objective(fit.skin_displacement);
  for (Eigen::Index k = 0; k < space.size(); ++k)
    for (const double sign : {-1.0, 1.0})
    {
      Eigen::VectorXd q = fit.q;
      q[k] += sign * (space.coordinates()[std::size_t(k)].is_angle() ? 2e-3 : 0.05);
      if ((q - space.least()).minCoeff() < 0)
        continue;
      const Prediction p = predict_face(slab.face, space.motions(q), {}, no_progress);
      EXPECT_GT(residual.objective(p.skin_displacement), best);
    }
}

TEST(ConstrainedFit, BoundsWithoutTheRestPositionAreKept)
{
  const Slab slab;
  RigidFitOptions options;
  options.rules.resize(1);
  options.rules[0].coordinates[5].least = 1;
  const RigidFitResult fit = fit_fragments(
      slab.face, {std::vector<Vec3>(slab.weights().size(), Vec3::Zero()), slab.weights(), {}},
      options, no_progress);
  EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
  EXPECT_EQ(fit.motions[0].translation.z(), 1);
}

TEST(ConstrainedFit, APriorPullsTowardsItsValue)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  RigidFitOptions options;
  options.rules.resize(1);
  options.rules[0].coordinates[4].expected = -1;
  double before = -5; // the target's own value
  for (const double sd : {1.0, 0.1, 0.001})
  {
    options.rules[0].coordinates[4].sd = sd;
    const RigidFitResult fit = fit_fragments(slab.face, target, options, no_progress);
    EXPECT_EQ(fit.termination, RigidFitTermination::Converged);
    EXPECT_GT(fit.motions[0].translation.y(), before);
    before = fit.motions[0].translation.y();
  }
  EXPECT_NEAR(before, -1, 1e-2);
}

TEST(ConstrainedFit, AFragmentThatMovesNoSkinOfTheTargetIsNamed)
{
  const Slab slab(two_blocks);
  SkinTarget target = slab.target_of(two_motions(slab));
  std::fill(target.weight.begin(), target.weight.end(), 0.0);
  EXPECT_THROW((void)fit_fragments(slab.face, target, {}, no_progress), Error);
  MixedMesh idle = slab.mesh;
  for (std::size_t n = 0; n < idle.X.size(); ++n)
    if (idle.node_fragment[n] == 1)
    {
      idle.node_fragment[n] = -1;
      idle.node_boundary[n] = Boundary::FixedBone;
    }
  const Discretization tissue(idle);
  const FaceModel face{tissue, slab.materials, slab.skin, slab.face.skin_area,
                       slab.face.reference_points};
  target.weight = slab.weights();
  try
  {
    (void)fit_fragments(face, target, {}, no_progress);
    FAIL() << "a fragment without tissue";
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("fragment 'right'"), std::string::npos)
        << error.what();
  }
}

/// The nearest point of a triangle to p (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Vec3 nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  auto on_edge = [&](const Vec3& u, const Vec3& v)
  {
    const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
    return Vec3(u + t * (v - u));
  };
  const Vec3 n = (b - a).cross(c - a);
  const Vec3 foot = p - n * n.dot(p - a) / n.squaredNorm();
  const bool inside = n.dot((b - a).cross(foot - a)) >= 0 && n.dot((c - b).cross(foot - b)) >= 0 &&
                      n.dot((a - c).cross(foot - c)) >= 0;
  if (inside)
    return foot;
  Vec3 best = on_edge(a, b);
  for (const Vec3& q : {on_edge(b, c), on_edge(c, a)})
    if ((q - p).norm() < (best - p).norm())
      best = q;
  return best;
}

/// A scan of a face: triangles, one for every three vertices of the slab's reference skin.
struct Scan
{
  std::vector<Vec3> rest, corners;

  NearestTarget nearest(std::size_t v, const Vec3& displacement) const
  {
    const Vec3 p = rest[v] + displacement;
    NearestTarget best{Vec3::Constant(1e9), Vec3::UnitZ()};
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    {
      const Vec3 q = nearest_in_triangle(p, corners[t], corners[t + 1], corners[t + 2]);
      if ((q - p).norm() < (best.displacement - displacement).norm())
        best = {q - rest[v],
                (corners[t + 1] - corners[t]).cross(corners[t + 2] - corners[t]).normalized()};
    }
    return best;
  }
};

TEST(ConstrainedFit, AScanWithoutCorrespondenceGivesTheMovement)
{
  const Slab slab;
  const RigidMotion truth = table_2_motion();
  const SkinTarget moved = slab.target_of(truth);
  Scan scan{slab.positions(), slab.positions()};
  for (std::size_t v = 0; v < scan.corners.size(); ++v)
    scan.corners[v] += moved.displacement[v];
  SkinTarget target{{}, slab.weights(), {}};
  target.nearest = [&](std::size_t v, const Vec3& d) { return scan.nearest(v, d); };
  const RigidFitResult fit = fit_fragments(slab.face, target, {}, no_progress);
  expect_descent(fit);
  std::printf("scan: %zu iterations, objective %.3g\n", fit.iterations.size(),
              fit.iterations.back().objective);
  // the way along the skin is hardly seen: flat skin slides in itself
  EXPECT_NEAR(fit.motions[0].translation.z(), truth.translation.z(), 1e-2);
  EXPECT_LT((fit.motions[0].translation - truth.translation).norm(), 0.05);
  EXPECT_LT(angle_between(fit.motions[0].rotation, truth.rotation), 0.2 * degree);
}

TEST(ConstrainedFit, SensitivitiesAreDerivativesOfTheFace)
{
  const Slab slab(two_blocks);
  RigidFitOptions options;
  options.rules.resize(2);
  options.rules[1].hinge = Hinge{{0, -60, 0}, Vec3(1, 0.2, 0).normalized(), {}};
  const MovementSpace space = movement_space(slab.face, options);
  Eigen::VectorXd q(7);
  q << 0.03, -0.02, 0.05, 1, -2, 2, 0.04;
  const EquilibriumOptions exact{25, 1e-11};
  const Prediction here = predict_face(slab.face, space.motions(q), exact, no_progress);
  ElasticModel model(slab.tissue, slab.materials,
                     held_controls(slab.tissue, Held::BoneAndFragments));
  EquilibriumSolver solver(model, exact);
  const auto columns = skin_columns(slab.face, space, q, here.x, solver, 1e-12);
  const double h = 1e-4;
  for (Eigen::Index k = 0; k < 7; ++k)
  {
    const Eigen::VectorXd d = h * Eigen::VectorXd::Unit(7, k);
    const Prediction ahead = predict_face(slab.face, space.motions(q + d), exact, no_progress);
    const Prediction behind = predict_face(slab.face, space.motions(q - d), exact, no_progress);
    double off = 0, size = 0;
    for (std::size_t v = 0; v < ahead.skin_displacement.size(); ++v)
    {
      const Vec3 difference = (ahead.skin_displacement[v] - behind.skin_displacement[v]) / (2 * h);
      off = std::max(off, (difference - columns[std::size_t(k)][v]).norm());
      size = std::max(size, difference.norm());
    }
    std::printf("coordinate %s: %.2e of the largest\n", space.coordinates()[std::size_t(k)].name(),
                off / size);
    EXPECT_LT(off, 1e-5 * size);
  }
}

TEST(ConstrainedFit, TurningTheWholeCaseTurnsThePlan)
{
  const Slab slab;
  SkinTarget target = slab.target_of(table_2_motion());
  std::mt19937 generator(4);
  std::normal_distribution<double> noise(0, 0.5); // so that no plan reaches it
  for (Vec3& d : target.displacement)
    d += Vec3(noise(generator), noise(generator), noise(generator));
  const Mat3 turn = rotation_from({0.5, -0.7, 1.1});
  MixedMesh mesh = slab.mesh;
  for (Vec3& x : mesh.X)
    x = turn * x + Vec3(5, 6, 7);
  const Discretization tissue(mesh);
  const SkinInterpolation skin(tissue, corner_map(mesh));
  const FaceModel face{tissue, slab.materials, skin, slab.face.skin_area, {Vec3(5, 6, 7)}};
  SkinTarget turned = target;
  for (Vec3& d : turned.displacement)
    d = turn * d;
  const RigidFitResult a = fit_fragments(slab.face, target, {}, no_progress);
  const RigidFitResult b = fit_fragments(face, turned, {}, no_progress);
  EXPECT_LT((turn * a.motions[0].translation - b.motions[0].translation).norm(), 2e-5);
  EXPECT_LT(angle_between(turn * a.motions[0].rotation * turn.transpose(), b.motions[0].rotation),
            1e-6);
}

} // namespace
} // namespace f2b
