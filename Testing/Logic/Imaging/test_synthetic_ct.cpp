#include "temporary_folder.hpp"
#include <Core/error.hpp>
#include <Imaging/read_ct.hpp>
#include <Imaging/synthetic_ct.hpp>
#include <Imaging/write_ct.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using f2b::CtImage;
using f2b::Vec3;

const f2b::VirtualPatient& patient()
{
  static const f2b::VirtualPatient instance;
  return instance;
}

f2b::SyntheticCtOptions coarse()
{
  f2b::SyntheticCtOptions options;
  options.spacing_mm = Vec3(4, 4, 4);
  options.lower_ras = Vec3(-60, 10, -110);
  options.upper_ras = Vec3(60, 120, 10);
  return options;
}

std::vector<short> voxels(const CtImage& image)
{
  const short* first = image.GetBufferPointer();
  return {first, first + image.GetBufferedRegion().GetNumberOfPixels()};
}

/// HU of the voxel nearest to a point in RAS.
short hounsfield(const CtImage& image, const Vec3& ras)
{
  CtImage::PointType lps;
  lps[0] = -ras.x();
  lps[1] = -ras.y();
  lps[2] = ras.z();
  CtImage::IndexType index;
  EXPECT_TRUE(image.TransformPhysicalPointToIndex(lps, index));
  return image.GetPixel(index);
}

TEST(SyntheticCtTest, TissuesLieWhereThePatientHasThem)
{
  f2b::SyntheticCtOptions options;
  options.lower_ras = Vec3(0, 40, -110);
  options.upper_ras = Vec3(40, 118, 56);
  options.spacing_mm = Vec3(1, 1.5, 2);
  options.noise_sd_hu = 0;
  const auto image = f2b::synthesize_ct(patient(), options);
  EXPECT_LT(hounsfield(*image, {0, 115, 20}), -990) << "air before the face";
  EXPECT_NEAR(hounsfield(*image, {10, 45, 50}), 35, 1) << "brain";
  const Vec3 crown = patient().landmark("U6_R") + Vec3(0, 0, 4);
  EXPECT_GT(hounsfield(*image, crown), 1700) << "tooth";
  EXPECT_GT(hounsfield(*image, patient().landmark("Pg") - Vec3(0, 3, 0)), 300) << "bone";
}

TEST(SyntheticCtTest, StaysInTheRangeOfAScanner)
{
  auto options = coarse();
  options.streaks = options.head_rest = true;
  const auto hu = voxels(*f2b::synthesize_ct(patient(), options));
  const auto [least, most] = std::minmax_element(hu.begin(), hu.end());
  EXPECT_GE(*least, -1024);
  EXPECT_LE(*most, 3071);
  EXPECT_GT(*most, 1500);
}

TEST(SyntheticCtTest, SeedDecidesTheNoiseAndThreadsDoNot)
{
  auto options = coarse();
  options.streaks = options.head_rest = true;
  options.threads = 1;
  const auto one = voxels(*f2b::synthesize_ct(patient(), options));
  options.threads = 3;
  EXPECT_EQ(one, voxels(*f2b::synthesize_ct(patient(), options)));
  options.seed = 2;
  EXPECT_NE(one, voxels(*f2b::synthesize_ct(patient(), options)));
}

TEST(SyntheticCtTest, NoiseHasTheStatedDeviation)
{
  auto options = coarse();
  const auto noisy = voxels(*f2b::synthesize_ct(patient(), options));
  options.noise_sd_hu = 0;
  const auto clean = voxels(*f2b::synthesize_ct(patient(), options));
  double sum = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < clean.size(); ++i)
    if (clean[i] > -900)
    {
      const double difference = noisy[i] - clean[i];
      sum += difference;
      squares += difference * difference;
      ++count;
    }
  EXPECT_NEAR(sum / count, 0, 0.5);
  EXPECT_NEAR(std::sqrt(squares / count), 12, 0.5);
}

TEST(SyntheticCtTest, StreaksCrossTheCheeksAndTheHeadRestTouchesTheHead)
{
  auto options = coarse();
  options.spacing_mm = Vec3(2, 2, 2);
  options.lower_ras = Vec3(-80, -118, -78);
  options.upper_ras = Vec3(80, 100, -66);
  options.noise_sd_hu = 0;
  const auto clean = voxels(*f2b::synthesize_ct(patient(), options));
  options.streaks = true;
  const auto streaked = voxels(*f2b::synthesize_ct(patient(), options));
  int altered = 0;
  for (std::size_t i = 0; i < clean.size(); ++i)
    altered += std::abs(streaked[i] - clean[i]) > 100;
  EXPECT_GT(altered, 1000);

  options.lower_ras = Vec3(-20, -118, 20);
  options.upper_ras = Vec3(20, -80, 50);
  options.streaks = false;
  options.head_rest = true;
  const auto image = f2b::synthesize_ct(patient(), options);
  for (double a = -108; a < -82; a += 2)
    EXPECT_GT(hounsfield(*image, {0, a, 34}), -400) << "no air between pad and head at A " << a;
}

TEST(SyntheticCtTest, LatticeIsLpsWithTheAskedSpacing)
{
  auto options = coarse();
  options.spacing_mm = Vec3(4, 5, 3);
  const auto image = f2b::synthesize_ct(patient(), options);
  EXPECT_EQ(image->GetSpacing()[1], 5);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[0], -options.upper_ras.x());
  EXPECT_DOUBLE_EQ(image->GetOrigin()[1], -options.upper_ras.y());
  EXPECT_DOUBLE_EQ(image->GetOrigin()[2], options.lower_ras.z());
}

TEST(SyntheticCtTest, SurvivesNrrd)
{
  const auto image = f2b::synthesize_ct(patient(), coarse());
  const f2b::test::TemporaryFolder folder;
  f2b::write_ct(*image, folder / "ct.nrrd");
  const auto copy = f2b::read_ct(folder / "ct.nrrd");
  EXPECT_EQ(voxels(*copy), voxels(*image));
  EXPECT_EQ(copy->GetOrigin(), image->GetOrigin());
}

TEST(SyntheticCtTest, RefusesOptionsOutOfRange)
{
  auto options = coarse();
  options.spacing_mm.z() = 0;
  EXPECT_THROW(f2b::synthesize_ct(patient(), options), f2b::Error);
  options = coarse();
  options.noise_sd_hu = std::nan("");
  EXPECT_THROW(f2b::synthesize_ct(patient(), options), f2b::Error);
}

} // namespace
