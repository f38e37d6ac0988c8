#include "Core/error.hpp"
#include "Imaging/read_ct.hpp"
#include "Logic/Imaging/sphere_ct.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <cstdint>
#include <cstring>
#include <limits>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;
using test::SphereCt;
using test::TemporaryFolder;

SphereCt small_sphere()
{
  SphereCt sphere;
  sphere.size = 40;
  sphere.skin_radius = 16;
  sphere.bone_radius = 9;
  return sphere;
}

itk::ImageIOBase::Pointer io_for(const fs::path& file)
{
  if (file.extension() == ".nrrd")
    return itk::NrrdImageIO::New().GetPointer();
  if (file.extension() == ".mha")
    return itk::MetaImageIO::New().GetPointer();
  return itk::NiftiImageIO::New().GetPointer();
}

template <class Image>
fs::path write_image(const Image* image, const fs::path& file, bool packed)
{
  auto writer = itk::ImageFileWriter<Image>::New();
  const auto io = io_for(file);
  writer->SetImageIO(io);
  writer->SetInput(image);
  writer->SetFileName(file.string());
  writer->SetUseCompression(packed);
  writer->Update();
  return file;
}

template <class Voxel>
typename itk::Image<Voxel, 3>::Pointer converted(const CtImage& ct)
{
  auto image = itk::Image<Voxel, 3>::New();
  image->CopyInformation(&ct);
  image->SetRegions(ct.GetBufferedRegion());
  image->Allocate();
  const std::size_t count = ct.GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t v = 0; v < count; ++v)
    image->GetBufferPointer()[v] = static_cast<Voxel>(ct.GetBufferPointer()[v]);
  return image;
}

