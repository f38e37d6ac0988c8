#include <Core/inverse/reachability_words.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace f2b
{
namespace
{

/// A strip of skin: 100 vertices of 10 mm2 in each region, moved by what is stated.
struct Strip
{
  void add(FaceRegion region, const Vec3& asked, const Vec3& got, int fragment = -1,
           double weight = 1)
  {
    for (int v = 0; v < 100; ++v)
    {
      target.displacement.push_back(asked);
      target.weight.push_back(weight);
      reached.push_back(got);
      parts.area.push_back(10);
      parts.region.push_back(region);
      parts.fragment_below.push_back(fragment);
    }
  }
  Reachability reach() const { return reachability(target, reached, parts); }
  std::vector<std::string> sentences(const PlannedCuts& cuts = {{"mid-face", "chin"}, {}}) const
  {
    return reach_sentences(reach(), cuts);
  }
  SkinTarget target;
  std::vector<Vec3> reached;
  SkinParts parts;
};

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(Reachability, FiguresOfARegionAreThoseOfItsRemainder)
{
  Strip strip;
  strip.add(FaceRegion::Nose, {0, 6, 8}, {0, 6, 8}, 0);
  strip.add(FaceRegion::Chin, {0, 6, 0}, {0, 0.6, 0});
  const Reachability reach = strip.reach();
  ASSERT_EQ(reach.regions.size(), 2u);
  const RegionReach &nose = reach.regions[0], &chin = reach.regions[1];
  EXPECT_EQ(nose.region, FaceRegion::Nose);
  EXPECT_NEAR(nose.asked_rms, 10, 1e-12);
  EXPECT_NEAR(nose.left_max, 0, 1e-12);
  EXPECT_NEAR(chin.area_mm2, 1000, 1e-9);
  EXPECT_NEAR(chin.asked_p90, 6, 1e-12);
  EXPECT_NEAR(chin.left_rms, 5.4, 1e-12);
  EXPECT_NEAR(chin.left_p90, 5.4, 1e-12);
  EXPECT_NEAR(chin.share_left, 0.9, 1e-12);
  EXPECT_NEAR(reach.whole.asked_rms, std::sqrt(0.5 * (100 + 36)), 1e-9);
  EXPECT_NEAR(reach.whole.left_rms, std::sqrt(0.5 * 5.4 * 5.4), 1e-9);
  EXPECT_NEAR(reach.unreachable_mm.at(150), 5.4, 1e-12);
}

TEST(Reachability, SkinWithoutTargetOrMeshDoesNotCount)
{
  Strip strip;
  strip.add(FaceRegion::Chin, {0, 6, 0}, {0, 6, 0});
  strip.add(FaceRegion::Chin, {0, 0, 0}, {0, 9, 0}, -1, 0);
  strip.add(FaceRegion::Neck, {0, 0, 0}, {0, 9, 0}, -1, 0);
  strip.parts.area[0] = 0;
  const Reachability reach = strip.reach();
  ASSERT_EQ(reach.regions.size(), 1u);
  EXPECT_NEAR(reach.regions[0].left_max, 0, 1e-12);
  EXPECT_NEAR(reach.regions[0].area_mm2, 990, 1e-9);
  EXPECT_TRUE(std::isnan(reach.unreachable_mm[0]));
  EXPECT_TRUE(std::isnan(reach.unreachable_mm[150]));
  EXPECT_EQ(reach.unreachable_mm[50], 0);
}

TEST(Reachability, SaysOverWhichFragmentTheRemainderLies)
{
  Strip strip;
  strip.add(FaceRegion::Nose, {0, 5, 0}, {0, 2, 0}, 1);
  strip.add(FaceRegion::Nose, {0, 5, 0}, {0, 4, 0}, 0);
  strip.add(FaceRegion::Nose, {0, 5, 0}, {0, 3, 0}, -1);
  const RegionReach nose = strip.reach().regions.at(0);
  EXPECT_NEAR(nose.left_over_fragments, 10.0 / 14, 1e-12);
  EXPECT_EQ(nose.fragment, 1);
}

TEST(Reachability, NothingAskedAndNothingLeftIsReached)
{
  Strip strip;
  strip.add(FaceRegion::Chin, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(strip.reach().whole.share_left, 0);
  EXPECT_EQ(verdict_on(strip.reach().regions.at(0)), ReachVerdict::Reached);
}

TEST(ReachSentences, NameTheChinAndTheCutThatItNeeds)
{
  Strip strip;
  strip.add(FaceRegion::Nose, {0, 8, 0}, {0, 7.5, 0}, 0);
  strip.add(FaceRegion::Chin, {0, 6.1, 0}, {0, 0.7, 0});
  EXPECT_EQ(strip.sentences(),
            std::vector<std::string>{"The chin target (6.1 mm) is out of reach of these cuts: 5.4 "
                                     "mm are left there; this needs a cut of the chin "
                                     "(genioplasty)."});
}

TEST(ReachSentences, RegionsThatNeedTheSameAreToldTogether)
{
  Strip strip;
  strip.add(FaceRegion::CheekRight, {0, 4, 0}, {0, 1, 0});
  strip.add(FaceRegion::CheekLeft, {0, 5, 0}, {0, 1, 0});
  strip.add(FaceRegion::LowerLip, {0, 5, 0}, {0, 0, 0});
  const auto sentences = strip.sentences();
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences[1],
            "The right cheek target (4.0 mm) and the left cheek target (5.0 mm) are "
            "out of reach of these cuts: 3.0 mm and 4.0 mm are left there; this needs "
            "a cut of the mid-face (le-fort-3).");
  EXPECT_TRUE(contains(sentences[0], "this needs a cut of the mandible")) << sentences[0];
}

TEST(ReachSentences, OverAFragmentTheRestIsForTheSoftTissue)
{
  Strip strip;
  strip.add(FaceRegion::Nose, {0, 8, 0}, {0, 5, 0}, 0);
  const auto sentences = strip.sentences();
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_TRUE(contains(sentences[0], "reached in part")) << sentences[0];
  EXPECT_TRUE(contains(sentences[0], "'mid-face'")) << sentences[0];
  EXPECT_TRUE(contains(sentences[0], "soft tissue")) << sentences[0];
  EXPECT_FALSE(contains(sentences[0], "needs")) << sentences[0];
}

TEST(ReachSentences, ACutThatIsPlannedIsNotAskedForAgain)
{
  Strip strip;
  strip.add(FaceRegion::Chin, {0, 6, 0}, {0, 1, 0});
  const auto sentences = strip.sentences({{"chin"}, {"genioplasty"}});
  EXPECT_TRUE(contains(sentences.at(0), "the planned genioplasty does not")) << sentences[0];
}

TEST(ReachSentences, SkinThatIsTakenAlongIsTold)
{
  Strip strip;
  strip.add(FaceRegion::UpperLip, {0, 0.2, 0}, {0, 2.9, 0}, 0);
  const auto sentences = strip.sentences();
  EXPECT_EQ(sentences.at(0), "The upper lip hardly moves in the target, but these cuts take it "
                             "along: 2.7 mm are left there.");
}

TEST(ReachSentences, AReachedTargetIsToldToo)
{
  Strip strip;
  strip.add(FaceRegion::Nose, {0, 8, 0}, {0, 7.9, 0}, 0);
  EXPECT_EQ(strip.sentences(),
            std::vector<std::string>{"These cuts reach the whole target: 90 % of its skin lies "
                                     "within 0.1 mm of it."});
}

TEST(ReachSentences, LimitsDecideFromWhenOn)
{
  Strip strip;
  strip.add(FaceRegion::Chin, {0, 6, 0}, {0, 4.01, 0});
  const RegionReach chin = strip.reach().regions.at(0);
  EXPECT_EQ(verdict_on(chin), ReachVerdict::Reached) << "1.99 mm";
  ReachLimits strict;
  strict.left_mm = 1.5;
  EXPECT_EQ(verdict_on(chin, strict), ReachVerdict::ReachedInPart);
  strict.least_area_mm2 = 2000;
  EXPECT_EQ(verdict_on(chin, strict), ReachVerdict::Reached);
}

TEST(ReachSentences, WithoutRegionsNoCutIsNamed)
{
  Strip strip;
  strip.add(FaceRegion::Other, {0, 6, 0}, {0, 1, 0});
  const auto sentences = strip.sentences();
  EXPECT_TRUE(contains(sentences.at(0), "The face target (6.0 mm)")) << sentences[0];
  EXPECT_TRUE(contains(sentences.at(0), "without landmarks")) << sentences[0];
}

TEST(CutForRegion, TemplatesAreThoseThatThereAre)
{
  const auto known = osteotomy_template_names();
  for (const FaceRegion region : all_face_regions())
  {
    const CutForRegion cut = cut_for(region);
    EXPECT_TRUE(cut.template_name.empty() ||
                std::count(known.begin(), known.end(), cut.template_name) == 1)
        << name_of(region);
    EXPECT_TRUE(cut.template_name.empty() || !cut.bone.empty());
  }
  EXPECT_EQ(cut_for(FaceRegion::Chin).template_name, "genioplasty");
  EXPECT_EQ(cut_for(FaceRegion::UpperLip).template_name, "le-fort-1");
  EXPECT_EQ(cut_for(FaceRegion::JawLeft).bone, "the mandible");
}

} // namespace
} // namespace f2b
