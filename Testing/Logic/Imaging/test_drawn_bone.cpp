#include "Core/error.hpp"
#include "Imaging/geodesic_contour.hpp"
#include "Imaging/label_edits.hpp"
#include "Imaging/segment_head.hpp"
#include "Logic/Imaging/sphere_ct.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace f2b
{
namespace
{

using test::TemporaryFolder;

ScalarGrid ball_distance(double radius)
{
  ScalarGrid grid;
  grid.origin = Vec3::Constant(-20);
  grid.size = {41, 41, 41};
  for (int k = 0; k < 41; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i)
        grid.values.push_back(static_cast<float>(grid.position(i, j, k).norm() - radius));
  return grid;
}

double volume_below_zero(const ScalarGrid& grid)
{
  return static_cast<double>(
      std::count_if(grid.values.begin(), grid.values.end(), [](float v) { return v < 0; }));
}

/// A NRRD of bytes whose axes are LPS; values by place in RAS.
template <class Value>
std::filesystem::path write_labels(const TemporaryFolder& folder, const std::string& name,
                                   const std::string& extra, Value value)
{
  std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\n"
                     "sizes: 41 41 41\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain "
                     "domain domain\nendian: little\nencoding: raw\nspace origin: (-20,-20,-20)\n" +
                     extra + "\n";
  for (int k = 0; k < 41; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i)
        text += static_cast<char>(value(Vec3(20 - i, 20 - j, k - 20)));
  const std::filesystem::path file = folder.path() / name;
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

TEST(LabelEdits, OwnLabelsAddAndTakeAwayBone)
{
  const TemporaryFolder folder;
  // the ball of 10 mm, a box drawn on at the patient's right, its top taken away
  const auto file = write_labels(folder, "labels.nrrd", "",
                                 [](const Vec3& p)
                                 {
                                   const bool box =
                                       p.x() > 8 && p.x() < 16 && p.tail<2>().norm() < 5;
                                   const bool bone = (p.norm() < 10 || box) && p.z() < 6;
                                   return bone ? 4 : p.norm() < 18 ? 3 : 0;
                                 });
  const LabelEdits edits = read_label_edits(file);
  ScalarGrid bone = ball_distance(10);
  EXPECT_GT(apply_edits(bone, edits.bone), 300U);
  EXPECT_LT(bone.value({14, 0, 0}), -0.5) << "drawn on, at +R";
  EXPECT_GT(bone.value({-14, 0, 0}), 2);
  EXPECT_GT(bone.value({0, 0, 8}), 1) << "taken away";
  EXPECT_NEAR(bone.value({0, 0, -9}), -1, 0.15) << "untouched places keep their distance";
  ScalarGrid skin = ball_distance(18);
  EXPECT_EQ(apply_edits(skin, edits.head), 0U) << "as it was found";
}

TEST(LabelEdits, SlicersSegmentsCountByTheirNames)
{
  const TemporaryFolder folder;
  const std::string names = "Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Name:=Mandible\n"
                            "Segment1_ID:=b\nSegment1_LabelValue:=2\nSegment1_Name:=Airway\n";
  const auto value = [](const Vec3& p) { return p.norm() < 8 ? 1 : p.norm() < 12 ? 2 : 0; };
  const LabelEdits edits = read_label_edits(write_labels(folder, "s.seg.nrrd", names, value));
  ASSERT_EQ(edits.notes.size(), 2U);
  EXPECT_NE(edits.notes[0].find("'Mandible' counts as bone"), std::string::npos);
  EXPECT_NE(edits.notes[1].find("'Airway' counts as nothing"), std::string::npos);
  EXPECT_EQ(edits.bone({0, 0, 0}), Drawn::Is);
  EXPECT_EQ(edits.bone({10, 0, 0}), Drawn::Not);
  EXPECT_EQ(edits.bone({30, 0, 0}), Drawn::Unsaid) << "outside the label map";
  EXPECT_EQ(edits.head({0, 0, 0}), Drawn::Unsaid) << "bone alone does not say where the skin is";
  ScalarGrid bone = ball_distance(10);
  EXPECT_GT(apply_edits(bone, edits.bone), 1000U);
  EXPECT_NEAR(volume_below_zero(bone), volume_below_zero(ball_distance(8)), 200);
}

TEST(LabelEdits, NamelessSegmentsAreRefused)
{
  const TemporaryFolder folder;
  const auto file =
      write_labels(folder, "x.seg.nrrd", "Segment0_LabelValue:=1\nSegment0_Name:=Segment_1\n",
                   [](const Vec3&) { return 1; });
  EXPECT_THROW(read_label_edits(file), Error);
}

/// A thick ball of bone with a thin plate on it, in soft tissue, blurred and noisy.
struct Degraded
{
  std::array<int, 3> size{41, 41, 41};
  std::vector<float> clean, noisy;
  std::vector<char> truth;

  Degraded()
  {
    std::vector<float> sharp;
    const ScalarGrid lattice = ball_distance(10);
    for (int k = 0; k < 41; ++k)
      for (int j = 0; j < 41; ++j)
        for (int i = 0; i < 41; ++i)
        {
          const Vec3 p = lattice.position(i, j, k);
          const bool bone = p.norm() < 10 || (std::abs(p.z()) < 1.1 && p.head<2>().norm() < 17);
          truth.push_back(bone);
          sharp.push_back(bone ? 900.0F : 50.0F);
        }
    clean = blurred(size, 1, sharp, 0.7);
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0, 250);
    for (const float v : clean)
      noisy.push_back(v + noise(random));
  }

  template <class Inside>
  double dice(Inside inside) const
  {
    double both = 0, sum = 0;
    for (std::size_t s = 0; s < truth.size(); ++s)
    {
      both += truth[s] && inside(s);
      sum += truth[s] + inside(s);
    }
    return 2 * both / sum;
  }
};

TEST(GeodesicContour, BeatsTheThresholdInNoiseAndBlur)
{
  const Degraded ct;
  const double by_threshold = ct.dice([&](std::size_t s) { return ct.noisy[s] > 475; });
  std::vector<float> start = blurred(ct.size, 1, ct.noisy, 0.8);
  for (float& v : start)
    v = std::clamp((350 - v) / 200, -3.0F, 3.0F);
  const std::vector<float> front = geodesic_contour(ct.size, 1, ct.noisy, start, {});
  const double by_contour = ct.dice([&](std::size_t s) { return front[s] < 0; });
  std::cout << "Dice: threshold " << by_threshold << ", level set " << by_contour << '\n';
  RecordProperty("dice_threshold", std::to_string(by_threshold));
  RecordProperty("dice_level_set", std::to_string(by_contour));
  EXPECT_GT(by_contour, by_threshold + 0.02);
  EXPECT_GT(by_contour, 0.85);
}

} // namespace
} // namespace f2b
