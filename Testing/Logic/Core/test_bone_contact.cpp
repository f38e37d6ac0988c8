#include "Logic/Core/box_bone.hpp"

#include <Core/geometry/bone_gap.hpp>
#include <Core/mesh/skin_over_bone.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::box_bone;
using testing::cut_at;

constexpr unsigned char first = BonePartition::first_fragment, second = first + 1;
constexpr double section_mm2 = 40 * 30;

/// The block of 60 x 40 x 30 mm, sawn at R = 0 and, with two fragments, at R = -20 as well: `end`
/// lies to the right, `middle` between the cuts.
struct SawnBlock
{
  explicit SawnBlock(double kerf_mm, bool two = false) : bone(box_bone())
  {
    osteotomies = {cut_at(0, 20, "end", kerf_mm)};
    if (two)
      osteotomies.push_back(cut_at(-20, -10, "middle", kerf_mm));
    parts = cut_bone(bone, bone, osteotomies).labels;
  }
  CutBone cut() const { return {bone, parts, osteotomies}; }
  ScalarGrid bone;
  std::vector<Osteotomy> osteotomies;
  LabelGrid parts;
};

MovedPart moved(unsigned char label, const Vec3& translation, const EulerAngles& angles = {})
{
  MovedPart part{label, {}};
  part.motion.rotation = rotation_from(angles);
  part.motion.translation = translation;
  return part;
}

TEST(SkinOverBone, TellsTheFragmentBelow)
{
  const SawnBlock block(1, true);
  const std::vector<Vec3> skin = {{15, 27, 0}, {-10, -27, 3}, {-28, 0, 22}, {38, 2, 2}};
  EXPECT_EQ(fragments_below(block.bone, block.parts, skin), (std::vector<int>{0, 1, -1, 0}));
}

TEST(CutFace, HasTheAreaOfTheSection)
{
  const SawnBlock block(1);
  double area = 0;
  for (const CutPoint& c : common_cut(block.cut(), first, BonePartition::uncut))
  {
    area += c.area_mm2;
    EXPECT_NEAR(c.place.x(), 0, 1e-9);
    EXPECT_EQ(c.normal, Vec3(1, 0, 0)) << "towards the fragment";
    EXPECT_EQ(c.kerf_mm, 1);
  }
  EXPECT_NEAR(area, section_mm2, 1e-6);
}

TEST(CutFace, HasTheAreaOfAnObliqueSection)
{
  const ScalarGrid bone = box_bone();
  Osteotomy oblique = cut_at(0, 20);
  const double c = std::cos(0.5), s = std::sin(0.5);
  oblique.planes[0].u = Vec3(-s, c, 0);
  const LabelGrid parts = cut_bone(bone, bone, {oblique}).labels;
  const std::vector<Osteotomy> osteotomies{oblique};
  double area = 0;
  for (const CutPoint& point : common_cut({bone, parts, osteotomies}, first, BonePartition::uncut))
    area += point.area_mm2;
  EXPECT_NEAR(area, section_mm2 / c, 0.03 * section_mm2 / c);
}

TEST(BoneOverlap, IsNoneAtRestAndAwayFromTheOtherBone)
{
  const SawnBlock block(0);
  for (const Vec3& t : {Vec3(0, 0, 0), Vec3(4, 3, 0), Vec3(0.2, 0, 7)})
    EXPECT_EQ(overlap_between(block.cut(), moved(first, t), {}).volume_mm3, 0) << t.transpose();
}

TEST(BoneOverlap, IsAsDeepAsTheFragmentWasPushedInButForTheKerf)
{
  for (const double kerf : {0.0, 2.0})
  {
    const SawnBlock block(kerf);
    const double push = 5, depth = push - kerf;
    const BoneOverlap overlap = overlap_between(block.cut(), moved(first, {-push, 0, 0}), {});
    EXPECT_NEAR(overlap.depth_mm, depth, 0.51) << kerf;
    EXPECT_NEAR(overlap.volume_mm3, depth * section_mm2, 0.5 * section_mm2) << kerf;
    EXPECT_NEAR(overlap.deepest.x(), -push + 0.5 * kerf, 1) << kerf;
  }
}

TEST(BoneOverlap, ACutMayCloseByItsKerf)
{
  const SawnBlock block(2);
  EXPECT_EQ(overlap_between(block.cut(), moved(first, {-1.9, 0, 0}), {}).volume_mm3, 0);
}

