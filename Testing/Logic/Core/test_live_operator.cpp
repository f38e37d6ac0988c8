#include "Core/error.hpp"
#include "Core/inverse/live_operator.hpp"
#include "Logic/Core/slab_face.hpp"

namespace f2b
{
namespace
{

using namespace testing;

double rms(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v)
    sum += (a[v] - b[v]).squaredNorm();
  return std::sqrt(sum / double(a.size()));
}

std::vector<Vec3> scaled(std::vector<Vec3> field, double factor)
{
  for (Vec3& v : field)
    v *= factor;
  return field;
}

TEST(LiveOperator, GivesTheFullPlanWhereItWasLinearised)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  const RigidFitResult plan = fit_fragments(slab.face, target, {}, no_progress);
  const LiveOperator live(slab.face, {}, plan, no_progress);
  const LiveOperator::Answer answer = live.update(target.displacement);
  EXPECT_LT((answer.motions[0].translation - plan.motions[0].translation).norm(), 1e-6);
  EXPECT_LT(rms(answer.skin_displacement, plan.skin_displacement), 1e-6);
  EXPECT_LT(answer.doubt_mm, 1e-9);
}

TEST(LiveOperator, ItsErrorIsSecondOrderAndItsDoubtIsAboutThat)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  const RigidFitResult plan = fit_fragments(slab.face, target, {}, no_progress);
  const LiveOperator live(slab.face, {}, plan, no_progress);
  double before = 0;
  for (const double share : {0.8, 0.6})
  {
    const auto displacement = scaled(target.displacement, share);
    const LiveOperator::Answer answer = live.update(displacement);
    const RigidFitResult full =
        fit_fragments(slab.face, {displacement, target.weight, {}}, {}, no_progress);
    const Prediction exact = predict_face(slab.face, answer.motions, {}, no_progress);
    const double off = rms(answer.skin_displacement, exact.skin_displacement);
    std::printf("share %.1f: linear face off by %.4f mm, doubt %.4f mm, plan off by %.4f mm\n",
                share, off, answer.doubt_mm,
                (answer.motions[0].translation - full.motions[0].translation).norm());
    EXPECT_LT(off, 3 * answer.doubt_mm);
    EXPECT_GT(off, answer.doubt_mm / 6);
    EXPECT_GT(off, 2 * before); // twice as far: about four times the error
    before = off;
    EXPECT_LT((answer.motions[0].translation - full.motions[0].translation).norm(), 0.3);
  }
}

TEST(LiveOperator, FromRestItFindsSmallMovements)
{
  const Slab slab;
  RigidMotion truth;
  truth.translation = {0.2, -0.4, 0.3};
  truth.rotation = rotation_from({0.4 * degree, 0, 0});
  const LiveOperator live(slab.face, {}, no_progress);
  const LiveOperator::Answer answer = live.update(slab.target_of(truth).displacement);
  EXPECT_LT((answer.motions[0].translation - truth.translation).norm(), 0.02);
  EXPECT_GT(answer.doubt_mm, 0);
  EXPECT_LT(answer.doubt_mm, 0.05);
}

TEST(LiveOperator, KeepsBoundsAndRefusesSkinThatLeavesMovementsFree)
{
  const Slab slab;
  RigidFitOptions options;
  options.rules.resize(1);
  options.rules[0].coordinates[5].most = 1;
  LiveOperator live(slab.face, options, no_progress);
  std::vector<Vec3> up(slab.weights().size(), Vec3(0, 0, 5));
  const LiveOperator::Answer answer = live.update(up);
  EXPECT_EQ(answer.motions[0].translation.z(), 1);
  std::vector<double> none(slab.weights().size(), 0.0);
  EXPECT_THROW(live.set_weight(none), Error);
  EXPECT_THROW(live.set_weight(none), Error); // again, and what counted before still does
  EXPECT_EQ(live.update(up).q, answer.q);
}

} // namespace
} // namespace f2b
