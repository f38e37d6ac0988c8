#include "Core/error.hpp"
#include "Imaging/grey_values.hpp"
#include "Imaging/quiet_streams.hpp"
#include "Imaging/read_ct.hpp"
#include "Logic/Imaging/sphere_ct.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <cstring>
#include <functional>
#include <random>
#include <set>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;
using test::TemporaryFolder;

struct SeriesToWrite
{
  std::string prefix = "slice";
  std::string uid = "1.2.826.0.1.3680043.2.1125.1";
  std::string modality = "CT";
  std::set<unsigned> missing;
  unsigned slices = 20;
  std::string pixel_spacing = "2\\2";
  std::function<double(unsigned)> place = [](unsigned k) { return 2.0 * k; }; ///< along S [mm]
  double shift_per_slice = 0;                                                 ///< along P [mm]
  bool compressed = false;
  itk::GDCMImageIOEnums::Compression compression = itk::GDCMImageIOEnums::Compression::JPEG2000;
};

CtImage::Pointer sphere()
{
  test::SphereCt ct;
  ct.size = 40;
  ct.skin_radius = 16;
  ct.bone_radius = 9;
  ct.spacing[0] = ct.spacing[1] = ct.spacing[2] = 2.0;
  return ct.image();
}

void write_series(const fs::path& folder, const SeriesToWrite& series)
{
  const QuietStreams quiet;
  const auto ct = sphere();
  for (unsigned k = 0; k < series.slices; ++k)
  {
    if (series.missing.count(k))
      continue;
    auto io = itk::GDCMImageIO::New();
    io->KeepOriginalUIDOn();
    itk::MetaDataDictionary tags;
    auto put = [&](const char* key, const std::string& value)
    { itk::EncapsulateMetaData<std::string>(tags, key, value); };
    put("0008|0060", series.modality);
    put("0008|103e", "Series " + series.prefix);
    put("0020|000e", series.uid);
    put("0020|000d", "1.2.826.0.1.3680043.2.1125.9");
    put("0008|0018", series.uid + "." + std::to_string(k + 1));
    put("0020|0013", std::to_string(k + 1));
    io->SetMetaDataDictionary(tags);
    io->SetNumberOfDimensions(3);
    for (unsigned a = 0; a < 3; ++a)
    {
      io->SetDimensions(a, a < 2 ? 20 : 1);
      io->SetSpacing(a, 2.0);
      io->SetOrigin(a, ct->GetOrigin()[a] + (a == 2   ? series.place(k)
                                             : a == 1 ? series.shift_per_slice * k
                                                      : 0.0));
    }
    io->SetPixelType(itk::IOPixelEnum::SCALAR);
    io->SetComponentType(itk::IOComponentEnum::SHORT);
    io->SetNumberOfComponents(1);
    itk::ImageIORegion region(3);
    region.SetSize(0, 20);
    region.SetSize(1, 20);
    region.SetSize(2, 1);
    io->SetIORegion(region);
    // Names that sort against the order of the slices.
    const std::string name = series.prefix + " " + std::to_string(90 - k) + ".dcm";
    io->SetFileName((folder / name).string());
    io->SetUseCompression(series.compressed);
    io->SetCompressionType(series.compression);
    io->WriteImageInformation();
    io->Write(ct->GetBufferPointer() + k * 400);
  }
}

void expect_message(const fs::path& path, const std::vector<std::string>& parts)
{
  testing::internal::CaptureStderr();
  std::string message = "no error";
  try
  {
    read_ct(path);
  }
  catch (const Error& error)
  {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(DicomSeries, ReadsSlicesInOrderFromAFolderOrOneOfItsFiles)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {});
  folder.write("readme.txt", "not an image");
  const auto expected = sphere();
  for (const fs::path& path : {folder.path(), folder / "slice 85.dcm"})
  {
    const auto ct = read_ct(path);
    ASSERT_EQ(ct->GetBufferedRegion().GetSize(), expected->GetBufferedRegion().GetSize());
    EXPECT_EQ(std::memcmp(ct->GetBufferPointer(), expected->GetBufferPointer(), 2 * 8000), 0);
    for (unsigned a = 0; a < 3; ++a)
    {
      EXPECT_NEAR(ct->GetSpacing()[a], 2.0, 1e-9);
      EXPECT_NEAR(ct->GetOrigin()[a], expected->GetOrigin()[a], 1e-6);
    }
  }
}

