#include "Core/error.hpp"
#include "Imaging/quiet_streams.hpp"
#include "Imaging/read_ct.hpp"
#include "Logic/Imaging/sphere_ct.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <cstring>
#include <functional>
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
      io->SetOrigin(a, ct->GetOrigin()[a] + (a == 2 ? 2.0 * k : 0.0));
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
                                 "1.2.826.0.1.3680043.2.1125.2, 20 slices", "one series"});
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

TEST(DicomSeries, RefusesRepeatedSlices)
{
  const TemporaryFolder folder;
  write_series(folder.path(), {});
  fs::copy(folder / "slice 80.dcm", folder / "copy.dcm");
  expect_message(folder.path(), {"one position", "copy.dcm"});
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
