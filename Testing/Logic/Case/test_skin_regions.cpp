#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/json_file.hpp>
#include <Bridge/point_labels.hpp>
#include <Case/face_regions.hpp>
#include <Case/plan_findings.hpp>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

vtkSmartPointer<vtkPolyData> square()
{
  return to_polydata({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}});
}

TEST(SkinRegions, AreKeptInTheFile)
{
  const TemporaryFolder folder;
  const auto skin = square();
  const std::vector<FaceRegion> regions = {FaceRegion::Nose, FaceRegion::Chin, FaceRegion::Other,
                                           FaceRegion::Neck};
  add_regions(skin, regions);
  write_surface(folder / "skin.vtp", skin);
  EXPECT_EQ(regions_of_skin(read_surface(folder / "skin.vtp")), regions);
}

TEST(SkinRegions, OfAnEditorThatWritesRealNumbersAreRead)
{
  const auto skin = square();
  add_point_array(skin, "region", std::vector<double>{4, 4, 9, 0});
  EXPECT_EQ(regions_of_skin(skin).at(2), FaceRegion::Chin);
}

TEST(SkinRegions, WithoutTheArrayAreAllOther)
{
  EXPECT_EQ(regions_of_skin(square()), std::vector<FaceRegion>(4, FaceRegion::Other));
}

TEST(SkinRegions, AValueThatIsNoRegionIsRefused)
{
  const auto skin = square();
  add_point_labels(skin, "region", {4, 4, 99, 0});
  expect_error([&] { (void)regions_of_skin(skin); }, {"skin.vtp", "99", "0 to 12", "segment.json"});
}

TEST(SkinRegions, SegmentTellsNamesAndAreas)
{
  const TriangleMesh skin = to_triangle_mesh(square());
  const auto told = regions_json(
      skin, {FaceRegion::Nose, FaceRegion::Nose, FaceRegion::Nose, FaceRegion::Chin}, {});
  EXPECT_EQ(told.at("names").at(9), "chin");
  EXPECT_EQ(told.at("names").size(), face_region_count);
  EXPECT_EQ(told.at("from"), "landmarks");
  EXPECT_NEAR(told.at("area_mm2").at("chin").get<double>(), 2.0 / 3, 1e-12);
  EXPECT_NEAR(told.at("area_mm2").at("nose").get<double>(), 4 - 2.0 / 3, 1e-12);
  EXPECT_NE(regions_note({"N", "Pg"}).find("N, Pg"), std::string::npos);
}

/// A case whose `segment` made all of a square the nose.
struct SegmentedSquare
{
  SegmentedSquare()
  {
    const auto skin = square();
    add_regions(skin, made);
    write_surface(folder / "skin.vtp", skin);
    const nlohmann::json areas = region_areas(to_triangle_mesh(skin), made);
    write_json(folder / "segment.json", {{"regions", {{made_area_key, areas}}}});
    write_json(folder / "case.json", settings("ct.nrrd"));
  }
  nlohmann::json settings(const char* ct) const
  {
    return {{"schema", "facetobone-case/1"},
            {"ct", (folder / ct).string()},
            {"osteotomies",
             {{{"fragment", "chin"},
               {"planes", {"plane.mrk.json"}},
               {"fragment_point_ras", {0, 0, 0}}}}},
            {"target", {{"mesh", "t.vtp"}}}};
  }
  void edit() const
  {
    const auto skin = read_surface(folder / "skin.vtp");
    add_regions(skin, {FaceRegion::Chin, FaceRegion::Nose, FaceRegion::Nose, FaceRegion::Nose});
    write_surface(folder / "skin.vtp", skin);
  }
  std::optional<std::vector<FaceRegion>> kept(const char* ct = "ct.nrrd") const
  {
    TriangleMesh skin = to_triangle_mesh(square());
    skin.points.push_back({1, 1, 50}); // far from all that was edited
    const CaseSession session(folder.path(), settings(ct), folder / "case.json");
    std::vector<FaceRegion> again = made;
    again.push_back(FaceRegion::Neck);
    return edited_regions(session, skin, again);
  }

  const TemporaryFolder folder;
  const std::vector<FaceRegion> made = std::vector<FaceRegion>(4, FaceRegion::Nose);
};

TEST(SkinRegions, ThatWereEditedOutliveANewSegmentation)
{
  const SegmentedSquare segmented;
  EXPECT_FALSE(segmented.kept()) << "nobody edited them";
  segmented.edit();
  const auto kept = segmented.kept();
  ASSERT_TRUE(kept);
  EXPECT_EQ(*kept, (std::vector<FaceRegion>{FaceRegion::Chin, FaceRegion::Nose, FaceRegion::Nose,
                                            FaceRegion::Nose, FaceRegion::Neck}));
  EXPECT_FALSE(segmented.kept("another.nrrd")) << "another patient's";
}

BoneMeeting meeting(double overlap_mm, double gap_mm)
{
  BoneMeeting m{"maxilla", "chin", {}, {}};
  m.overlap.depth_mm = overlap_mm;
  m.overlap.volume_mm3 = 100 * overlap_mm;
  m.gap.mean_mm = gap_mm;
  m.gap.max_mm = 2 * gap_mm;
  return m;
}

TEST(BoneWarnings, TellDeepOverlapsAndWideGapsOnly)
{
  EXPECT_TRUE(warnings_of({meeting(0.9, 2.9)}, 1).empty());
  const auto warnings = warnings_of({meeting(4.2, 0), meeting(0, 3.5)}, 1);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("'maxilla' runs into the moved 'chin', 4.2 mm deep"),
            std::string::npos)
      << warnings[0];
  EXPECT_NE(warnings[1].find("opens by 3.5 mm on average, 7.0 mm at most"), std::string::npos)
      << warnings[1];
}

} // namespace
} // namespace f2b
