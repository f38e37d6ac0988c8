#include "Core/inverse/forward_search.hpp"
#include "Logic/Core/slab_face.hpp"

namespace f2b
{
namespace
{

using namespace testing;

TEST(ForwardSearch, AgreesWithTheFitOnATargetThatNoMovementGives)
{
  const Slab slab;
  SkinTarget target = slab.target_of(table_2_motion());
  const std::vector<Vec3> positions = slab.positions();
  for (std::size_t v = 0; v < positions.size(); ++v) // bulges that bone does not make
    target.displacement[v] += Vec3(0, 0, std::sin(positions[v].x() / 6));
  const RigidFitResult fit = fit_fragments(slab.face, target, {}, no_progress);
  const double reached = weighted_rms_mm(slab.face, target, fit.skin_displacement);
  const ForwardSearchResult best = search_by_predictions(slab.face, target, {}, no_progress);
  std::printf("rigid-fit leaves %.6f mm, the search %.6f mm after %d forward solves\n", reached,
              best.rms_mm, best.predictions);
  EXPECT_TRUE(best.converged);
  EXPECT_GT(reached, 0.1);
  EXPECT_NEAR(reached / best.rms_mm, 1, 1e-4);
  EXPECT_LT((best.motions[0].translation - fit.motions[0].translation).norm(), 0.05);
}

TEST(RigidFit, StartsFromAnotherPlanOfTheSameFace)
{
  const Slab slab;
  const SkinTarget target = slab.target_of(table_2_motion());
  const RigidFitResult plan = fit_fragments(slab.face, target, {}, no_progress);
  SkinTarget other = target;
  for (Vec3& d : other.displacement)
    d *= 1.02;
  const RigidFitResult cold = fit_fragments(slab.face, other, {}, no_progress);
  const RigidFitResult warm = fit_fragments(slab.face, other, {}, no_progress, &plan);
  EXPECT_EQ(warm.termination, RigidFitTermination::Converged);
  EXPECT_LT((warm.q - cold.q).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(warm.iterations.size(), cold.iterations.size());
}

} // namespace
} // namespace f2b