TEST(BoneOverlap, OfTwoMovedFragmentsCountsTheirRelativeMovement)
{
  const SawnBlock block(1, true);
  const Vec3 both(3, 40, -8);
  const EulerAngles turn{0.3, 0.1, -0.2};
  // together: nothing meets
  EXPECT_EQ(
      overlap_between(block.cut(), moved(first, both, turn), moved(second, both, turn)).volume_mm3,
      0);
  const MovedPart away = moved(second, both);
  const MovedPart pushed = moved(first, both + Vec3(-4, 0, 0));
  const BoneOverlap overlap = overlap_between(block.cut(), pushed, away);
  EXPECT_NEAR(overlap.depth_mm, 3, 0.51);
  EXPECT_NEAR(overlap.volume_mm3, 3 * section_mm2, 0.5 * section_mm2);
  EXPECT_NEAR(overlap.deepest.y(), 40, 21) << "told where the bone is after the movement";
  const BoneOverlap other_way = overlap_between(block.cut(), away, pushed);
  EXPECT_NEAR(other_way.volume_mm3, overlap.volume_mm3, 0.02 * overlap.volume_mm3);
}

TEST(BoneGap, IsNoneAtRestAndWhereTheCutCloses)
{
  const SawnBlock block(1);
  for (const double push : {0.0, -0.5, -3.0})
  {
    const BoneGap gap = gap_between(block.cut(), moved(first, {push, 0, 0}), {});
    EXPECT_NEAR(gap.cut_mm2, section_mm2, 1e-6);
    EXPECT_NEAR(gap.facing_share, 1, 1e-12);
    EXPECT_NEAR(gap.max_mm, 0, 1e-12);
    EXPECT_NEAR(gap.volume_mm3, 0, 1e-9);
  }
}

TEST(BoneGap, IsWhatThePartsMoveApartBeyondTheKerf)
{
  for (const double kerf : {0.0, 1.5})
  {
    const SawnBlock block(kerf);
    const BoneGap gap = gap_between(block.cut(), moved(first, {4, 0, 0}), {});
    EXPECT_NEAR(gap.mean_mm, 4, 1e-9) << kerf;
    EXPECT_NEAR(gap.max_mm, 4, 1e-9) << kerf;
    EXPECT_NEAR(gap.volume_mm3, 4 * section_mm2, 1e-6) << kerf;
    EXPECT_NEAR(gap.widest.x(), -0.5 * kerf, 1e-9) << kerf;
  }
}

TEST(BoneGap, SlidingLeavesAStepAndNoGap)
{
  const SawnBlock block(1);
  const BoneGap gap = gap_between(block.cut(), moved(first, {0, 10, 0}), {});
  EXPECT_NEAR(gap.max_mm, 0, 1e-9);
  EXPECT_NEAR(gap.facing_share, 30.0 / 40, 0.03);
}

TEST(BoneGap, OpensLikeAWedgeWhenTheFragmentTurns)
{
  // about the A axis through the cut's lower edge: the width grows linearly to 30 mm x tan(angle)
  const SawnBlock block(0);
  MovedPart part = moved(first, {0, 0, 0}, {0, 0.1, 0});
  part.motion.reference_point = {0, 0, -15};
  const BoneGap gap = gap_between(block.cut(), part, {});
  const double top = 29.5 * std::tan(0.1);
  EXPECT_NEAR(gap.max_mm, top, 0.02 * top);
  EXPECT_NEAR(gap.mean_mm, 15 * std::tan(0.1), 0.03 * top);
  EXPECT_GT(gap.widest.z(), 14);
}

TEST(BoneGap, BetweenTwoFragmentsIsTheirRelativeMovement)
{
  const SawnBlock block(1, true);
  const Vec3 both(0, 12, 0);
  const EulerAngles turn{0.2, -0.3, 0.1};
  const BoneGap none =
      gap_between(block.cut(), moved(first, both, turn), moved(second, both, turn));
  EXPECT_NEAR(none.max_mm, 0, 1e-9);
  EXPECT_NEAR(none.facing_share, 1, 1e-12);
  const BoneGap gap =
      gap_between(block.cut(), moved(first, both + Vec3(2.5, 0, 0)), moved(second, both));
  EXPECT_NEAR(gap.mean_mm, 2.5, 1e-9);
  EXPECT_NEAR(gap.widest.y(), 12, 21);
  EXPECT_EQ(gap_between(block.cut(), moved(first, both), {}).cut_mm2, 0) << "they share no cut";
}

} // namespace
} // namespace f2b