TEST(DicomSeries, RefusesFoldersWithoutImages)
{
  const TemporaryFolder folder;
  expect_message(folder.path(), {"empty folder", folder.path().filename().string()});
  folder.write("readme.txt", "not an image");
  expect_message(folder.path(), {"no DICOM images"});
}

TEST(DicomSeries, RefusesTwoSeriesAndListsThem)
{
  const TemporaryFolder folder;
  SeriesToWrite second;
  second.prefix = "other";
  second.uid = "1.2.826.0.1.3680043.2.1125.2";
  write_series(folder.path(), {});
  write_series(folder.path(), second);
  expect_message(folder.path(), {"2 DICOM series", "Series slice", "Series other",
                                 "1.2.826.0.1.3680043.2.1125.2, 20 slices", "--series"});
}

TEST(DicomSeries, LeavesOutALocaliserWithANote)
{
  const TemporaryFolder folder;
  SeriesToWrite localiser;
  localiser.prefix = "scout";
  localiser.uid = "1.2.826.0.1.3680043.2.1125.3";
  localiser.slices = 2;
  write_series(folder.path(), {});
  write_series(folder.path(), localiser);
  std::vector<std::string> notes;
  const auto ct = read_ct(folder.path(), &notes);
  EXPECT_EQ(ct->GetBufferedRegion().GetSize()[2], 20U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("Series scout"), std::string::npos) << notes[0];
}

TEST(DicomSeries, RefusesMissingSlices)
{
  const TemporaryFolder folder;
  SeriesToWrite series;
  series.missing = {7};
  write_series(folder.path(), series);
  expect_message(folder.path(), {"missing", "4 mm between slice 84.dcm and slice 82.dcm", "2 mm"});
}

TEST(DicomSeries, TakesARepeatedSliceOnceAndRefusesTwoThatDiffer)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {});
  fs::copy(folder / "slice 80.dcm", folder / "copy.dcm");
  std::vector<std::string> notes;
  EXPECT_EQ(read_ct(folder.path(), &notes)->GetBufferedRegion().GetSize()[2], 20U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("repeated slices: "), std::string::npos) << notes[0];
  EXPECT_TRUE(notes[0].find("slice 80.dcm") != std::string::npos ||
              notes[0].find("copy.dcm") != std::string::npos)
      << notes[0];
  SeriesToWrite other;
  other.prefix = "other";
  other.place = [](unsigned k) { return 2.0 * ((k + 3) % 20); };
  other.missing = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
  write_series(folder.path(), other);
  expect_message(folder.path(), {"two different slices at one position", "other 71.dcm"});
}

TEST(DicomSeries, ReadsTheNamedOneOfSeveral)
{
  const TemporaryFolder folder;
  SeriesToWrite second;
  second.prefix = "other";
  second.uid = "1.2.826.0.1.3680043.2.1125.2";
  second.slices = 18;
  write_series(folder.path(), {});
  write_series(folder.path(), second);
  for (const char* name : {"2", "1.2.826.0.1.3680043.2.1125.2", "Series other"})
  {
    std::vector<std::string> notes;
    const auto ct = read_ct(folder.path(), &notes, {name, false});
    EXPECT_EQ(ct->GetBufferedRegion().GetSize()[2], 18U) << name;
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("Left out another DICOM series: 'Series slice'"), std::string::npos);
  }
  try
  {
    read_ct(folder.path(), nullptr, {"7", false});
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("0 are '7'"), std::string::npos) << error.what();
  }
}

TEST(DicomSeries, ShiftedSlicesOfATiltedGantryAreStraightened)
{
  const TemporaryFolder folder;
  SeriesToWrite series;
  series.shift_per_slice = 0.4; // 11 degrees
  write_series(folder.path(), series);
  std::vector<std::string> notes;
  const auto ct = read_ct(folder.path(), &notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("tilted gantry"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("11.3"), std::string::npos) << notes[0];
  const auto size = ct->GetBufferedRegion().GetSize();
  EXPECT_EQ(size[0], 20U);
  EXPECT_EQ(size[1], 24U) << "19 slices times 0.4 mm";
  EXPECT_EQ(size[2], 20U);
  // every fifth slice is shifted by a whole voxel: it is found in the place that its file states
  for (const int k : {0, 5, 10, 15})
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i)
      {
        const CtImage::IndexType from{{i, j, k}}, to{{i, j + k / 5, k}};
        ASSERT_EQ(ct->GetPixel(to), sphere()->GetPixel(from)) << i << ' ' << j << ' ' << k;
      }
  const CtImage::IndexType outside{{0, 23, 0}};
  EXPECT_EQ(ct->GetPixel(outside), -1024);
}

