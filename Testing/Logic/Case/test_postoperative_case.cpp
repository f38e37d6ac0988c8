#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/json_file.hpp>
#include <Case/fragment_json.hpp>
#include <Case/postoperative.hpp>
#include <Case/verbs.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

/// The virtual patient on coarse voxels, cut and not operated on.
TEST(PostoperativeFindings, TheSameCtSaysThatNothingMoved)
{
  const test::TemporaryFolder folder;
  SampleOptions sample;
  sample.spacing_mm = 2.5;
  write_sample(folder / "sample", sample, no_progress);
  const Path source = folder / "sample" / case_settings_name;
  nlohmann::json document = read_json(source);
  document["segmentation"]["spacing_mm"] = 2;
  CaseSession session(folder / "case", document, source);
  segment_case(session);
  cut_case(session);

  PostoperativeOptions options;
  options.registration.samples = 4000;
  options.registration.disturbed_starts = 1;
  options.registration.spacing_mm = 2;
  const Path ct = folder / "sample" / "ct.nrrd";
  const PostoperativeFindings found = postoperative_findings(session, ct, options);
  const RigidMotion& head = found.registration.to_postoperative;
  EXPECT_LT((head.apply(Vec3(0, 80, -60)) - Vec3(0, 80, -60)).norm(), 0.1);
  ASSERT_EQ(found.movements.size(), 1U);
  EXPECT_LT(found.movements[0].fit.motion.translation.norm(), 0.1);
  EXPECT_FALSE(found.movements[0].doubtful());

  const nlohmann::json& told = found.document;
  const nlohmann::json& fragment = told.at("fragments").at(0);
  EXPECT_EQ(fragment.at("name"), "mid-face");
  EXPECT_EQ(motion_from(fragment).matrix(), found.movements[0].fit.motion.matrix());
  EXPECT_FALSE(fragment.contains("from_plan_mm")) << "there is no plan";
  EXPECT_LT(told.at("skin_distance_mm").at("rest").at("mean").get<double>(),
            0.2); // of 2.5 mm voxels
  EXPECT_GT(told.at("skin_distance_mm").at("rest").at("area_mm2").get<double>(), 20000);
  EXPECT_FALSE(told.at("skin_distance_mm").contains("predicted")) << "nothing was predicted";
  EXPECT_TRUE(told.at("warnings").empty()) << told.at("warnings");

  options.box_ras = Box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  test::expect_error([&] { (void)postoperative_findings(session, ct, options); },
                     {"box", "ml of bone"});
  options.mask = "mask.nrrd";
  test::expect_error([&] { (void)postoperative_findings(session, ct, options); },
                     {"both a box and a mask"});
  test::expect_error([&] { (void)postoperative_findings(session, folder / "none.nrrd"); },
                     {"none.nrrd", "does not exist"});
}

} // namespace
} // namespace f2b