/// The one-line error of reading; also checks that it names the file and stays off the terminal.
std::string message_of(const fs::path& file)
{
  testing::internal::CaptureStderr();
  std::string message = "no error";
  try
  {
    read_ct(file);
  }
  catch (const Error& error)
  {
    message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_NE(message.find(file.filename().string()), std::string::npos) << message;
  EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
  return message;
}

void expect_message(const fs::path& file, const std::string& part)
{
  const std::string message = message_of(file);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

std::string nrrd(const std::string& geometry)
{
  return "NRRD0005\ntype: int16\ndimension: 3\nsizes: 20 20 20\n" + geometry +
         "endian: little\nencoding: raw\n\n" + std::string(16000, '\0');
}

std::string meta_image(const std::string& matrix, const std::string& spacing)
{
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nTransformMatrix = " +
         matrix + "\nOffset = 0 0 0\nElementSpacing = " + spacing +
         "\nDimSize = 20 20 20\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
         std::string(16000, '\0');
}

/// Replaces the voxel size along the third axis of a NIfTI-1 file.
void set_nifti_spacing(const fs::path& file, float spacing)
{
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(76 + 3 * 4);
  stream.write(reinterpret_cast<const char*>(&spacing), sizeof spacing);
}

class EveryFormat : public testing::TestWithParam<const char*>
{
};

TEST_P(EveryFormat, ReadsBackTheVolume)
{
  const TemporaryFolder folder;
  const auto ct = small_sphere().image();
  for (const bool packed : {false, true})
  {
    const auto read = read_ct(write_image(ct.GetPointer(), folder / GetParam(), packed));
    ASSERT_EQ(read->GetBufferedRegion().GetSize(), ct->GetBufferedRegion().GetSize());
    EXPECT_EQ(std::memcmp(read->GetBufferPointer(), ct->GetBufferPointer(), 2 * 40 * 40 * 40), 0);
    for (unsigned a = 0; a < 3; ++a)
      EXPECT_NEAR(read->GetOrigin()[a], ct->GetOrigin()[a], 1e-4);
  }
}

TEST_P(EveryFormat, RefusesATruncatedVolume)
{
  const TemporaryFolder folder;
  const auto ct = small_sphere().image();
  for (const bool packed : {false, true})
  {
    const fs::path file = write_image(ct.GetPointer(), folder / GetParam(), packed);
    test::cut_off(file, fs::file_size(file) / 3);
    expect_message(file, "truncated");
  }
}

TEST_P(EveryFormat, RefusesEightBitVoxels)
{
  const TemporaryFolder folder;
  const auto image = converted<unsigned char>(*small_sphere().image());
  expect_message(write_image(image.GetPointer(), folder / GetParam(), false), "8-bit");
}

TEST_P(EveryFormat, RefusesNaNVoxels)
{
  const TemporaryFolder folder;
  const auto image = converted<float>(*small_sphere().image());
  image->GetBufferPointer()[777] = std::numeric_limits<float>::quiet_NaN();
  expect_message(write_image(image.GetPointer(), folder / GetParam(), false), "voxel 777 is");
}

TEST_P(EveryFormat, RoundsFloatVoxels)
{
  const TemporaryFolder folder;
  const auto image = converted<float>(*small_sphere().image());
  image->GetBufferPointer()[5] = -999.6F;
  const auto read = read_ct(write_image(image.GetPointer(), folder / GetParam(), false));
  EXPECT_EQ(read->GetBufferPointer()[5], -1000);
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat,
                         testing::Values("kopf größe.nrrd", "head.mha", "head.nii", "head.nii.gz"));

TEST(BadVolume, RefusesAMissingFile)
{
  expect_message("/nowhere/at all.nrrd", "does not exist");
}

TEST(BadVolume, RefusesAnUnknownFormat)
{
  const TemporaryFolder folder;
  expect_message(folder.write("head.stl", "solid"), "known image format");
}

TEST(BadVolume, RefusesGarbageWithTheRightName)
{
  const TemporaryFolder folder;
  expect_message(folder.write("a.nrrd", "not a volume"), "cannot be read");
  expect_message(folder.write("a.mha", "not a volume"), "cannot be read");
  expect_message(folder.write("a.nii", std::string(400, 'x')), "not a NIfTI");
  expect_message(folder.write("b.nii", "short"), "truncated");
}

TEST(BadVolume, RefusesASpacingThatIsNotPositive)
{
  const TemporaryFolder folder;
  const std::string identity = "1 0 0 0 1 0 0 0 1";
  for (const std::string value : {"0", "nan"})
  {
    const std::string part = "spacing along axis 3 is " + value;
    expect_message(folder.write("s.nrrd", nrrd("spacings: 1 1 " + value + "\n")), part);
    expect_message(folder.write("d.nrrd", nrrd("space: left-posterior-superior\nspace directions: "
                                               "(1,0,0) (0,1,0) (0,0," +
                                               value + ")\n")),
                   part);
    expect_message(folder.write("s.mha", meta_image(identity, "1 1 " + value)), part);
    const fs::path nifti =
        write_image(small_sphere().image().GetPointer(), folder / "s.nii", false);
    set_nifti_spacing(nifti, std::stof(value));
    expect_message(nifti, part);
  }
  expect_message(folder.write("n.nrrd", nrrd("spacings: 1 1 -2\n")), "axis 3 is -2 mm");
  expect_message(folder.write("n.mha", meta_image(identity, "1 1 -2")), "axis 3 is -2 mm");
}

TEST(BadVolume, RefusesASkewedLattice)
{
  const TemporaryFolder folder;
  expect_message(folder.write("s.nrrd", nrrd("space: left-posterior-superior\nspace directions: "
                                             "(1,0,0) (0.5,1,0) (0,0,1)\n")),
                 "right angles");
  expect_message(folder.write("s.mha", meta_image("1 0 0 0.5 1 0 0 0 1", "1 1 1")), "right angles");
}

TEST(BadVolume, RefusesASingleSlice)
{
  const TemporaryFolder folder;
  SphereCt sphere = small_sphere();
  sphere.spacing[2] = 40.0;
  expect_message(write_image(sphere.image().GetPointer(), folder / "one.nrrd", false),
                 "40 x 40 x 1 voxels");
}

TEST(BadVolume, RefusesAnMrAndARescaledCt)
{
  const TemporaryFolder folder;
  const auto ct = small_sphere().image();
  short* voxels = ct->GetBufferPointer();
  for (int v = 0; v < 40 * 40 * 40; ++v)
    voxels[v] = static_cast<short>(std::max(0, voxels[v] + 1000));
  expect_message(write_image(ct.GetPointer(), folder / "mr.nrrd", false),
                 "does not look like a CT");
  for (int v = 0; v < 40 * 40 * 40; ++v)
    voxels[v] = static_cast<short>(std::min(150, voxels[v] - 1000));
  expect_message(write_image(ct.GetPointer(), folder / "no bone.nrrd", false), "200 HU (bone)");
}

} // namespace
} // namespace f2b