TEST(DicomSeries, UnevenSlicesAreInterpolated)
{
  const TemporaryFolder folder;
  SeriesToWrite series;
  series.place = [](unsigned k) { return 2.0 * k + (k == 7 ? 0.5 : 0.0); };
  write_series(folder.path(), series);
  std::vector<std::string> notes;
  const auto ct = read_ct(folder.path(), &notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("unevenly spaced (1.5 to 2.5 mm"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("slice 84.dcm and slice 83.dcm"), std::string::npos) << notes[0];
  EXPECT_EQ(ct->GetBufferedRegion().GetSize()[2], 20U);
  // slice 7 was taken 0.5 mm too far: what is at its even place is a fifth of the slice before
  const auto even = sphere();
  for (int i = 0; i < 20; ++i)
  {
    const CtImage::IndexType before{{i, 10, 6}}, at{{i, 10, 7}}, untouched{{i, 10, 12}};
    EXPECT_NEAR(ct->GetPixel(at), 0.2 * even->GetPixel(before) + 0.8 * even->GetPixel(at), 1);
    EXPECT_EQ(ct->GetPixel(untouched), even->GetPixel(untouched));
  }
}

TEST(DicomSeries, CompressedSlicesAreTheSame)
{
  // ITK writes these; GDCM reads more
  for (const auto compression :
       {itk::GDCMImageIOEnums::Compression::JPEG2000, itk::GDCMImageIOEnums::Compression::JPEG})
  {
    const TemporaryFolder folder;
    SeriesToWrite series;
    series.compressed = true;
    series.compression = compression;
    write_series(folder.path(), series);
    const auto ct = read_ct(folder.path());
    EXPECT_EQ(std::memcmp(ct->GetBufferPointer(), sphere()->GetBufferPointer(), 2 * 8000), 0)
        << int(compression);
  }
}

TEST(DicomSeries, UnreadableSliceIsNamedWhereItIsMissing)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {});
  // a DICOM preamble and nothing after it
  test::cut_off(folder / "slice 80.dcm", 140);
  expect_message(folder.path(), {"slice 80.dcm"});
}

TEST(GreyValues, OfAConeBeamBecomeHounsfieldUnits)
{
  const TemporaryFolder folder;
  const auto ct = sphere();
  short* voxels = ct->GetBufferPointer();
  std::vector<short> before(voxels, voxels + 8000);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 20);
  for (std::size_t v = 0; v < 8000; ++v)
    voxels[v] = static_cast<short>(0.6 * before[v] + 700 + noise(random));
  const std::string note = to_hounsfield(*ct, "cone beam");
  EXPECT_NE(note.find("(soft tissue)"), std::string::npos);
  double sum = 0;
  for (std::size_t v = 0; v < 8000; ++v)
    sum += std::abs(std::max(-1024.0, double(voxels[v])) - before[v]);
  EXPECT_LT(sum / 8000, 60) << note;
  std::fill(voxels, voxels + 8000, short(3));
  EXPECT_THROW(to_hounsfield(*ct, "flat"), Error);
}

TEST(DicomSeries, RefusesAnotherModality)
{
  const TemporaryFolder folder;
  SeriesToWrite series;
  series.modality = "MR";
  write_series(folder.path(), series);
  expect_message(folder.path(), {"modality is 'MR'"});
}

TEST(DicomSeries, RefusesASingleSlice)
{
  const TemporaryFolder folder;
  SeriesToWrite series;
  series.slices = 1;
  write_series(folder.path(), series);
  expect_message(folder.path(), {"20 x 20 x 1 voxels"});
}

TEST(DicomSeries, RefusesATruncatedSlice)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {});
  test::cut_off(folder / "slice 80.dcm", 300);
  expect_message(folder.path(), {"truncated", "slice 80.dcm"});
}

} // namespace
} // namespace f2b
