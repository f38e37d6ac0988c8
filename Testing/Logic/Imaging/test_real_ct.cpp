#include "Imaging/read_ct.hpp"
#include "Imaging/resample_ct.hpp"
#include "Imaging/segment_head.hpp"
#include "Imaging/signed_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

fs::path data_folder()
{
  const char* given = std::getenv("FACETOBONE_DATA");
  return given ? given : FACETOBONE_DATA_DEFAULT;
}

/// Crossings of the zero level with the grid's edges along A inside a box.
std::vector<Vec3> surface_points(const ScalarGrid& distance, const Box& box)
{
  std::vector<Vec3> points;
  for (int k = 0; k < distance.size.z(); ++k)
    for (int j = 0; j + 1 < distance.size.y(); ++j)
      for (int i = 0; i < distance.size.x(); ++i)
      {
        const double a = distance.values[distance.index(i, j, k)];
        const double b = distance.values[distance.index(i, j + 1, k)];
        if ((a < 0) == (b < 0))
          continue;
        const Vec3 p = distance.position(i, j, k) + Vec3(0, distance.spacing * a / (a - b), 0);
        if ((p.array() > box.min.array()).all() && (p.array() < box.max.array()).all())
          points.push_back(p);
      }
  return points;
}

double percentile(std::vector<double> values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void expect_faithful_skin(const HeadSegmentation& found)
{
  ScalarGrid level = found.hu;
  for (float& v : level.values)
    v = static_cast<float>(found.skin_threshold_hu) - v;
  const ScalarGrid grey = signed_distance(level);
  std::vector<double> off, slope;
  // Without the ears, whose folds the closing fills.
  Box face = found.region_ras;
  face.min += Vec3(25, 40, 10);
  face.max.x() -= 25;
  for (const Vec3& p : surface_points(found.skin, face))
  {
    off.push_back(std::abs(grey.value(p)));
    slope.push_back(std::abs(found.skin.gradient(p).norm() - 1.0));
  }
  ASSERT_GT(off.size(), 10000U);
  std::cout << "skin to grey-value isosurface: median " << percentile(off, 0.5) << " p90 "
            << percentile(off, 0.9) << " p95 " << percentile(off, 0.95) << " p99 "
            << percentile(off, 0.99) << " mm; |gradient - 1|: p95 " << percentile(slope, 0.95)
            << "\n";
  EXPECT_LT(percentile(off, 0.5), 0.05);
  EXPECT_LT(percentile(off, 0.9), 0.5);
  EXPECT_LT(percentile(slope, 0.95), 0.2);
}

/// Share of the samples with a label among those of the region.
double share(const HeadSegmentation& found, HeadLabel label)
{
  const auto count = std::count(found.labels.values.begin(), found.labels.values.end(),
                                static_cast<unsigned char>(label));
  return static_cast<double>(count) / static_cast<double>(found.labels.values.size());
}

TEST(RealCt, CadaverHeadGivesFaceAndSkull)
{
  const fs::path file = data_folder() / "cthead_unc" / "ct.nrrd";
  if (!fs::exists(file))
    GTEST_SKIP() << "no " << file << "; set FACETOBONE_DATA";
  const HeadSegmentation found = segment_head(*read_ct(file));
  EXPECT_NEAR(found.skin_threshold_hu, -210, 60);
  EXPECT_NEAR(found.bone_threshold_hu, 220, 60);
  expect_faithful_skin(found);
  EXPECT_GT(share(found, HeadLabel::Bone), 0.05);
  EXPECT_GT(share(found, HeadLabel::Fat), 0.005);
  EXPECT_GT(share(found, HeadLabel::Muscle), 0.05);
}

TEST(RealCt, PhantomWithCouchAndShouldersGivesTheHead)
{
  const fs::path folder = data_folder() / "phantom_imagex" / "dicom";
  if (!fs::exists(folder))
    GTEST_SKIP() << "no " << folder << "; set FACETOBONE_DATA";
  const CtImage::Pointer ct = read_ct(folder);
  EXPECT_EQ(ct->GetBufferedRegion().GetSize()[2], 209U);
  const HeadSegmentation found = segment_head(*ct);
  expect_faithful_skin(found);
  // The head alone: neither the couch (400 mm wide) nor the shoulders.
  EXPECT_LT(found.region_ras.max.x() - found.region_ras.min.x(), 220);
  EXPECT_GT(found.region_ras.min.z(), 250);
}

TEST(RealCt, LabelsOfASegmentationAreNoCt)
{
  const fs::path file = data_folder() / "seg_dental" / "PostDentalSurgery_Segmentation.nii.gz";
  if (!fs::exists(file))
    GTEST_SKIP() << "no " << file << "; set FACETOBONE_DATA";
  EXPECT_ANY_THROW(read_ct(file));
}

} // namespace
} // namespace f2b
